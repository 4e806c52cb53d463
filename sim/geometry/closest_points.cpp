#include "sim/geometry/closest_points.hpp"

#include <algorithm>
#include <utility>

namespace sim::geometry {

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
