#pragma once
#include "app/bench/trace.hpp"

namespace app::bench {

/// Plays the drill of a scene by its own motion, spoilt by the scene's faults, through the same session as `carrel
/// run`.
Trace play_drill(const Scene& scene);

}  // namespace app::bench
