#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/knot/arc.hpp"
#include "sim/knot/curve.hpp"

namespace sim::knot {

namespace {

using Strands = Polygons;

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

constexpr double outside = 2.0;  // everything lies within sqrt(3)/2 of the origin

}  // namespace

std::vector<Ways> ways_out(const Strands& strands, const std::vector<bool>& closed) {
    assert(closed.size() == strands.size() && "a mark for each component");
    std::vector<Ways> ways(strands.size());
    for (std::size_t s = 0; s < strands.size(); ++s)
        if (!closed[s]) ways[s] = {way_out(strands, s, true), way_out(strands, s, false)};
    return ways;
}

bool all_free(const std::vector<Ways>& ways, const std::vector<bool>& closed) {
    for (std::size_t s = 0; s < ways.size(); ++s)
        if (!closed[s] && !(ways[s].from_first && ways[s].from_last)) return false;
    return true;
}

bool either_way(const Strands& strands, const std::vector<bool>& closed, const std::vector<Ways>& ways) {
    if (std::count(closed.begin(), closed.end(), false) < 2) return false;
    const auto first = static_cast<std::size_t>(std::find(closed.begin(), closed.end(), false) - closed.begin());
    const auto& rope = strands[first];
    if (!ways[first].from_first || !ways[first].from_last) return false;
    const Vec3 head = rope[0] - rope[1], tail = rope[rope.size() - 1] - rope[rope.size() - 2];
    return ways[first].from_first->dot(*ways[first].from_last) < -0.5 ||
           head.normalized().dot(tail.normalized()) < -0.5;
}

Polygons close_outside(const Strands& strands, const std::vector<bool>& closed, const std::vector<Ways>& ways, int vote,
                       bool other_way) {
    Polygons result;
    double radius = outside;
    Vec3 rope_side = Vec3::Zero();
    for (std::size_t s = 0; s < strands.size(); ++s) {
        auto& polygon = result.emplace_back(strands[s]);
        if (closed[s]) continue;
        const Vec3 buried = direction(vote);
        const Vec3 from = at_radius(strands[s].back(), ways[s].from_last.value_or(buried), radius);
        const Vec3 to = at_radius(strands[s].front(), ways[s].from_first.value_or(buried), radius);
        polygon.push_back(from);
        // The first open strand is the rope; what it is tied round is closed on the side away from the rope's ends.
        const bool is_rope = rope_side.isZero();
        const Vec3 middle = is_rope ? Vec3(-half_way(from, to, radius)) : Vec3(-radius * rope_side.normalized());
        if (is_rope ? other_way : rope_side.norm() > 0.1 && from.dot(to) < 0.0) {
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

Polygons reduced(const Strands& strands, const std::vector<bool>& closed, const std::vector<Ways>& ways, int votes) {
    Polygons all = strands;
    std::vector<bool> pinned;
    for (const bool c : closed) pinned.push_back(!c);
    // Whatever may lead an end out is in the way too: a polygon of two vertices, which never loses any.
    const auto lead_out = [&](const Vec3& end, const std::optional<Vec3>& way) {
        for (int vote = 0; vote < (way ? 1 : votes); ++vote)
            all.push_back({end, at_radius(end, way.value_or(direction(vote)), outside)});
    };
    for (std::size_t s = 0; s < strands.size(); ++s) {
        if (closed[s]) continue;
        lead_out(strands[s].front(), ways[s].from_first);
        lead_out(strands[s].back(), ways[s].from_last);
    }
    drop_empty_triangles(all, pinned);
    all.resize(strands.size());
    return all;
}

}  // namespace sim::knot
