// Judges a join: rims, bites, stitches, suture line, lumen and leak, each from geometry as it is now and at rest. Runs
// once, when a drill ends. Leaks are orifice flows and plane Poiseuille flows in series (leak.hpp).
#include "tissue/join.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "tissue/join_parts.hpp"
#include "tissue/lumen.hpp"

namespace tissue {

namespace {

using std::numbers::pi;

// Which of `all` is nearest to a point at rest.
Rim rim_next_to(std::vector<Rim> all, const Mesh& rest, const Vec3& point) {
    const auto off = [&](const Rim& rim) { return (middle(rim, rest.nodes) - point).norm(); };
    return all.empty()
               ? Rim{}
               : *std::min_element(all.begin(), all.end(), [&](const Rim& a, const Rim& b) { return off(a) < off(b); });
}

// Any point of the wall tells about where the wall is at rest.
Vec3 centre(const Mesh& rest) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& node : rest.nodes) sum += node;
    return sum / static_cast<double>(rest.nodes.size());
}

SewnEnd end_of(const SewnVessel& vessel, const SewnVessel& other) {
    const Rim outer = rim_next_to(rims(vessel.rest, Side::outer), vessel.rest, centre(other.rest));
    const std::vector<Rim> inner = rims(vessel.rest, Side::inner);
    if (outer.nodes.empty() || inner.empty())
        throw std::invalid_argument("a vessel without a cut across its lumen cannot be joined");
    return {vessel, outer, rim_next_to(inner, vessel.rest, middle(outer, vessel.rest.nodes))};
}

// Thickness of the wall: the cut's area over the mean length of its rims [m].
double wall_of(const Mesh& rest) {
    double area = 0, rim = 0;
    for (const Face& face : rest.faces) {
        const auto at = [&](std::size_t k) -> const Vec3& {
            return rest.nodes[static_cast<std::size_t>(face.nodes[k])];
        };
        if (face.side == Side::cut) area += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
    }
    for (const Side side : {Side::outer, Side::inner})
        for (const Rim& r : rims(rest, side)) rim += r.length;
    return area / (0.5 * rim);
}

struct Lying {
    double length = 0, deepest = 0;  // in the lumen, deeper than a diameter; of the middle of the thread
};

Lying in_lumen(std::span<const std::vector<Vec3>> threads, const SewnEnd& a, const SewnEnd& b, double diameter) {
    const double reach = std::max(length(a.inner, a.nodes()), length(b.inner, b.nodes())) / pi;
    Lying found;
    for (const std::vector<Vec3>& thread : threads)
        for (std::size_t i = 0; i + 1 < thread.size(); ++i) {
            const Vec3 link = thread[i + 1] - thread[i];
            const int pieces = 1 + static_cast<int>(link.norm() / diameter);
            for (int k = 0; k < pieces; ++k) {
                const double depth =
                    depth_in_lumen(thread[i] + (k + 0.5) / pieces * link, a.vessel.skin, b.vessel.skin, reach);
                if (depth > diameter) found.length += link.norm() / pieces;
                found.deepest = std::max(found.deepest, depth);
            }
        }
    return found;
}

double leak(std::span<const LinePiece> line, double wall, const Fluid& fluid) {
    double sum = 0;
    for (const LinePiece& piece : line)
        sum += leak_of_slit(piece.gap, piece.width, std::max(wall, piece.overlap), fluid);
    return sum;
}

double leak(std::span<const SewnBite> bites, double diameter, const Fluid& fluid) {
    double sum = 0;
    for (const SewnBite& bite : bites) {
        if (bite.partial) continue;
        const double hole = bite.hole_radius, thread = diameter / 2;
        sum += bite.thread < 0 ? leak_of_hole(pi * hole * hole, fluid)
                               : leak_of_slit(hole - thread, pi * (hole + thread), bite.through, fluid);
    }
    return sum;
}

// Leak of passes that were taken back after they had gone through the wall [m^3/s].
double leak_of_passes(const SewnVessel& vessel, const Fluid& fluid) {
    double sum = 0;
    for (const Bite& bite : vessel.bites) {
        if (bite.state == BiteState::open || bite.exit.hole < 0 || bite.partial()) continue;
        const double hole = std::min(vessel.skin.radius(bite.entry.hole), vessel.skin.radius(bite.exit.hole));
        sum += leak_of_hole(pi * hole * hole, fluid);
    }
    return sum;
}

}  // namespace

Around around(const SewnEnd& end) {
    const Vec3 axis = end.vessel.axis, x = axis.unitOrthogonal();
    return {x, axis.cross(x)};
}

Join judge(const SewnVessel& first, const SewnVessel& second, std::span<const std::vector<Vec3>> threads,
           double diameter, const Fluid& fluid) {
    assert(diameter > 0 && fluid.density > 0 && fluid.viscosity > 0 && fluid.pressure >= 0);
    const std::array<SewnEnd, 2> ends{end_of(first, second), end_of(second, first)};
    Join join;
    join.diameter = diameter, join.wall = wall_of(first.rest), join.rim = ends[0].outer.length;
    join.line = suture_line(ends[0], ends[1], join.wall);
    for (const int i : {0, 1}) {
        const auto found = sewn_bites(ends[static_cast<std::size_t>(i)], i, around(ends[0]), threads, diameter);
        join.bites.insert(join.bites.end(), found.begin(), found.end());
    }
    const auto is_before = [](const SewnBite& a, const SewnBite& b) {
        return std::tie(a.thread, a.along) < std::tie(b.thread, b.along);
    };
    std::stable_sort(join.bites.begin(), join.bites.end(), is_before);
    join.stitches = stitches_of(join.bites, join.rim / (2 * pi));
    for (const std::size_t i : {0, 1}) join.spacing[i] = spacing_of(join.bites, join.stitches, i, ends[i].outer.length);
    join.arc_of_pass = arc_of_pass(join.bites);
    for (const SewnEnd& end : ends)
        join.lumen_ratio =
            std::min(join.lumen_ratio, lumen_ratio(end.inner, end.vessel.rest, end.nodes(), end.vessel.axis));
    const Lying thread = in_lumen(threads, ends[0], ends[1], diameter);
    join.thread_in_lumen = thread.length, join.deepest_thread = thread.deepest;
    join.leak_of_line = leak(join.line, join.wall, fluid),
    join.leak_of_holes =
        leak(join.bites, diameter, fluid) + leak_of_passes(first, fluid) + leak_of_passes(second, fluid);
    return join;
}

}  // namespace tissue
