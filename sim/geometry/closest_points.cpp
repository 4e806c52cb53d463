#include "sim/geometry/closest_points.hpp"

#include <algorithm>
#include <utility>

namespace sim::geometry {

// Place in [0, 1] along q0 + u d nearest to p. A segment of no length has one place: its start.
static double nearest_place(const Vec3& p, const Vec3& q0, const Vec3& d) {
    const double dd = d.squaredNorm();
    return dd > 0.0 ? std::clamp((p - q0).dot(d) / dd, 0.0, 1.0) : 0.0;
}

ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    const Vec3 da = a1 - a0, db = b1 - b0, r = a0 - b0;
    ClosestPair best{0.0, 0.0, a0, b0, r.squaredNorm()};
    const auto consider = [&](double s, double t) {
        const Vec3 on_a = a0 + s * da, on_b = b0 + t * db;
        const double d2 = (on_a - on_b).squaredNorm();
        if (d2 < best.distance_squared) best = {s, t, on_a, on_b, d2};
    };

    // The inside first. Near parallel, s is inaccurate, but the pair it gives is still a real pair of points and only
    // wins if it is closer than the sides. So parallel needs no threshold, and nothing depends on the unit of length.
    const double aa = da.squaredNorm(), bb = db.squaredNorm(), ab = da.dot(db), det = aa * bb - ab * ab;
    if (det > 0.0) {
        const double rb = r.dot(db), s = (ab * rb - bb * r.dot(da)) / det, t = (rb + s * ab) / bb;
        if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) consider(s, t);
    }
    // The sides of the square (s, t): an end of one segment against the whole of the other.
    consider(0.0, nearest_place(a0, b0, db));
    consider(1.0, nearest_place(a1, b0, db));
    consider(nearest_place(b0, a0, da), 0.0);
    consider(nearest_place(b1, a0, da), 1.0);
    return best;
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
