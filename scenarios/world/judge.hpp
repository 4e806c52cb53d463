#pragma once
#include <vector>

#include "scenarios/world/measure.hpp"

namespace scenarios::world {

class World;

/// The knot of each piece of thread that has one, in their order along the thread. Names many stretches of the thread,
/// some 2 ms each: for the end of a session.
std::vector<TieMeasure> judge_ties(const World& world);

/// What was sewn: every bite, and the join where two ends were sewn. Some milliseconds: for the end of a session.
Sewing judge_sewing(const World& world);

/// All that has been measured of a session, with what is found at its end: where its knot lies, its ties, its sewing.
/// Takes the knot as last named: World::name_knot_now() first.
Measures judge(const World& world);

}  // namespace scenarios::world
