#include "tests/bench/lab/rod_cases.hpp"

#include <cmath>
#include <numbers>

#include "sim/geometry/resample.hpp"
#include "sim/rod/rod.hpp"

namespace bench::lab {

namespace {

using sim::geometry::Hold;
using sim::geometry::Vec3;
using sim::rod::Rod;
using sim::rod::RodDef;

using std::numbers::pi;

// Bending stiffness 1, of links of length 1 over `links` so stiff that they stretch by a millionth of what they bend.
RodDef unit_rod(double poisson = 0.3, double slender = 1e-3) {
    return {.radius = slender,
            .young = 4 / (pi * std::pow(slender, 4)),
            .poisson = poisson,
            .density = 0,
            .axial_over_bending = 0};
}

RodDef hanging(double gravity) {  // of weight 1 and hardly any bending stiffness: 1e-9 of weight times length squared
    constexpr double radius = 1e-7;
    return {.radius = radius,
            .young = 4e-9 / (pi * std::pow(radius, 4)),
            .density = 1 / (pi * radius * radius),
            .axial_over_bending = 0,
            .gravity = {0, 0, -gravity}};
}

std::vector<Vec3> straight(int links, double length, double from = 0) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) nodes.emplace_back(from + length * i / links, 0, 0);
    return nodes;
}

void settle(Rod& rod, const sim::rod::RodInput& input) {
    constexpr int tries = 20;
    for (int i = 0; i < tries && !rod.step(input, 0).settled; ++i) {
    }
}

// Clamped in the middle of its first link, 1 long from there. Height of the tip below the clamp.
double drop(int links, double tip_load, double weight) {
    const double link = 1 / (links - 0.5);
    const std::vector<Vec3> nodes = straight(links, links * link, -0.5 * link);
    Rod rod(unit_rod(), nodes);
    std::vector<Vec3> loads(nodes.size(), Vec3(0, 0, -weight * link));
    loads.back() = {0, 0, -tip_load - 0.5 * weight * link};
    const Hold clamp[] = {{0, nodes[0]}, {1, nodes[1]}};
    settle(rod, {.holds = clamp, .loads = loads});
    return -rod.nodes().back().z();
}

// Ends brought together by a share of the length, free to turn: what they push with, over pi^2, Euler's load. From half
// a wave of a sine as long as the rod.
double strut(int links, double shortening) {
    const auto wave = [&](double height) {
        constexpr int fine = 4000;
        std::vector<Vec3> path;
        for (int i = 0; i <= fine; ++i)
            path.emplace_back((1 - shortening) * i / fine, height * std::sin(pi * i / fine), 0);
        return path;
    };
    const auto length = [](const std::vector<Vec3>& path) {
        double sum = 0;
        for (std::size_t i = 1; i < path.size(); ++i) sum += (path[i] - path[i - 1]).norm();
        return sum;
    };
    double low = 0, high = 1;
    for (int i = 0; i < 50; ++i) (length(wave(0.5 * (low + high))) < 1 ? low : high) = 0.5 * (low + high);
    const std::vector<Vec3> nodes = sim::geometry::resample(wave(low), links);
    const double whole = length(nodes);
    Rod rod(unit_rod(), nodes);
    const Hold ends[] = {{0, nodes[0]}, {links, Vec3((1 - shortening) * whole, 0, 0)}};
    settle(rod, {ends});
    return -rod.hold_force(links).x() * whole * whole / (pi * pi);
}

// The turn at which a rod whose first and last links are clamped stops being stable [rad].
double critical_turn(const RodDef& def, const std::vector<Vec3>& nodes, double at_most) {
    const int last = static_cast<int>(nodes.size()) - 1;
    const Hold clamps[] = {{0, nodes[0]}, {1, nodes[1]}, {last - 1, nodes[nodes.size() - 2]}, {last, nodes.back()}};
    double low = 0, high = at_most;
    for (int i = 0; i < 40; ++i) {
        const double turn = 0.5 * (low + high);
        Rod rod(def, nodes);
        (rod.step({.holds = clamps, .turn = turn}, 0, 0).stable ? low : high) = turn;
    }
    return low;
}

// A ring of n links, its last link on its first: round once more by one link.
double ring(int links) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links + 1; ++i)
        nodes.emplace_back(std::cos(2 * pi * i / links) / (2 * pi), std::sin(2 * pi * i / links) / (2 * pi), 0);
    return critical_turn(unit_rod(), nodes, 40);
}

