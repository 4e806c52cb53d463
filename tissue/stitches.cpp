#include <algorithm>
#include <cmath>

#include "sim/geometry/portable_math.hpp"
#include "tissue/join_parts.hpp"

namespace tissue {

namespace {

double arc(const SewnBite& a, const SewnBite& b) {
    const double turn = 2 * EIGEN_PI, off = a.angle - b.angle;
    return std::abs(off - turn * std::round(off / turn));
}

bool is_one_pass(const SewnBite& a, const SewnBite& b) {
    return a.thread >= 0 && a.thread == b.thread && a.vessel == b.vessel && a.pass == b.pass;
}

Stitch stitch(std::span<const SewnBite> bites, std::size_t from, std::size_t to, double radius) {
    const SewnBite &a = bites[from], &b = bites[to];
    Stitch made{.bites = {static_cast<int>(from), static_cast<int>(to)}};
    if (a.vessel == 1) std::swap(made.bites[0], made.bites[1]);
    made.arc = arc(a, b);
    if (!(a.size > 0 && b.size > 0)) return made;
    made.obliqueness = sim::geometry::portable_atan2(radius * made.arc, a.size + b.size);
    made.loop = std::abs(a.outer_along - b.outer_along) / (a.through + a.inside + b.inside + b.through);
    return made;
}

}  // namespace

std::vector<Stitch> stitches_of(std::span<const SewnBite> bites, double radius) {
    const auto end_of_pass = [&](std::size_t from) {
        std::size_t to = from;
        while (to < bites.size() && is_one_pass(bites[from], bites[to])) ++to;
        return std::max(to, from + 1);
    };
    std::vector<Stitch> found;
    for (std::size_t from = 0; from < bites.size();) {
        const std::size_t next = end_of_pass(from);
        const bool is_same_thread =
            next < bites.size() && bites[from].thread >= 0 && bites[from].thread == bites[next].thread;
        const bool goes_over = is_same_thread && bites[from].vessel != bites[next].vessel;
        const std::size_t end = goes_over ? end_of_pass(next) : next;
        if (goes_over) found.push_back(stitch(bites, from, end - 1, radius));
        from = end;
    }
    return found;
}

std::vector<double> spacing_of(std::span<const SewnBite> bites, std::span<const Stitch> stitches, std::size_t vessel,
                               double rim) {
    std::vector<double> places, spacing;
    for (const Stitch& s : stitches) places.push_back(bites[static_cast<std::size_t>(s.bites[vessel])].place);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i < places.size(); ++i)
        spacing.push_back(i + 1 < places.size() ? places[i + 1] - places[i] : places[0] + rim - places[i]);
    return spacing;
}

double arc_of_pass(std::span<const SewnBite> bites) {
    double widest = 0;
    for (const SewnBite& a : bites)
        for (const SewnBite& b : bites)
            if (is_one_pass(a, b)) widest = std::max(widest, arc(a, b));
    return widest;
}

}  // namespace tissue
