#include "tests/bench/lab/cantilever.hpp"

#include <algorithm>
#include <cmath>

#include "sim/thread/thread.hpp"

namespace bench::lab {

namespace {

using sim::thread::Hold;
using sim::thread::Vec3;

// Straight along x, clamped in the middle of its first link, or of both end links: `clamps` of them.
struct Clamped {
    Clamped(const Setting& setting, int clamps)
        : tick(setting.tick),
          last(static_cast<int>(setting.link)),
          link(length / (last - 0.5 * clamps)),
          nodes(straight(last, link)),
          loads(nodes.size(), Vec3::Zero()),
          thread(def_of(setting), nodes) {}

    static sim::thread::RodDef material() { return {.axial_over_bending = 0}; }
    static double unit() { return material().bending_stiffness() / (length * length); }  // B / L^2 [N]

    static sim::thread::ThreadDef def_of(const Setting& setting) {
        sim::thread::ThreadDef def;
        if (setting.elastic) def.elastic = material();
        return def;
    }

    static std::vector<Vec3> straight(int links, double link) {
        std::vector<Vec3> nodes;
        for (int i = 0; i <= links; ++i) nodes.emplace_back(i * link, 0, 0);
        return nodes;
    }

    static constexpr double length = 100 * 2 * sim::thread::ThreadDef{}.radius;  // [m]
    double tick;
    int last;
    double link;
    std::vector<Vec3> nodes, loads;
    sim::thread::Thread thread;
};

}  // namespace

Compared cantilever(const Setting& setting, Cost& cost) {
    constexpr double seconds = 0.5, load = 10, elastica = 0.81061;
    Clamped c(setting, 1);
    cost.links = c.last;
    const Hold clamp[] = {{0, c.nodes[0]}, {1, c.nodes[1]}};
    constexpr int owners[] = {0, 0};
    c.loads.back().z() = -load * c.unit();
    for (int i = ticks_in(seconds, c.tick); i > 0; --i)
        cost.of([&] { return c.thread.tick({clamp, owners, {}, nullptr, c.tick, c.loads}); });
    return {-c.thread.nodes().back().z() / c.length, elastica};
}

// A weak load in the middle says where to it goes while the ends move, and is gone in the second half.
Compared let_in(const Setting& setting, Cost& cost) {
    constexpr double seconds = 0.5, slack = 0.03, nudge = 0.1, helix = 0.9186;
    Clamped c(setting, 2);
    cost.links = c.last;
    c.loads[static_cast<std::size_t>(c.last / 2)].z() = nudge * c.unit();
    const int ticks = ticks_in(seconds, c.tick);
    constexpr int owners[] = {0, 0, 1, 1};
    for (int i = 1; i <= ticks; ++i) {
        const Vec3 in = std::min(1.0, 2.0 * i / ticks) * slack * c.length * Vec3::UnitX();
        const Hold clamps[] = {{0, c.nodes[0]},
                               {1, c.nodes[1]},
                               {c.last - 1, c.nodes[c.nodes.size() - 2] - in},
                               {c.last, c.nodes.back() - in}};
        if (2 * i > ticks) c.loads.assign(c.nodes.size(), Vec3::Zero());
        cost.of([&] { return c.thread.tick({clamps, owners, {}, nullptr, c.tick, c.loads}); });
    }
    double steepest = 1;
    const auto x = c.thread.nodes();
    for (std::size_t k = 1; k < x.size(); ++k) steepest = std::min(steepest, (x[k] - x[k - 1]).normalized().x());
    return {std::acos(std::clamp(steepest, -1.0, 1.0)), helix};
}

}  // namespace bench::lab
