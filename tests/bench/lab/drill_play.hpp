#pragma once
#include "tests/bench/lab/trace.hpp"

namespace bench::lab {

/// Plays the drill of a scene by its own motion, spoilt by the scene's faults, through the same session as `carrel
/// run`.
Trace play_drill(const Scene& scene);

}  // namespace bench::lab
