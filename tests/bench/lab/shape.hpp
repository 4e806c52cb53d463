#pragma once
#include <vector>

#include "sim/geometry/vec.hpp"

namespace bench::lab {

using sim::geometry::Vec3;

/// An open overhand knot, `length` long [m], of equal links: a trefoil over 40 % of the length, cut where it is
/// outermost, its ends led out straight, first to -x, last to +x. The middle of the rope is the middle of the knot.
std::vector<Vec3> overhand(int links, double length);

/// A coil about x, of links `link` long [m] to within the sagitta of one; `pitch`: advance in a turn [m].
std::vector<Vec3> coil(int links, double link, double radius, double pitch);

}  // namespace bench::lab
