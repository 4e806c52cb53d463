#pragma once
#include <string>
#include <vector>

#include "sim/knot/curve.hpp"

namespace sim::knot {

/// A hitch: an open rope without a knot of its own, made fast round a pole. Which of them the rope makes round a pole,
/// an open strand or the stretch of a closed one that is near: "single turn", "round turn", "clove hitch",
/// "constrictor", "cow hitch", "prusik"; or "" for none of these.
///
/// `link`: the two with the rope's ends joined. A cow hitch and a prusik can be tied without an end of the pole, so
/// that is the unlink for them; what tells hitches apart are the knots of the rope's ends joined to the pole's ends
/// (docs/knots.md, "Hitches"). Strands in general position; `ways` of both. Cost: four names of knots.
std::string hitch(const Name& link, const Polygons& rope_and_pole, const std::vector<bool>& closed,
                  const std::vector<Ways>& ways);

/// Whether this is the name of a hitch that stays when its ends are let go; a turn does not.
bool holds_by_itself(const std::string& hitch);

}  // namespace sim::knot
