#include "sim/geometry/closest_points.hpp"

#include <algorithm>
#include <utility>

namespace sim::geometry {

ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
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

ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Triangle& tri) {
    // The edges answer for all but the inside of the face, also where there is no inside.
    ClosestPair best = closest_points(a0, a1, tri.a, tri.b);
    for (const auto& [from, to] : {std::pair(&tri.b, &tri.c), std::pair(&tri.c, &tri.a)}) {
        const ClosestPair edge = closest_points(a0, a1, *from, *to);
        if (edge.distance_squared < best.distance_squared) best = edge;
    }
    best.t = 0;

    const Vec3 d = a1 - a0, ab = tri.b - tri.a, ac = tri.c - tri.a, normal = ab.cross(ac);
    const double nn = normal.squaredNorm(), h0 = normal.dot(a0 - tri.a), h1 = normal.dot(a1 - tri.a);
    // The face against the place s of the segment, if its foot is inside: barycentric coordinates as shares of area,
    // not a number if there is none.
    const auto consider = [&](double s) {
        const Vec3 on_a = a0 + s * d, ap = on_a - tri.a;
        const double v = normal.dot(ap.cross(ac)) / nn, w = normal.dot(ab.cross(ap)) / nn;
        if (!(v >= 0 && w >= 0 && v + w <= 1)) return;
        const Vec3 on_b = tri.a + v * ab + w * ac;
        const double d2 = (on_a - on_b).squaredNorm();
        if (d2 < best.distance_squared) best = {s, 0.0, on_a, on_b, d2};
    };
    consider(0.0);
    consider(1.0);
    if ((h0 < 0) != (h1 < 0)) consider(h0 / (h0 - h1));  // through the plane
    return best;
}

}  // namespace sim::geometry
