#pragma once
#include <algorithm>

#include "sim/geometry/shapes.hpp"

namespace sim::geometry {

/// A pair of points, one on each of two segments.
struct ClosestPair {
    double s, t;              ///< Place along a0-a1 and b0-b1, each in [0, 1].
    Vec3 on_a, on_b;          ///< The two points [m], in the frame of the input.
    double distance_squared;  ///< Square of their distance [m^2].
};

/// Squared sine of the angle between segments below which they count as nearly parallel. A share, so no unit enters.
constexpr double least_squared_sine = 1e-6;

/// Closest points of the segments a0-a1 and b0-b1.
///
/// Input:      four finite points in one frame [m]. A segment may be a single point.
/// Ties:       parallel segments give one of the equally close pairs, the same one every time.
/// Guarantee:  both points lie on their segments, so no contact is ever reported that is not there.
/// Errors:     none. Cost: no allocation; some 10 ns, thrice that for segments parallel to within a thousandth.
/// Source:     minimum of a convex quadratic on the unit square, by clamping [Ericson2005] 5.1.9.
inline ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    // In the header because the thread's contacts call it some thousand times a tick.
    const Vec3 da = a1 - a0, db = b1 - b0, r = a0 - b0;
    const double aa = da.squaredNorm(), bb = db.squaredNorm(), ab = da.dot(db), ra = r.dot(da), rb = r.dot(db);
    const auto pair = [&](double s, double t) -> ClosestPair {
        const Vec3 on_a = s == 1 ? a1 : Vec3(a0 + s * da), on_b = t == 1 ? b1 : Vec3(b0 + t * db);
        return {s, t, on_a, on_b, (on_a - on_b).squaredNorm()};
    };
    // Place in [0, 1] where the derivative along one side vanishes. A segment of no length has one place: its start.
    const auto place = [](double slope, double curvature) {
        return curvature > 0 ? std::clamp(slope / curvature, 0.0, 1.0) : 0.0;
    };
    // Well apart from parallel, s is good to a millionth of the rounding that decides between near ties, and the best t
    // for it, clamped, then the best s for that, is the minimum.
    const double det = aa * bb - ab * ab;
    if (det > least_squared_sine * aa * bb) {
        const double s = std::clamp((ab * rb - bb * ra) / det, 0.0, 1.0), t = (rb + s * ab) / bb;
        if (t < 0) return pair(place(-ra, aa), 0);
        if (t > 1) return pair(place(ab - ra, aa), 1);
        return pair(s, t);
    }
    // Near parallel the inside is inaccurate, but the pair it gives is still a real pair of points and only wins if it
    // is closer than the sides of the square (s, t): an end of one segment against the whole of the other. Candidates
    // are compared by the quadratic itself, less its constant.
    double best_s = 0, best_t = 0, best = 0;
    const auto consider = [&](double s, double t) {
        const double value = s * (s * aa + 2 * ra) + t * (t * bb - 2 * rb) - 2 * s * t * ab;
        if (value < best) best_s = s, best_t = t, best = value;
    };
    if (det > 0) {
        const double s = (ab * rb - bb * ra) / det, t = (rb + s * ab) / bb;
        if (s > 0 && s < 1 && t > 0 && t < 1) consider(s, t);
    }
    consider(0, place(rb, bb));
    consider(1, place(rb + ab, bb));
    consider(place(-ra, aa), 0);
    consider(place(ab - ra, aa), 1);
    return pair(best_s, best_t);
}

/// Closest points of a segment and a triangle: `on_a` on the segment at `s`, `on_b` on the triangle (`t` unused, 0).
/// A segment that pierces the triangle has distance 0 there. Degenerate triangles count as their edges.
ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Triangle& triangle);

/// The place of a triangle that is nearest to a point [m]: what closest_points() says of a segment without length, but
/// for rounding.
///
/// Errors:     none. Degenerate triangles count as their edges. Cost: no allocation; 13 ns for 129.
/// Source:     by the regions of corners, edges and face [Ericson2005] 5.1.5.
Vec3 closest_point(const Vec3& p, const Triangle& triangle);

}  // namespace sim::geometry
