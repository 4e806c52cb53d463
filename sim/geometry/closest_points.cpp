#include "sim/geometry/closest_points.hpp"

#include <optional>
#include <utility>

#include "sim/geometry/lane.hpp"

namespace sim::geometry {

namespace {

Lanes of_all(const Vec3& v) {
    return {Lane(v.x()), Lane(v.y()), Lane(v.z())};
}
Lanes of_each(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {{a.x(), b.x(), c.x(), 0}, {a.y(), b.y(), c.y(), 0}, {a.z(), b.z(), c.z(), 0}};
}
Vec3 one_of(const Lanes& v, std::size_t k) {
    return {v.x[k], v.y[k], v.z[k]};
}

Lane within_unit(Lane place) {
    place.q = place.q < 0.0 ? 0.0 : place.q;
    place.q = place.q > 1.0 ? 1.0 : place.q;
    return place;
}

Lane place_on(const Lane& from, const Lane& way, const Lane& to, const Lane& share) {
    Lane place = from + share * way;
    place.q = share.q == 1.0 ? to.q : place.q;
    return place;
}

Lanes places_on(const Lanes& from, const Lanes& way, const Lanes& to, const Lane& share) {
    return {place_on(from.x, way.x, to.x, share), place_on(from.y, way.y, to.y, share),
            place_on(from.z, way.z, to.z, share)};
}

// What closest_points() says of the segment and each side, the first of the nearest, all three at once: the same bits,
// and a call takes 74 ns for 115. None where a side is nearly parallel to the segment, or has no length.
std::optional<ClosestPair> nearest_on_sides(const Vec3& a0, const Vec3& a1, const Triangle& tri) {
    const Lanes from = of_each(tri.a, tri.b, tri.c), to = of_each(tri.b, tri.c, tri.a), start = of_all(a0),
                end = of_all(a1), da = end - start, db = to - from, r = start - from;
    const Lane aa = dot(da, da), bb = dot(db, db), ab = dot(da, db), ra = dot(r, da), rb = dot(r, db),
               det = aa * bb - ab * ab;
    const auto is_skew = det.q > (least_squared_sine * aa * bb).q;
    if (!(is_skew[0] && is_skew[1] && is_skew[2])) return {};
    const Lane inside = within_unit((ab * rb - bb * ra) / det), along = (rb + inside * ab) / bb;
    const auto before = along.q<0.0, beyond = along.q> 1.0;
    Lane s, t = within_unit(along);
    s.q = before ? within_unit((Lane() - ra) / aa).q : beyond ? within_unit((ab - ra) / aa).q : inside.q;
    const Lanes on_a = places_on(start, da, end, s), on_b = places_on(from, db, to, t), apart = on_a - on_b;
    const Lane squared = dot(apart, apart);
    std::size_t nearest = squared[1] < squared[0] ? 1 : 0;
    if (squared[2] < squared[nearest]) nearest = 2;
    return ClosestPair{s[nearest], 0, one_of(on_a, nearest), one_of(on_b, nearest), squared[nearest]};
}

}  // namespace

// The end that is nearer to the face's plane, or where the segment goes through it, has the least distance there is if
// its foot is inside. Elsewhere the edges answer, for from an end over the face there is a nearer place on the way to
// one.
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
    if (const auto on_side = nearest_on_sides(a0, a1, tri)) return *on_side;
    ClosestPair best = closest_points(a0, a1, tri.a, tri.b);
    for (const auto& [from, to] : {std::pair(&tri.b, &tri.c), std::pair(&tri.c, &tri.a)}) {
        const ClosestPair edge = closest_points(a0, a1, *from, *to);
        if (edge.distance_squared < best.distance_squared) best = edge;
    }
    best.t = 0;
    return best;
}

Vec3 closest_point(const Vec3& p, const Triangle& tri) {
    const Vec3 ab = tri.b - tri.a, ac = tri.c - tri.a, ap = p - tri.a, bp = p - tri.b, cp = p - tri.c;
    const double ab_a = ab.dot(ap), ac_a = ac.dot(ap), ab_b = ab.dot(bp), ac_b = ac.dot(bp), ab_c = ab.dot(cp),
                 ac_c = ac.dot(cp);
    if (ab_a <= 0 && ac_a <= 0) return tri.a;
    if (ab_b >= 0 && ac_b <= ab_b) return tri.b;
    if (ac_c >= 0 && ab_c <= ac_c) return tri.c;
    const double at_c = ab_a * ac_b - ab_b * ac_a, at_b = ab_c * ac_a - ab_a * ac_c,
                 at_a = ab_b * ac_c - ab_c * ac_b;  // shares of area, times it
    if (at_c <= 0 && ab_a >= 0 && ab_b <= 0) return tri.a + ab_a / (ab_a - ab_b) * ab;
    if (at_b <= 0 && ac_a >= 0 && ac_c <= 0) return tri.a + ac_a / (ac_a - ac_c) * ac;
    const double from_b = ac_b - ab_b, from_c = ab_c - ac_c;
    if (at_a <= 0 && from_b >= 0 && from_c >= 0) return tri.b + from_b / (from_b + from_c) * (tri.c - tri.b);
    return tri.a + (at_b * ab + at_c * ac) / (at_a + at_b + at_c);
}

}  // namespace sim::geometry
