#pragma once
#include <algorithm>

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
// In the header because the thread's contacts call it some thousand times a tick.
inline ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    const Vec3 da = a1 - a0, db = b1 - b0, r = a0 - b0;
    const double aa = da.squaredNorm(), bb = db.squaredNorm(), ab = da.dot(db), ra = r.dot(da), rb = r.dot(db);

    // Candidates are compared by the quadratic itself, less its constant; its rounding decides only between places that
    // are equally near to within rounding. Only the winner's points and distance are computed.
    double best_s = 0, best_t = 0, best = 0;
    const auto consider = [&](double s, double t) {
        const double value = s * (s * aa + 2 * ra) + t * (t * bb - 2 * rb) - 2 * s * t * ab;
        if (value < best) best_s = s, best_t = t, best = value;
    };
    // Place in [0, 1] where the derivative along one side vanishes. A segment of no length has one place: its start.
    const auto place = [](double slope, double curvature) {
        return curvature > 0 ? std::clamp(slope / curvature, 0.0, 1.0) : 0.0;
    };
    // The inside first. Near parallel, s is inaccurate, but the pair it gives is still a real pair of points and only
    // wins if it is closer than the sides. So parallel needs no threshold, and nothing depends on the unit of length.
    const double det = aa * bb - ab * ab;
    if (det > 0) {
        const double s = (ab * rb - bb * ra) / det, t = (rb + s * ab) / bb;
        if (s > 0 && s < 1 && t > 0 && t < 1) consider(s, t);
    }
    // The sides of the square (s, t): an end of one segment against the whole of the other.
    consider(0, place(rb, bb));
    consider(1, place(rb + ab, bb));
    consider(place(-ra, aa), 0);
    consider(place(ab - ra, aa), 1);
    const Vec3 on_a = best_s == 1 ? a1 : Vec3(a0 + best_s * da), on_b = best_t == 1 ? b1 : Vec3(b0 + best_t * db);
    return {best_s, best_t, on_a, on_b, (on_a - on_b).squaredNorm()};
}

/// Closest points of a segment and a triangle: `on_a` on the segment at `s`, `on_b` on the triangle (`t` unused, 0).
/// A segment that pierces the triangle has distance 0 there. Degenerate triangles count as their edges.
ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Triangle& triangle);

}  // namespace sim::geometry