double twisted_straight(int links) {  // moment times length over stiffness
    const RodDef def = unit_rod();
    return def.twisting_stiffness() * critical_turn(def, straight(links, links / (links - 1.0)), 40);
}

// Van der Heijden and Thompson; Bergou et al. 2008, fig. 5: 27 turns put in, then the clamps brought together by 0.3.
// The steepest angle of the helix that the rod springs into, against its axis.
double helix(int links) {
    constexpr double length = 9.29, bending = 1.345, twisting = 0.789, turns = 27, slack = 0.3, radius = 2e-3;
    constexpr int steps = 60;
    const RodDef def{.radius = radius,
                     .young = 4 * bending / (pi * std::pow(radius, 4)),
                     .poisson = bending / twisting - 1,
                     .density = 0,
                     .axial_over_bending = 0};
    const std::vector<Vec3> nodes = straight(links, length * links / (links - 1));
    Rod rod(def, nodes);
    std::vector<Vec3> aside(nodes.size(),
                            Vec3::Zero());  // a nudge in the middle says where it buckles, and is taken off at last
    for (int i = 2; i < links - 1; ++i)
        aside[static_cast<std::size_t>(i)] =
            1e-3 * std::exp(-std::pow(length * i / links - length / 2, 2)) * Vec3(0, 1, 0.3);
    for (int i = 0; i <= steps; ++i) {
        const Vec3 back(-slack * i / steps, 0, 0);
        const Hold clamps[] = {
            {0, nodes[0]}, {1, nodes[1]}, {links - 1, nodes[nodes.size() - 2] + back}, {links, nodes.back() + back}};
        settle(rod, {.holds = clamps,
                     .loads = i < steps ? std::span<const Vec3>(aside) : std::span<const Vec3>{},
                     .turn = 2 * pi * turns});
    }
    double steepest = 1;
    for (int i = 0; i < links; ++i) {
        const auto k = static_cast<std::size_t>(i);
        steepest = std::min(steepest, (rod.nodes()[k + 1] - rod.nodes()[k]).normalized().x());
    }
    return std::acos(steepest);
}

// Hung at both ends, `span` of its length apart.
struct Hung {
    double sag, pull;
};
Hung catenary(int links, double span) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) {
        const double u = static_cast<double>(i) / links;
        nodes.emplace_back(span * u, 0, -0.5 * std::sqrt(1 - span * span) * (1 - std::abs(2 * u - 1)));
    }
    Rod rod(hanging(1), nodes);
    const Hold ends[] = {{0, nodes.front()}, {links, nodes.back()}};
    settle(rod, {ends});
    double lowest = 0;
    for (const Vec3& p : rod.nodes()) lowest = std::min(lowest, p.z());
    return {-lowest, rod.hold_force(0).norm()};
}

// u of sinh(u) / u = 1 / span; the catenary's parameter is span / 2u.
Hung catenary_by_formula(double span) {
    double low = 1e-3, high = 10;
    for (int i = 0; i < 60; ++i)
        (std::sinh(0.5 * (low + high)) / (0.5 * (low + high)) < 1 / span ? low : high) = 0.5 * (low + high);
    const double a = span / (2 * low);
    return {a * (std::cosh(low) - 1), a * std::cosh(low)};
}

double bessel_j0(double x) {
    double sum = 1, term = 1;
    for (int k = 1; k < 30; ++k) sum += term *= -x * x / (4.0 * k * k);
    return sum;
}

// A hanging chain swings in its first mode J0(j0 sqrt(1 - s)), of frequency j0 / 2 sqrt(g / L): the mean of four
// periods.
constexpr double first_zero = 2.404825557695773, chain_gravity = 9.81;
double swing(int links, double tick) {
    constexpr double height = 1e-3;
    std::vector<Vec3> nodes{Vec3::Zero()};
    const double link = 1.0 / links;
    for (int i = 1; i <= links; ++i) {
        const double y = height * bessel_j0(first_zero * std::sqrt(1 - i * link));
        nodes.emplace_back(0, y, nodes.back().z() - std::sqrt(link * link - std::pow(y - nodes.back().y(), 2)));
    }
    Rod rod(hanging(chain_gravity), nodes);
    const Hold top[] = {{0, nodes[0]}};
    std::vector<double> crossings;
    double before = height;
    for (double t = tick; crossings.size() < 9; t += tick) {
        rod.step({top}, tick);
        const double y = rod.nodes().back().y();
        if ((y > 0) != (before > 0)) crossings.push_back(t - tick * y / (y - before));
        before = y;
    }
    return (crossings.back() - crossings.front()) / 4;
}

