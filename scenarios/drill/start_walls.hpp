#pragma once
#include "scenarios/world/defs.hpp"

namespace scenarios::drill {

/// Whether a needle goes through the wall of a vessel, as both start. It looks at tubes by numbers, to where an oblique
/// cut begins, and says false of a mesh. Cost: none to speak of.
bool is_in_wall(const sim::geometry::Arc& needle, const world::VesselDef& vessel);

/// Whether the walls of two tubes by numbers lie in each other, as they start: looked for every eighth of a diameter
/// along and 32 times around.
bool are_in_each_other(const world::VesselDef& a, const world::VesselDef& b);

}  // namespace scenarios::drill
