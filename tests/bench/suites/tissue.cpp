#include "tests/bench/suites/tissue.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/needle_drive.hpp"
#include "tests/bench/lab/tissue_cases.hpp"
#include "tests/bench/lab/tissue_pull.hpp"
#include "tests/bench/lab/words.hpp"

namespace bench::suites {

using namespace lab;

namespace {

constexpr double shipped_bound = 5, refined_bound = 2;  // of a radius and of a force [%]

// Measures, and says how long that took.
template <class Measure>
Row row_of(const std::string& id, const std::string& what, const std::string& unit, const Measure& measure,
           std::optional<double> bound = {}, Must must = Must::be_at_most) {
    const double begin = processor_time(), value = measure();
    return {.id = id,
            .what = what,
            .value = value,
            .unit = unit,
            .bound = bound,
            .must = must,
            .error = {},
            .seconds = processor_time() - begin};
}

double percent(const Compared& compared) {
    return 100 * std::abs(compared.error());
}

void add_patches(Suite& suite) {
    struct Named {
        const char* name;
        Deformation mode;
    };
    for (const auto& [name, mode] : {Named{"uniaxial", Deformation::uniaxial},
                                     {"equibiaxial", Deformation::equibiaxial},
                                     {"pure-shear", Deformation::pure_shear}})
        for (const double stretch : {0.8, 0.9, 1.05, 1.1, 1.2, 1.3, 1.5, 2.0}) {
            const std::string percents = whole(100 * stretch);
            suite.rows.push_back(row_of(
                std::string(name) + "-" + percents,
                std::string(name) + " pull to " + percents + " %: error of the stress", "%",
                [&, p = mode] { return percent(patch_stress(p, stretch)); }, 2));
        }
}

// How far the radius's growth is off at most, over the five pressures.
double add_pressures(Suite& suite, const Resolution& resolution, double axial, std::optional<double> bound) {
    const std::string id = "pressure-axial" + whole(100 * axial) + "-n" + std::to_string(resolution.around) +
                           (resolution.locks ? "-locks" : "");
    const std::string what = "tube under pressure, " + whole(100 * axial) + " % as long, " +
                             std::to_string(resolution.around) + " cells around and " +
                             std::to_string(resolution.through) + " through" +
                             (resolution.locks ? ", volume kept by each tetrahedron" : "") + ": ";
    double worst = 0;
    for (const double stretch : {1.05, 1.1, 1.2, 1.3, 1.5}) {
        suite.rows.push_back(row_of(
            id + "-radius" + whole(100 * stretch), what + "error of the radius at " + whole(100 * stretch) + " %", "%",
            [&] {
                const Compared found = inflated_radius(resolution, stretch, axial);
                worst = std::max(worst, 100 * std::abs((found.found - 1) / (found.reference - 1) - 1));
                return percent(found);
            },
            bound));
    }
    suite.rows.push_back({.id = id + "-growth",
                          .what = what + "largest error of its growth",
                          .value = worst,
                          .unit = "%",
                          .bound = {},
                          .error = {}});
    return worst;
}

void add_tubes(Suite& suite, bool quick) {
    for (const double axial : {1.0, 1.2}) {
        add_pressures(suite, {8, 1}, axial, {});
        const double shipped = add_pressures(suite, {16, 2}, axial, shipped_bound);
        add_pressures(suite, {16, 2, true}, axial, {});
        if (quick) continue;
        const double refined = add_pressures(suite, {32, 4}, axial, refined_bound);
        suite.rows.push_back({.id = "pressure-axial" + whole(100 * axial) + "-order",
                              .what = "tube under pressure, " + whole(100 * axial) +
                                      " % as long: order of the growth's error from 16 to 32 cells around",
                              .value = std::log2(shipped / refined),
                              .unit = "order",
                              .bound = {},
                              .error = {}});
    }
    for (const Resolution& resolution : {Resolution{8, 1}, Resolution{16, 2}})
        for (const double stretch : {1.05, 1.1, 1.2, 1.5}) {
            const std::string n = std::to_string(resolution.around), to = whole(100 * stretch);
            suite.rows.push_back(row_of(
                "clamped-n" + n + "-" + to,
                "clamped tube drawn to " + to + " %, " + n + " cells around: error of the force in its middle", "%",
                [&] { return percent(clamped_force(resolution, stretch)); }, shipped_bound));
        }
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// The edge of the cut, pulled along the axis, and how far the bite opens, against what meshes of the drill's fineness
// and twice that come to if the error falls with the square.
void add_edge(Suite& suite, bool quick) {
    for (const double force : {0.02, 0.1}) {
        const std::string id = whole(1000 * force) + "mN", at = " of a cut pulled at " + whole(1000 * force) + " mN: ";
        const PulledVessel shipped = pulled(VesselPull(vessel()), force),
                           finer = pulled(VesselPull(vessel(quick ? 1.5 : 2)), force);
        const auto limit = [&](const auto& coarse, const auto& fine) -> std::decay_t<decltype(coarse)> {
            const double ratio = quick ? 2.25 : 4;  // of the squares of cells
            return (ratio * fine - coarse) / (ratio - 1);
        };
        const PulledVessel reference{limit(shipped.edge, finer.edge), limit(shipped.opening, finer.opening)};
        const auto tell = [&](const std::string& mesh, const std::string& words, const PulledVessel& found) {
            const auto add = [&](const std::string& of, double error) {
                suite.rows.push_back({.id = of + "-" + id + mesh,
                                      .what = of + at + words + ", error",
                                      .value = 100 * error,
                                      .unit = "%",
                                      .bound = {},
                                      .error = {}});
            };
            add("edge", (found.edge - reference.edge).norm() / reference.edge.norm());
            add("bite", std::abs(found.opening / reference.opening - 1));
        };
        suite.rows.push_back({.id = "edge-" + id + "-way",
                              .what = "edge" + at + "its way",
                              .value = 1000 * reference.edge.norm(),
                              .unit = "mm",
                              .bound = {},
                              .error = {}});
        suite.rows.push_back({.id = "bite-" + id + "-way",
                              .what = "bite" + at + "by how much its 2 mm of wall are longer",
                              .value = 1000 * reference.opening,
                              .unit = "mm",
                              .bound = {},
                              .error = {}});
        for (const double fine : {0.5, 0.75, 1.5}) {
            const std::string around = std::to_string(vessel(fine).around);
            tell("-n" + around, around + " cells around", pulled(VesselPull(vessel(fine)), force));
        }
        tell("-n16", "16 cells around as shipped", shipped);
        tell("-n16-locks", "16 cells around, volume kept by each tetrahedron",
             pulled(VesselPull(vessel(), true), force));
    }
}

// The same with all cells as short as those near the cut: what long ones cost in accuracy and save in time.
void add_far(Suite& suite) {
    tissue::TubeDef full = vessel();
    full.far = static_cast<int>(std::lround((full.length - full.near_length) / full.near_length * full.near));
    const VesselPull pull(full);
    for (const double force : {0.005, 0.02, 0.1}) {
        const tissue::Vec3 reference = pulled(pull, force).edge;
        for (const int far : {2, 3, 4, 6}) {
            tissue::TubeDef def = vessel();
            const bool shipped = def.far == far;
            def.far = far;
            suite.rows.push_back(row_of(
                "far" + std::to_string(far) + "-" + whole(1000 * force) + "mN",
                std::to_string(far) + " long cells for " + std::to_string(full.far) +
                    " short ones far from the cut: edge pulled at " + whole(1000 * force) + " mN, error",
                "%", [&] { return 100 * (pulled(VesselPull(def), force).edge - reference).norm() / reference.norm(); },
                shipped && force >= 0.02 ? std::optional(2.0) : std::nullopt));
        }
    }
    const auto mean = [](const VesselPull& of) { return mean_of(play(of, {}, 0.03, 2e-3).us); };
    suite.rows.push_back({.id = "far4-saves",
                          .what = "mean step with 4 long cells for 8 short ones, over one with those",
                          .value = mean(VesselPull(vessel())) / mean(pull),
                          .unit = "ratio",
                          .bound = {},
                          .error = {}});
}

struct Stepping {
    double seconds;
    int iterations, steps_per_factor;
};

// A second of pulling, step by step, against Newton's method until it has converged, in the same steps.
void add_steps(Suite& suite, double finer, double force, const Stepping& stepping, const Played& exact, bool bounded) {
    const std::string around = std::to_string(vessel(finer).around), ms = whole(1000 * stepping.seconds),
                      mN = whole(1000 * force);
    const std::string id = "pull-n" + around + "-" + mN + "mN-step" + ms + "-moves" +
                           std::to_string(stepping.iterations) + "-factor" + std::to_string(stepping.steps_per_factor);
    const std::string what =
        "a second of pulling at " + mN + " mN, " + around + " cells around, steps of " + ms + " ms, " +
        std::to_string(stepping.iterations) + (stepping.iterations == 1 ? " move, " : " moves, ") +
        (stepping.steps_per_factor ? "factored in " + std::to_string(stepping.steps_per_factor) + " steps: "
                                   : "factored for each: ");
    const Played found = play(VesselPull(vessel(finer)),
                              {.iterations = stepping.iterations, .steps_per_factor = stepping.steps_per_factor}, force,
                              stepping.seconds);
    const Lag off = apart(found, exact);
    const auto add = [&](const char* name, const char* of, double value, const char* unit,
                         std::optional<double> bound = {}) {
        suite.rows.push_back({.id = id + name,
                              .what = what + of,
                              .value = value,
                              .unit = unit,
                              .bound = bounded ? bound : std::nullopt,
                              .error = {}});
    };
    add("-off", "edge off at most, of its way", 100 * off.most, "%");
    add("-off-rms", "edge off, root mean square", 100 * off.mean, "%");
    add("-mean", "mean step", mean_of(found.us), "us", 300);
    add("-p50", "median step", percentile(found.us, 0.5), "us");
    add("-p99", "99 of 100 steps", percentile(found.us, 0.99), "us", 500);
    add("-worst", "slowest step after the first", percentile(found.us, 1), "us");
    add("-over-newton", "mean step over one of Newton's method until it converges",
        mean_of(found.us) / mean_of(exact.us), "ratio");
}

// Threshold of the skin against a finger in the lumen, where the wall cannot give way at large; and D24, the wall free,
// driven all through.
void add_needle(Suite& suite, bool quick) {
    const struct {
        const char* name;
        tissue::TubeDef tube;
    } meshes[] = {{"n12", {.around = 12, .through = 1, .near = 6, .far = 3}},
                  {"n16", {}},
                  {"n24", {.around = 24, .through = 3, .near = 12, .far = 6}}};
    const auto mm_s = [](double speed) { return whole(1000 * speed); };
    for (const auto& [name, tube] : meshes)
        for (const double speed : {1e-3, 5e-3, 20e-3}) {
            if (quick && tube.around == 24 && speed < 5e-3) continue;
            constexpr double puncture = 10e-3;
            suite.rows.push_back(row_of(
                std::string("puncture-") + name + "-" + mm_s(speed),
                std::string("needle at ") + mm_s(speed) + " mm/s, " + whole(tube.around) +
                    " cells around: force at which the skin gave way off its threshold",
                "%",
                [&, t = tube] {
                    return 100 * std::abs(drive_through({.puncture = puncture}, t, speed, true).entry / puncture - 1);
                },
                10));
        }
    for (const double speed : {1e-3, 5e-3, 20e-3}) {
        const double begin = processor_time(), wire = 2e6 * Swing{}.wire;
        const Driven driven = drive_through({}, {}, speed, false);
        const double seconds = processor_time() - begin;
        const auto add = [&](const char* id, const char* what, double value, const char* unit,
                             std::optional<double> bound, Must must = Must::be_at_most) {
            suite.rows.push_back(
                {.id = "needle-" + std::string(id) + "-" + mm_s(speed),
                 .what = "needle driven along its arc at " + mm_s(speed) + " mm/s through a free end: " + what,
                 .value = value,
                 .unit = unit,
                 .bound = bound,
                 .must = must,
                 .error = {},
                 .seconds = seconds});
        };
        add("aside", "way of the wall across the wire where its holes are, in wires",
            driven.drawn ? 1e6 * driven.aside / wire : 1, "wires", 0.1);
        add("off", "where it was pierced lies off the arc when nothing pulls, in wires", 1e6 * driven.off / wire,
            "wires", {});
        add("entry", "force at which the outer skin gave way off its threshold",
            100 * std::abs(driven.entry / tissue::BiteDef{}.puncture - 1), "%", {});
        add("exit", "force at which the inner skin gave way off its threshold",
            100 * std::abs(driven.exit / tissue::BiteDef{}.puncture - 1), "%", {});
        add("drawn", "all of it through, 1", driven.drawn, "count", 1, Must::be_at_least);
    }
}

void add_stiff(Suite& suite) {
    for (const int forces : {0, 10, 100})
        suite.rows.push_back(row_of("stiff-" + std::to_string(forces),
                                    "mean step of 2 ms with " + std::to_string(forces) + " stiff forces", "us",
                                    [&] { return stiff_step(forces); }));
}

// Two vessels of which each tick of a millisecond moves one: a step of 2 ms may take what a tick has, 0.3 ms and at
// most 0.5.
void add_speed(Suite& suite, bool quick) {
    const tissue::Solver newton{.iterations = 60, .steps_per_factor = 0, .tolerance = 1e-8};
    const double shipped_step = 2e-3;
    const tissue::Solver shipped;
    for (const double force : {0.03, 0.1})
        for (const double seconds : quick ? std::vector{2e-3} : std::vector{1e-3, 2e-3, 4e-3}) {
            const Played exact = play(VesselPull(vessel()), newton, force, seconds);
            for (const auto& [iterations, steps] : {std::pair{1, 0}, {1, 4}, {1, 8}, {1, 16}, {2, 16}, {1, 1000000}}) {
                const bool is_shipped =
                    seconds == shipped_step && iterations == shipped.iterations && steps == shipped.steps_per_factor;
                if (!quick || is_shipped) add_steps(suite, 1, force, {seconds, iterations, steps}, exact, is_shipped);
            }
        }
    if (quick) return;
    suite.rows.push_back(
        row_of("pull-n32-30mN-step2-moves1-factor8-mean",
               "a second of pulling at 30 mN, 32 cells around, steps of 2 ms, 1 move, factored in 8 steps: mean step",
               "us", [&] { return mean_of(play(VesselPull(vessel(2)), shipped, 0.03, shipped_step).us); }));
    for (const double finer : {0.5, 0.75, 1.5})
        add_steps(suite, finer, 0.03, {shipped_step, shipped.iterations, shipped.steps_per_factor},
                  play(VesselPull(vessel(finer)), newton, 0.03, shipped_step), false);
}

}  // namespace

Suite tissue_suite(bool quick, const Progress& progress) {
    Suite suite{"tissue", {}};
    const auto at = [&](const char* what) {
        if (progress) progress(what);
    };
    const OneCore core;
    at("patches");
    add_patches(suite);
    at("tubes");
    add_tubes(suite, quick);
    at("the edge of a cut");
    add_edge(suite, quick);
    at("cells far from the cut");
    add_far(suite);
    at("needle");
    add_needle(suite, quick);
    at("stiff forces");
    add_stiff(suite);
    at("steps");
    add_speed(suite, quick);
    return suite;
}

}  // namespace bench::suites
