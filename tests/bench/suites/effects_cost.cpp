#include <algorithm>
#include <array>

#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/plastic_set.hpp"
#include "tests/bench/lab/shape.hpp"
#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/lab/thread_rope.hpp"
#include "tests/bench/suites/speed.hpp"

// The overhand pull of 6-0 polypropylene, with each effect of drills the other way than it usually is. What an effect
// costs is told by its median tick over that of the thread that has none of what can be left out.
namespace bench::suites {

using namespace lab;

namespace {

using sim::thread::RodDef;

struct Variant {
    const char *id, *words;
    bool elastic;
    RodDef rod;
    std::vector<double> medians = {};  // of the pulls [us]
};

// Balance alone: no weight, no set, no mass, and hardly any stretch.
RodDef bare() {
    return {.quasi_static = true};
}

std::array<Variant, 6> variants() {
    std::array<Variant, 6> all{{{"ftl", "all off", false, {}},
                                {"bare", "bending alone", true, bare()},
                                {"gravity", "bending and gravity", true, bare()},
                                {"extension", "bending and extension", true, bare()},
                                {"plastic-set", "bending and plastic set", true, bare()},
                                {"inertia", "bending and inertia", true, bare()}}};
    all[2].rod.gravity = {0, 0, -9.81};
    all[3].rod.axial_over_bending = 0;
    all[4].rod.yield_strain = polypropylene_yield;
    all[5].rod.quasi_static = false;
    return all;
}

}  // namespace

void add_effects(Suite& suite, bool quick, const Progress& progress) {
    constexpr int links = 200, with = 1;
    constexpr double diameter = 2 * sim::thread::ThreadDef{}.radius, speed = 20 * diameter;  // 0.02 D a tick
    const int times = quick ? 1 : 5;
    std::array<Variant, 6> all = variants();
    const Stopwatch watch;
    double kept = 0, passes = 0;
    // In turns, so that what else the machine does falls on all of them.
    for (int i = 0; i < times; ++i)
        for (Variant& v : all) {
            if (progress) progress(std::string("effects: ") + v.words);
            const PullDef def{.links = links, .speed = speed, .length = links * diameter, .elastic = v.elastic};
            const auto start = overhand(def.links, def.length);
            ThreadRope rope(def, start, v.rod);
            const PullFigures found = pull(rope, def, start);
            v.medians.push_back(found.tick_p50);
            kept += found.knot_kept, passes += found.pass_throughs;
        }
    const double bare = percentile(all[with].medians, 0.5);
    for (const Variant& v : all) {
        const std::string id = std::string("effects-") + v.id,
                          what = std::string("overhand pull of 6-0, 200 links, ") + v.words;
        suite.rows.push_back(
            told(id + "-p50", what + ": median tick", percentile(v.medians, 0.5), "us", watch.seconds()));
        if (&v > &all[with])
            suite.rows.push_back(told(id + "-ratio", what + ": over that of bending alone",
                                      percentile(v.medians, 0.5) / bare, "ratio", watch.seconds()));
    }
    suite.rows.push_back({.id = "effects-kept",
                          .what = "overhand pulls with each effect on and off: knots kept",
                          .value = kept / (times * static_cast<double>(all.size())),
                          .unit = "share",
                          .bound = 1,
                          .must = Must::be_at_least,
                          .error = {}});
    suite.rows.push_back({.id = "effects-passes",
                          .what = "the same: pass-throughs",
                          .value = passes,
                          .unit = "count",
                          .bound = 0,
                          .error = {}});
}

}  // namespace bench::suites
