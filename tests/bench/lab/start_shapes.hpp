#pragma once
#include <string>
#include <vector>

#include "sim/geometry/vec.hpp"

// The shapes in which threads of hard cases start.
namespace bench::lab {

using sim::geometry::Vec3;

/// An open overhand knot, any unit: the long trefoil of [Shastri1992], flattened a little, its ends led out straight.
std::vector<Vec3> overhand_path();

/// A loop closed by throws, both ends free above it, any unit. In Tera and Aberg's notation: "1=1" square, "1x1"
/// granny, "2=1" surgeon's.
std::vector<Vec3> tied_path(const std::string& notation);

/// A helix about the x axis [m].
std::vector<Vec3> coil_path(double turns, double radius, double pitch);

/// Straight strands along x, exactly in one plane, `gap` apart and folded on each other [m].
std::vector<Vec3> folded_path(int folds, double length, double gap);

/// The middle between its ends at the origin, the last end from the first along +x, and this long [m].
std::vector<Vec3> laid_along_x(std::vector<Vec3> path, double length);

double length_of(const std::vector<Vec3>& path);  ///< In the path's unit.

}  // namespace bench::lab
