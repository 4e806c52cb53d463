#include "tests/bench/lab/strand_capstan.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "sim/thread/thread.hpp"
#include "tests/bench/lab/core.hpp"

namespace bench::lab {

namespace {

using sim::thread::Hold;
using sim::thread::Vec3;

using std::numbers::pi;

constexpr double strand_diameter = 1e-3, strand_link = 0.5 * strand_diameter, strand_friction = 0.2;  // [m]
constexpr double strand_load = 0.1;                                                                   // [N]
constexpr int bar_links = 40, lead_links = 240,
              tail_links =
                  260;  // links: of the strand that is held, from a hand to the half turn, and from there to the load

struct HungStrand {
    // The bar along y, slack far from all, and down from the hand to the half turn round the bar, and up again.
    HungStrand() {
        const double d = strand_diameter, out = strand_diameter;
        straight({0, -10 * d, 0}, {0, 10 * d, 0});
        straight({0, 10 * d, 0}, {0, 80 * d, 0});
        straight({0, 80 * d, 0}, {-40 * d, 80 * d, 0});
        straight({-40 * d, 80 * d, 0}, {-40 * d, 80 * d, 120 * d});
        straight({-40 * d, 80 * d, 120 * d}, {-out, 0, lead_links * strand_link});
        hand = static_cast<int>(nodes.size());
        straight({-out, 0, lead_links * strand_link}, {-out, 0, 0});
        const int arc = static_cast<int>(std::lround(pi * out / strand_link));
        for (int i = 0; i <= arc; ++i) nodes.push_back(out * Vec3(-std::cos(pi * i / arc), 0, -std::sin(pi * i / arc)));
        for (int i = 1; i <= tail_links; ++i) nodes.emplace_back(out, 0, i * strand_link);
    }

    // All but its end.
    void straight(const Vec3& from, const Vec3& to) {
        const int count = static_cast<int>(std::lround((to - from).norm() / strand_link));
        for (int i = 0; i < count; ++i) nodes.push_back(from + (to - from) * i / count);
    }

    std::vector<Vec3> nodes;
    int hand = 0;
};

sim::thread::Thread thread_of(const HungStrand& hung) {
    constexpr double strain = 1e-3, limp = 1e-3;  // stretched so much by the load; of the bending stiffness
    const double young = strand_load / strain / (pi * strand_diameter * strand_diameter / 4);
    return {{.radius = 0.5 * strand_diameter,
             .friction = strand_friction,
             .elastic = sim::thread::RodDef{.radius = 0.5 * strand_diameter,
                                            .young = young,
                                            .bending_share = limp,
                                            .friction = strand_friction,
                                            .density = 1000,
                                            .axial_over_bending = 0}},
            hung.nodes};
}

double friction_found(double speed, double tick) {
    constexpr double way = 20 * strand_diameter;  // slides over the second half of it
    const HungStrand hung;
    auto thread = thread_of(hung);
    std::vector<Hold> holds;
    for (int i = 0; i <= bar_links; ++i) holds.push_back({i, hung.nodes[static_cast<std::size_t>(i)]});
    holds.push_back({hung.hand, Vec3::Zero()});
    std::vector<int> owners(holds.size(), 0);
    owners.back() = 1;
    std::vector<Vec3> loads(hung.nodes.size(), Vec3::Zero());
    loads.back() = strand_load * Vec3::UnitZ();
    const auto hand = static_cast<std::size_t>(hung.hand);
    const int ticks = static_cast<int>(way / (speed * tick));
    double sum = 0;
    int count = 0;
    for (int t = 0; t < ticks; ++t) {
        holds.back().target = thread.nodes()[hand] + speed * tick * Vec3::UnitZ();
        thread.tick({.holds = holds, .hold_owners = owners, .capsules = {}, .seconds = tick, .loads = loads});
        if (2 * t >= ticks) sum += thread.tension()[hand] / thread.tension().back(), ++count;
    }
    return std::log(sum / count) / pi;
}

}  // namespace

std::vector<Row> strand_capstan_rows(bool quick) {
    std::vector<Row> rows;
    for (const double speed : {0.01, 0.1})
        for (const double tick : quick ? std::vector{1e-3} : std::vector{4e-3, 1e-3, 0.25e-3}) {
            const double begin = processor_time(), found = friction_found(speed, tick);
            const std::string us = std::to_string(std::lround(1e6 * tick)),
                              mm_s = std::to_string(std::lround(1000 * speed));
            rows.push_back({.id = "strand-capstan-" + mm_s + "-tick" + us,
                            .what = "elastic thread hung over a strand by half a turn, friction 0.2, drawn at " + mm_s +
                                    " mm/s, 1 mm thick, ticks of " + us + " us: friction that it slides by, off",
                            .value = 100 * std::abs(found / strand_friction - 1),
                            .unit = "%",
                            .bound = 10,
                            .error = {},
                            .seconds = processor_time() - begin});
        }
    return rows;
}

}  // namespace bench::lab
