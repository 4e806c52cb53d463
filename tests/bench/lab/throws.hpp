#pragma once
#include <vector>

#include "sim/geometry/vec.hpp"
#include "sim/knot/namer.hpp"

namespace bench::lab {

using sim::geometry::Vec3;

/// A thread tied above a loop, any unit: throws 4 wide and 3 apart from z = 0 upwards, in each of which its two strands
/// are twisted (2 turns + 1) half turns about x, right-handed or not. `loop`: vertices below, between the strands' feet
/// at (-2.5, 0, -3) and (2.5, 0, -3). `lead`: how far the ends go beyond the last throw, to either side and up.
std::vector<Vec3> tied(const std::vector<sim::knot::Throw>& throws, const std::vector<Vec3>& loop = {{0, 0, -6}},
                       const Vec3& lead = {3, 0, 4});

}  // namespace bench::lab
