#pragma once
#include "scenarios/world/defs.hpp"

namespace scenarios::session {

/// Walls that give way, as they start, against all that must not be in them: threads, needles, each other. What the
/// drill's reader cannot know: meshes, and ends cut aslant. Throws InputFault, which names the vessel. Vessels bitten
/// before have a thread in them. Cost: less than 40 ms for two ends and eight threads.
void check_soft_starts(const scenarios::world::WorldDef& def);

}  // namespace scenarios::session
