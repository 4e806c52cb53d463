#include "sim/geometry/closest_points.hpp"

#include <algorithm>

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

// Closest point of a triangle to p, by the region p lies in. [Ericson2005] 5.1.5.
static Vec3 nearest_on_triangle(const Vec3& p, const Triangle& tri) {
    const Vec3 ab = tri.b - tri.a, ac = tri.c - tri.a, ap = p - tri.a, bp = p - tri.b, cp = p - tri.c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d1 <= 0 && d2 <= 0) return tri.a;
    if (d3 >= 0 && d4 <= d3) return tri.b;
    if (d6 >= 0 && d5 <= d6) return tri.c;
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return tri.a + d1 / (d1 - d3) * ab;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return tri.a + d2 / (d2 - d6) * ac;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return tri.b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (tri.c - tri.b);
    return tri.a + (vb * ab + vc * ac) / (va + vb + vc);
}

ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Triangle& tri) {
    const Vec3 d = a1 - a0, normal = (tri.b - tri.a).cross(tri.c - tri.a);
    const double h0 = normal.dot(a0 - tri.a), h1 = normal.dot(a1 - tri.a);

    ClosestPair best{0.0, 0.0, a0, nearest_on_triangle(a0, tri), 0.0};
    best.distance_squared = (best.on_a - best.on_b).squaredNorm();
    const auto consider = [&](double s, const Vec3& on_a, const Vec3& on_b) {
        const double d2 = (on_a - on_b).squaredNorm();
        if (d2 < best.distance_squared) best = {s, 0.0, on_a, on_b, d2};
    };
    consider(1.0, a1, nearest_on_triangle(a1, tri));
    if ((h0 < 0) != (h1 < 0)) {  // through the plane: the piercing point, if it is inside
        const double s = h0 / (h0 - h1);
        const Vec3 p = a0 + s * d;
        consider(s, p, nearest_on_triangle(p, tri));
    }
    const Vec3* corner[] = {&tri.a, &tri.b, &tri.c};
    for (int i = 0; i < 3; ++i) {
        const ClosestPair edge = closest_points(a0, a1, *corner[i], *corner[(i + 1) % 3]);
        consider(edge.s, edge.on_a, edge.on_b);
    }
    return best;
}

}  // namespace sim::geometry
