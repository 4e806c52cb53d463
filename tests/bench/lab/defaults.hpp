#pragma once
#include "sim/thread/thread.hpp"

namespace bench::lab {

/// What a case has where it is about something else: a drill's tick [s], and the thread that is made where nothing is
/// said [m].
inline constexpr double default_tick = 1e-3;
inline constexpr double default_radius = sim::thread::ThreadDef{}.radius, default_diameter = 2 * default_radius;

}  // namespace bench::lab