void add_bent(std::vector<RodCase>& cases) {
    // Elastica, by elliptic integrals: load over B / L^2, and weight over B / L^2.
    for (const auto& [load, drops] : {std::pair(1, 0.30172), std::pair(10, 0.81061)})
        cases.push_back({"cantilever-tip-" + std::to_string(load),
                         "cantilever, tip load " + std::to_string(load) + " B/L2: drop of the tip",
                         [=](int n) {
                             return Compared{drop(n, load, 0), drops};
                         },
                         0.01, 40});
    for (const auto& [weight, drops] : {std::pair(1, 0.12347), std::pair(10, 0.70020), std::pair(200, 0.95677)})
        cases.push_back({"cantilever-weight-" + std::to_string(weight),
                         "cantilever, weight " + std::to_string(weight) + " B/L2: drop of the tip",
                         [=](int n) {
                             return Compared{drop(n, 0, weight), drops};
                         },
                         0.01, 40});
    // F / F_cr = (2 K(k) / pi)^2 at the shortening 2 - 2 E / K.
    for (const auto& [percent, force] : {std::pair(1, 1.0050), std::pair(10, 1.0530), std::pair(50, 1.3495)})
        cases.push_back({"strut-" + std::to_string(percent),
                         "strut shortened by " + std::to_string(percent) + " %: force over Euler's",
                         [=](int n) {
                             return Compared{strut(n, 0.01 * percent), force};
                         },
                         0.03, 160});
}

void add_twisted(std::vector<RodCase>& cases) {
    // Michell 1889, Zajac 1962: 2 pi sqrt(3) B / C, with B / C = 1.3.
    cases.push_back({"ring-turn", "flat ring: turn at which it leaves its plane",
                     [](int n) {
                         return Compared{ring(n), 2 * pi * std::sqrt(3.0) * 1.3};
                     },
                     0.03, 160});
    // Greenhill 1883 with both ends clamped and no pull: the least root of x = tan x, twice.
    cases.push_back({"twisted-rod", "straight rod, clamped: moment at which it buckles",
                     [](int n) {
                         return Compared{twisted_straight(n), 2 * 4.493409457909064};
                     },
                     0.03, 160});
    cases.push_back({"helix-angle", "helix of a twisted rod let in by 3 %: steepest angle",
                     [](int n) {
                         return Compared{helix(n), 0.9186};
                     },
                     0.05, 160});
}

void add_hung(std::vector<RodCase>& cases) {
    for (const int percent : {50, 90, 99}) {
        const double span = 0.01 * percent;
        const Hung right = catenary_by_formula(span);
        const std::string id = "catenary-" + std::to_string(percent),
                          what = "catenary over " + std::to_string(percent) + " % of its length: ";
        cases.push_back({id + "-sag", what + "sag",
                         [=](int n) {
                             return Compared{catenary(n, span).sag, right.sag};
                         },
                         0.005, 40});
        cases.push_back({id + "-pull", what + "pull at its ends",
                         [=](int n) {
                             return Compared{catenary(n, span).pull, right.pull};
                         },
                         0.005, 40});
    }
    for (const auto& [name, tick] : {std::pair("1000us", 1e-3), std::pair("250us", 2.5e-4)}) {
        const double period = 2 * pi / (0.5 * first_zero * std::sqrt(chain_gravity));
        cases.push_back({"swing-" + std::string(name),
                         "hanging chain 1 m long, ticks of " + std::string(name) + ": period of its first mode",
                         [=, t = tick](int n) {
                             return Compared{swing(n, t), period};
                         },
                         0.005, 40});
    }
}

}  // namespace

std::vector<RodCase> rod_cases() {
    std::vector<RodCase> cases;
    add_bent(cases);
    add_twisted(cases);
    add_hung(cases);
    return cases;
}

}  // namespace bench::lab
