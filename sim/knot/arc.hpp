#pragma once
#include <vector>

#include "sim/geometry/vec.hpp"

namespace sim::knot {

using geometry::Vec3;

/// The point of the sphere about the origin that a ray from `from`, inside it, along a unit vector meets.
Vec3 at_radius(const Vec3& from, const Vec3& along, double radius);

/// Points between a and b, both on the sphere about the origin, on the great circle through them: so many that the
/// chords stay outside 0.86 of the radius.
void append_arc(std::vector<Vec3>& points, const Vec3& a, const Vec3& b, double radius);

/// The middle of that arc; any that will do when a and b are nearly opposite.
Vec3 half_way(const Vec3& a, const Vec3& b, double radius);

}  // namespace sim::knot
