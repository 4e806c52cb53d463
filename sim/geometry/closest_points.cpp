#include "sim/geometry/closest_points.hpp"

#include <utility>

namespace sim::geometry {

// The end that is nearer to the face's plane, or where the segment goes through it, has the least distance there is if its foot is
// inside. Elsewhere the edges answer, for from an end over the face there is a nearer place on the way to one.
ClosestPair closest_points(const Vec3& a0, const Vec3& a1, const Triangle& tri) {
    const Vec3 d = a1 - a0, ab = tri.b - tri.a, ac = tri.c - tri.a, normal = ab.cross(ac);
    const double nn = normal.squaredNorm(), h0 = normal.dot(a0 - tri.a), h1 = normal.dot(a1 - tri.a);
    const double s = (h0 < 0) != (h1 < 0) ? h0 / (h0 - h1) : std::abs(h0) <= std::abs(h1) ? 0 : 1;
    // Barycentric coordinates as shares of area, not a number if there is none.
    const Vec3 on_a = a0 + s * d, ap = on_a - tri.a;
    const double v = normal.dot(ap.cross(ac)) / nn, w = normal.dot(ab.cross(ap)) / nn;
    if (v >= 0 && w >= 0 && v + w <= 1) {
        const Vec3 on_b = tri.a + v * ab + w * ac;
        return {s, 0.0, on_a, on_b, (on_a - on_b).squaredNorm()};
    }
    ClosestPair best = closest_points(a0, a1, tri.a, tri.b);
    for (const auto& [from, to] : {std::pair(&tri.b, &tri.c), std::pair(&tri.c, &tri.a)}) {
        const ClosestPair edge = closest_points(a0, a1, *from, *to);
        if (edge.distance_squared < best.distance_squared) best = edge;
    }
    best.t = 0;
    return best;
}

}  // namespace sim::geometry
