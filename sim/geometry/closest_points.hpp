#pragma once
#include "sim/geometry/shapes.hpp"

namespace sim::geometry {

/// A pair of points, one on each of two segments.
struct ClosestPair {
    double s, t;              ///< Place along a0-a1 and b0-b1, each in [0, 1].
    Vec3 on_a, on_b;          ///< [m], in the frame of the input.
    double distance_squared;  ///< [m^2].
};

/// Closest points of the segments a0-a1 and b0-b1.
///
/// Input:      four finite points in one frame [m]. A segment may be a single point.
/// Ties:       parallel segments give one of the equally close pairs, the same one every time.
/// Guarantee:  both points lie on their segments, so no contact is ever reported that is not there.
/// Errors:     none. Cost: no allocation, at most five candidate pairs.
/// Source:     minimum of a convex quadratic on the unit square. [Ericson2005] 5.1.9 solves the same by clamping.
ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

/// Closest points of a segment and a triangle: `on_a` on the segment at `s`, `on_b` on the triangle (`t` unused, 0).
/// A segment that pierces the triangle has distance 0 there. Degenerate triangles count as their edges.
ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Triangle& triangle);

}  // namespace sim::geometry
