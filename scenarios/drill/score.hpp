#pragma once
#include <vector>

#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/result.hpp"
#include "scenarios/world/measure.hpp"

namespace scenarios::drill {

/// Every scored item of a session: knot, throws and tails against the goal, then time, path, grasps, tension, lag and
/// pass-throughs against their bands. An item without a band passes and says so by an empty band. No item is weighed
/// against another. `measures` has one entry per instrument of the drill where it is a list.
std::vector<ScoreItem> score(const Drill& drill, const world::Measures& measures);

}  // namespace scenarios::drill
