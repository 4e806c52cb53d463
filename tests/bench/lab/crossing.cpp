#include "tests/bench/lab/crossing.hpp"

#include <algorithm>
#include <cmath>

#include "sim/geometry/closest_points.hpp"
#include "sim/thread/thread.hpp"
#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/defaults.hpp"

namespace bench::lab {

namespace {

using sim::thread::Hold;
using sim::thread::RodDef;
using sim::thread::Thread;
using sim::thread::Vec3;

// Slopes stay below a twelfth: the elastica's tip then is lower by 0.3 % than the beam's (table D2).
constexpr double lower_arm = 100 * default_diameter, upper_arm = 150 * default_diameter,
                 overlap = 10 * default_diameter;
constexpr int beyond = 3;  // links that are free past the one that crosses

// Along the thread: lower arm from its free end to its clamp at the origin, a piece that is held all along, upper arm
// from its clamp.
struct Brackets {
    explicit Brackets(const Crossing& crossing)
        : links(crossing.links), low(link(crossing, lower_arm)), high(link(crossing, upper_arm)) {
        const Vec3 clamp(lower_arm, -upper_arm, default_diameter);
        for (int i = links + beyond; i >= 0; --i) nodes.emplace_back((i - 0.5) * low, 0, 0);
        lower_clamp = static_cast<int>(nodes.size()) - 2;
        const Vec3 from = nodes.back(), to = clamp - 0.5 * high * Vec3::UnitY();
        const int between = static_cast<int>(std::ceil((to - from).norm() / low));
        for (int i = 1; i <= between; ++i) nodes.push_back(from + i * (to - from) / between);
        upper_clamp = static_cast<int>(nodes.size()) - 1;
        for (int i = 1; i <= links + beyond; ++i) nodes.push_back(clamp + (i - 0.5) * high * Vec3::UnitY());
    }

    // The clamp is in the middle of the first link.
    static double link(const Crossing& crossing, double arm) {
        return arm / (crossing.at_nodes ? crossing.links - 0.5 : crossing.links);
    }

    // All that is held, the upper clamp lowered by so much.
    std::vector<Hold> holds(double by) const {
        std::vector<Hold> found;
        for (int i = lower_clamp; i <= upper_clamp + 1; ++i) {
            const double share =
                std::clamp(static_cast<double>(i - lower_clamp - 1) / (upper_clamp - lower_clamp - 1), 0.0, 1.0);
            found.push_back({i, nodes[static_cast<std::size_t>(i)] - share * by * Vec3::UnitZ()});
        }
        return found;
    }

    int links;
    double low, high;  // links of both arms [m]
    std::vector<Vec3> nodes;
    int lower_clamp, upper_clamp;  // first nodes of clamped links
};

Vec3 node(const Thread& thread, int i) {
    return thread.nodes()[static_cast<std::size_t>(i)];
}

// Where the arms are nearest to each other: the lower's place and the upper's.
sim::geometry::ClosestPair nearest(const Thread& thread, const Brackets& brackets) {
    sim::geometry::ClosestPair least{
        .s = 0, .t = 0, .on_a = Vec3::Zero(), .on_b = Vec3::Zero(), .distance_squared = 1e300};
    for (int i = 0; i < brackets.lower_clamp; ++i)
        for (int j = brackets.upper_clamp + 1; j + 1 < static_cast<int>(thread.nodes().size()); ++j) {
            const auto pair = sim::geometry::closest_points(node(thread, i), node(thread, i + 1), node(thread, j),
                                                            node(thread, j + 1));
            if (pair.distance_squared < least.distance_squared) least = pair;
        }
    return least;
}

// From the bend at the node where the clamp ends, half a link from its middle.
double force_at_clamp(const Thread& thread, const Brackets& brackets) {
    const int n = brackets.lower_clamp;
    const auto along = [&](int from) { return (node(thread, from + 1) - node(thread, from)).normalized(); };
    const double moment = RodDef{}.bending_stiffness() * (along(n) - along(n - 1)).norm() / brackets.low;
    return moment / (lower_arm - 0.5 * brackets.low);
}

}  // namespace

Crossed cross(const Crossing& crossing, double seconds) {
    constexpr int lowered_in = 200, rested_in = 700;
    const Brackets brackets(crossing);
    Thread thread({.friction = 0, .elastic = RodDef{.axial_over_bending = 0}}, brackets.nodes);
    const std::vector<int> owners(brackets.holds(0).size(), -1);
    const auto run = [&](int from, int to) {
        for (int t = from; t < to; ++t) {
            const std::vector<Hold> holds = brackets.holds(overlap * std::min(1.0, (t + 1.0) / lowered_in));
            thread.tick({.holds = holds, .hold_owners = owners, .capsules = {}, .seconds = default_tick});
        }
    };
    run(0, rested_in);
    const auto pair = nearest(thread, brackets);
    const std::vector<Vec3> rested(thread.nodes().begin(), thread.nodes().end());
    run(rested_in, rested_in + static_cast<int>(seconds / default_tick));
    double drift = 0;
    for (std::size_t i = 0; i < rested.size(); ++i) drift = std::max(drift, (thread.nodes()[i] - rested[i]).norm());
    const double cubes = std::pow(lower_arm, 3) + std::pow(upper_arm, 3);
    return {.lift = {pair.on_b.z() - (default_diameter - overlap), overlap * std::pow(upper_arm, 3) / cubes},
            .force = {force_at_clamp(thread, brackets), 3 * RodDef{}.bending_stiffness() * overlap / cubes},
            .apart = std::sqrt(pair.distance_squared) / default_diameter,
            .drift = drift / default_diameter};
}

std::vector<Row> crossing_rows(bool quick) {
    const double seconds = quick ? 1 : 10;
    std::vector<Row> rows;
    for (const bool at_nodes : {true, false})
        for (const int links : quick ? std::vector{20} : std::vector{20, 40, 80}) {
            const double begin = processor_time();
            const Crossed found = cross({links, at_nodes}, seconds);
            const std::string id = "elastic-crossing-n" + std::to_string(links) + (at_nodes ? "-nodes" : "-middles");
            const std::string what = "elastic thread across itself, arms of " + std::to_string(links) +
                                     " links that touch at their " + (at_nodes ? "nodes: " : "middles: ");
            const auto add = [&](const char* name, const char* of, double value, const char* unit, double bound) {
                rows.push_back(
                    {.id = id + name, .what = what + of, .value = value, .unit = unit, .bound = bound, .error = {}});
            };
            add("-lift", "error of the lift", 100 * std::abs(found.lift.error()), "%", 2);
            add("-force", "error of the force", 100 * std::abs(found.force.error()), "%", 2);
            add("-apart", "how much farther apart than it is thick", std::abs(found.apart - 1), "D",
                0.05);  // a thread keeps its strands 0.045 D clear
            add("-drift", "drift in the seconds after", found.drift, "D", 0.01);
            rows.back().seconds = processor_time() - begin;
        }
    return rows;
}

}  // namespace bench::lab
