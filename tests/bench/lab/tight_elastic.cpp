#include "tests/bench/lab/tight_elastic.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/thread/thread.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/shape.hpp"
#include "tests/bench/lab/stopwatch.hpp"

namespace bench::lab {

namespace {

using sim::thread::Hold;
using sim::thread::Thread;
using sim::thread::ThreadDef;

constexpr double knotted_length = 100, tight_strain = 0.01;  // [D], [1]

// Bent about a strand of its own it pulls back with less than a hundredth of what pulls it tight: B / R^2 at R of a
// diameter against `pull_strain` of EA.
ThreadDef limp(double friction) {
    return {.friction = friction, .elastic = sim::thread::RodDef{.bending_share = 1e-3, .axial_over_bending = 0}};
}

double taken_up_by(const Thread& thread) {
    const std::span<const Vec3> x = thread.nodes();
    double along = 0;
    for (std::size_t k = 0; k + 1 < x.size(); ++k) along += (x[k + 1] - x[k]).norm();
    return (along - (x.back() - x.front()).norm()) / (2 * thread.def().radius);
}

// In a tick of so many seconds, either end goes out by so much along x [m], held so that it points there.
sim::thread::TickReport draw(Thread& thread, double by, double tick) {
    const std::span<const Vec3> x = thread.nodes();
    const int last = static_cast<int>(x.size()) - 1;
    const auto held = [&](int node, double way) {
        return Hold{node, x[static_cast<std::size_t>(node)] + way * Vec3::UnitX()};
    };
    const Hold holds[] = {held(0, -by), held(1, -by), held(last - 1, by), held(last, by)};
    constexpr int owners[] = {0, 0, 1, 1};
    return thread.tick({holds, owners, {}, nullptr, tick});
}

}  // namespace

TightElastic tight_elastic(double link_in_diameters, double friction, double tick) {
    constexpr double rest = 0.1, longest = 2, speed = 25;  // [s], [s], [D] in a second
    const ThreadDef def = limp(friction);
    const double diameter = 2 * def.radius, link = link_in_diameters * diameter;
    Thread thread(def, overhand(static_cast<int>(knotted_length / link_in_diameters), knotted_length * diameter));
    const double tight = tight_strain * def.elastic->axial_stiffness(link);
    const auto pull = [&] { return std::min(thread.tension()[1], thread.tension()[thread.tension().size() - 2]); };
    TightElastic result{.in_the_end = NAN};
    result.cost.links = static_cast<int>(thread.rest_lengths().size());
    const auto go = [&](double by) {
        result.pass_throughs += result.cost.of([&] { return draw(thread, by, tick); }).pass_throughs;
    };
    for (int i = ticks_in(rest, tick); i > 0; --i) go(0);
    for (int i = ticks_in(longest, tick); i > 0 && pull() < tight; --i) {
        go(speed * tick * diameter);
        result.least = std::min(result.least, taken_up_by(thread));
    }
    if (pull() >= tight) result.in_the_end = taken_up_by(thread);
    result.gap = Gauge(thread).gap(thread.nodes());
    return result;
}

std::vector<Row> tight_elastic_rows(bool quick) {
    // An ideal rope takes up 10.1 [surgery-and-physics.md, D11], links more for they are not a curve.
    constexpr double ideal = 10.1, more = 1.05, never = 10;
    std::vector<Row> rows;
    for (const int pieces : quick ? std::vector{1, 2} : std::vector{1, 2, 4})
        for (const double friction : {0.0, 0.15}) {
            const Stopwatch watch;
            const TightElastic found = tight_elastic(1.0 / pieces, friction);
            const std::string id =
                "elastic-tight-overhand-link" + std::to_string(pieces) + (friction > 0 ? "-mu15" : "-mu0");
            const std::string what = "elastic thread, tight open overhand, links of D/" + std::to_string(pieces) +
                                     (friction > 0 ? ", friction 0.15: " : ", no friction: ");
            rows.push_back({.id = id,
                            .what = what + "takes up",
                            .value = found.in_the_end,
                            .unit = "D",
                            .bound = more * ideal,
                            .error = {},
                            .seconds = watch.seconds()});
            rows.push_back({.id = id + "-least",
                            .what = what + "least at any time",
                            .value = found.least,
                            .unit = "D",
                            .bound = never,
                            .must = Must::be_at_least,
                            .error = {}});
            rows.push_back({.id = id + "-gap",
                            .what = what + "how far apart its strands' centre lines are",
                            .value = found.gap,
                            .unit = "D",
                            .bound = {},
                            .error = {}});
            rows.push_back({.id = id + "-by-gap",
                            .what = what + "takes up, over that",
                            .value = found.in_the_end / found.gap,
                            .unit = "ratio",
                            .bound = {},
                            .error = {}});
            rows.push_back({.id = id + "-passes",
                            .what = what + "pass-throughs",
                            .value = static_cast<double>(found.pass_throughs),
                            .unit = "count",
                            .bound = 0,
                            .error = {}});
        }
    return rows;
}

}  // namespace bench::lab
