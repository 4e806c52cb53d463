#include <algorithm>
#include <cmath>

#include "sim/knot/curve.hpp"

namespace sim::knot {

namespace {

using Strands = std::vector<std::vector<Vec3>>;

// A direction in which `end` lies strictly beyond all other vertices, or nothing when it is inside the hull (or so
// nearly that 300 steps do not find one). Frank and Wolfe's method for the point of least norm of the hull of the unit
// vectors from the end to the others: any iterate that all of them agree with will do.
std::optional<Vec3> way_out(const Strands& strands, std::size_t strand, bool first) {
    const Vec3 end = first ? strands[strand].front() : strands[strand].back();
    std::vector<Vec3> to_others;
    for (std::size_t s = 0; s < strands.size(); ++s) {
        const std::size_t n = strands[s].size();
        const std::size_t skip = s == strand ? (first ? 0 : n - 1) : n;
        for (std::size_t i = 0; i < n; ++i)
            if (i != skip) to_others.push_back((strands[s][i] - end).normalized());
    }
    Vec3 mean = Vec3::Zero();
    for (const Vec3& u : to_others) mean += u;
    Vec3 v = mean / static_cast<double>(std::max<std::size_t>(1, to_others.size()));
    for (int step = 0; step < 300; ++step) {
        double least = 2.0;
        const Vec3* worst = nullptr;
        for (const Vec3& u : to_others)
            if (const double along = u.dot(v); along < least) least = along, worst = &u;
        // A hundredth of a degree of clearance for every vertex, far above the 1e-9 of in_general_position.
        if (!worst || least > 1e-4 * v.norm()) return Vec3(-v.normalized());
        const Vec3 d = *worst - v;
        if (v.dot(v) - v.dot(*worst) <= 1e-12 || d.squaredNorm() == 0.0) break;
        v += std::clamp(-v.dot(d) / d.squaredNorm(), 0.0, 1.0) * d;
    }
    return std::nullopt;
}

Vec3 at_radius(const Vec3& from, const Vec3& along, double radius) {
    const double b = from.dot(along), c = from.squaredNorm() - radius * radius;
    return from + (std::sqrt(b * b - c) - b) * along;
}

// Points on the sphere from a to b on the great circle, no more than 60 degrees apart: the chords stay outside 0.86
// of the radius.
void append_arc(std::vector<Vec3>& points, const Vec3& a, const Vec3& b, double radius) {
    Vec3 half = a + b;
    if (half.norm() < 0.1 * radius) half = a.unitOrthogonal();
    half = radius * half.normalized();
    if (a.dot(half) < 0.5 * radius * radius) {
        append_arc(points, a, half, radius);
        points.push_back(half);
        append_arc(points, half, b, radius);
    } else if (a.dot(b) < 0.5 * radius * radius) {
        points.push_back(half);
    }
}

}  // namespace

Closed close_outside(const Strands& strands, const std::vector<bool>& closed, int vote) {
    Closed result;
    double radius = 2.0;  // everything lies within sqrt(3)/2 of the origin
    Vec3 rope_side = Vec3::Zero();
    for (std::size_t s = 0; s < strands.size(); ++s) {
        auto& polygon = result.polygons.emplace_back(strands[s]);
        if (closed[s]) continue;
        const Vec3 buried = direction(vote);
        const auto out_first = way_out(strands, s, true), out_last = way_out(strands, s, false);
        if (!out_first || !out_last) result.ends_free = false;
        const Vec3 from = at_radius(strands[s].back(), out_last.value_or(buried), radius);
        const Vec3 to = at_radius(strands[s].front(), out_first.value_or(buried), radius);
        polygon.push_back(from);
        // The first open strand is the rope; what it is tied round is closed on the side away from the rope's ends.
        const Vec3 middle = -radius * rope_side.normalized();
        if (rope_side.norm() > 0.1 && from.dot(to) < 0.0) {
            append_arc(polygon, from, middle, radius);
            polygon.push_back(middle);
            append_arc(polygon, middle, to, radius);
        } else {
            append_arc(polygon, from, to, radius);
        }
        polygon.push_back(to);
        if (rope_side.isZero()) rope_side = (from + to) / radius;
        radius *= 1.5;
    }
    return result;
}

}  // namespace sim::knot
