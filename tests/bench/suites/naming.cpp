#include "tests/bench/suites/naming.hpp"

#include <cmath>
#include <utility>

#include "sim/knot/namer.hpp"
#include "tests/bench/lab/capsized.hpp"
#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/curves.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/hands.hpp"
#include "tests/bench/lab/hitches.hpp"
#include "tests/bench/lab/knots.hpp"
#include "tests/bench/lab/loop.hpp"
#include "tests/bench/lab/random.hpp"
#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/lab/ties.hpp"

namespace bench::suites {

using namespace lab;

namespace {

using sim::knot::Component;
using sim::knot::LinkName;

// What names turned out to be, and what they cost.
struct Tally {
    int all = 0, wrong = 0, unknown = 0;
    std::vector<double> us;

    LinkName name(const std::vector<Component>& components) {
        const double begin = processor_time();
        LinkName link = sim::knot::name_link(components);
        us.push_back(1e6 * (processor_time() - begin));
        return link;
    }
    // The form only of a curve that was made in one.
    void expect(const std::vector<Component>& components, const LinkName& expected, const LabelledCurve& curve) {
        const bool has_form = curve.label.contains("form") && curve.label["form"].is_string();
        const LinkName found = name(components);
        ++all;
        if (found.name.knot == "unknown" || !found.name.certain)
            ++unknown;
        else
            wrong += found.name.knot != expected.name.knot || found.name.surgical != expected.name.surgical ||
                     found.name.throws != expected.name.throws || (has_form && found.name.flat != expected.name.flat);
    }
};

Row count(std::string id, std::string what, double value, double bound) {
    return {.id = std::move(id), .what = std::move(what), .value = value, .unit = "count", .bound = bound, .error = {}};
}
Row share(std::string id, std::string what, double value, double bound) {
    return {.id = std::move(id),
            .what = std::move(what),
            .value = value,
            .unit = "share",
            .bound = bound,
            .must = Must::be_at_least,
            .error = {}};
}
Row time(std::string id, std::string what, double us, std::optional<double> bound) {
    return {.id = std::move(id), .what = std::move(what), .value = us, .unit = "us", .bound = bound, .error = {}};
}

void add_wrong(Suite& suite, const std::string& id, const std::string& what, const Tally& tally) {
    const std::string words = std::to_string(tally.all) + ' ' + what;
    suite.rows.push_back(
        count(id + "-wrong", words + ": another name, surgically too, other throws or form", tally.wrong, 0));
    suite.rows.push_back(count(id + "-unknown", words + ": unknown or not certain", tally.unknown, 0));
}

std::vector<Component> turned(std::vector<Component> components, std::uint64_t seed) {
    Random random(seed);
    sim::geometry::Quat turn;  // of numbers in a ball: all attitudes alike
    do
        for (double& x : turn.coeffs()) x = random.between(-1, 1);
    while (turn.norm() > 1 || turn.norm() < 0.1);
    turn.normalize();
    for (Component& c : components)
        for (auto& p : c.vertices) p = turn * p;
    return components;
}

// Every edge cut into one to three pieces, anyhow.
std::vector<Component> cut_finer(std::vector<Component> components, std::uint64_t seed) {
    Random random(seed);
    for (Component& c : components) {
        std::vector<Vec3> finer;
        for (std::size_t i = 0; i + 1 < c.vertices.size(); ++i) {
            finer.push_back(c.vertices[i]);
            const int pieces = 1 + random.below(3);
            for (int k = 1; k < pieces; ++k)
                finer.push_back(c.vertices[i] +
                                (k - 0.5 * random.between(0, 1)) / pieces * (c.vertices[i + 1] - c.vertices[i]));
        }
        finer.push_back(c.vertices.back());
        c.vertices = std::move(finer);
    }
    return components;
}

void add_curves(Suite& suite, const std::vector<LabelledCurve>& curves) {
    constexpr int times = 5;  // the fastest counts: others' work on the machine does not
    Tally tally;
    std::vector<double> us;
    for (const LabelledCurve& curve : curves) {
        double best = 1e300;
        for (int i = 0; i < times; ++i) {
            tally.name(curve.components);
            best = std::min(best, tally.us.back());
        }
        us.push_back(best);
        if (!curve.is_definite()) continue;
        const LinkName link = sim::knot::name_link(curve.components);
        ++tally.all;
        tally.wrong += link.name.knot != curve.label["canonical"];
        tally.unknown += !link.name.certain;
    }
    add_wrong(suite, "curves", "labelled curves", tally);
    suite.rows.push_back(time("curves-median", "labelled curves: median", percentile(us, 0.5), 200));
    suite.rows.push_back(time("curves-p99", "labelled curves: 99 of 100", percentile(us, 0.99), 2000));
    suite.rows.push_back(time("curves-worst", "labelled curves: slowest", percentile(us, 1), {}));
}

void add_turned(Suite& suite, const std::vector<LabelledCurve>& curves, bool quick) {
    const int turns = quick ? 2 : 100, cuts = quick ? 1 : 20, many = quick ? 20 : 10000;
    Tally tally, finer;
    for (const LabelledCurve& curve : curves) {
        if (!curve.is_definite()) continue;
        const LinkName expected = sim::knot::name_link(curve.components);
        for (int i = 0; i < turns; ++i)
            tally.expect(turned(curve.components, static_cast<std::uint64_t>(i)), expected, curve);
        for (int i = 0; i < cuts; ++i)
            finer.expect(cut_finer(curve.components, static_cast<std::uint64_t>(i)), expected, curve);
    }
    add_wrong(suite, "turned", "labelled curves in any attitude", tally);
    suite.rows.push_back(
        time("turned-p99", "labelled curves in any attitude: 99 of 100", percentile(tally.us, 0.99), {}));
    add_wrong(suite, "finer", "labelled curves with edges cut anyhow", finer);

    constexpr const char* twelve[] = {"p100", "p127", "p102", "p103", "p105", "p109",
                                      "p111", "p113", "p115", "p117", "p126", "p129"};
    Tally knots;
    for (const LabelledCurve& curve : curves) {
        if (std::find(std::begin(twelve), std::end(twelve), curve.id) == std::end(twelve)) continue;
        const LinkName expected = sim::knot::name_link(curve.components);
        for (int i = 0; i < many; ++i)
            knots.expect(turned(curve.components, static_cast<std::uint64_t>(i)), expected, curve);
    }
    add_wrong(suite, "twelve", "attitudes of twelve surgical and working knots", knots);
}

// 20 to 2000 vertices, in a cube or one step after the other, open and closed.
std::vector<Component> polygon(std::uint64_t seed) {
    Random random(seed);
    const int vertices = static_cast<int>(20 * std::pow(100, random.between(0, 1)));
    const bool walks = random.below(2), closed = random.below(2);
    std::vector<Vec3> points{Vec3::Zero()};
    for (int i = 1; i < vertices; ++i) {
        const Vec3 drawn(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        points.push_back(walks ? Vec3(points.back() + drawn) : drawn);
    }
    return {{points, closed}};
}

void add_polygons(Suite& suite, bool quick) {
    const int polygons = quick ? 20 : 1000;
    Tally tally;
    for (int seed = 0; seed < polygons; ++seed)
        tally.unknown += tally.name(polygon(static_cast<std::uint64_t>(seed))).name.knot == "unknown";
    const std::string words = std::to_string(polygons) + " random polygons of 20 to 2000 vertices: ";
    suite.rows.push_back(
        share("polygons-named", words + "named", 1 - tally.unknown / static_cast<double>(polygons), 0));
    suite.rows.push_back(time("polygons-p99", words + "99 of 100", percentile(tally.us, 0.99), 50000));
    suite.rows.push_back(time("polygons-worst", words + "slowest", percentile(tally.us, 1), {}));
}

// The thread of a drill: 300 links, a square knot pulled tight by its tails.
void add_thread(Suite& suite) {
    constexpr double step = 0.05e-3, diameter = 2 * ThreadDef{}.radius;  // [m]
    constexpr int ticks = 1500, times = 50;
    Loop loop({}, loose_thread(looped(Knot::square, loop_depth), 300, diameter, 0.5 * diameter).nodes);
    for (int i = 0; i < ticks; ++i) loop.pull_tails(step);
    const std::vector<Component> thread{{{loop.thread.nodes().begin(), loop.thread.nodes().end()}, false}};
    Tally tally;
    for (int i = 0; i < times; ++i) tally.name(thread);
    suite.rows.push_back(
        time("thread-300", "thread of 300 links with a tight square knot: median", percentile(tally.us, 0.5), 300));
}

void add_capsized(Suite& suite, bool quick) {
    const int pulls = quick ? 4 : 200;
    int flat = 0, capsized = 0;
    for (int seed = 0; seed < pulls; ++seed) {
        flat += sim::knot::name_knot(pulled(Pull::tails, static_cast<std::uint64_t>(seed))).flat;
        capsized += !sim::knot::name_knot(pulled(Pull::one_strand, static_cast<std::uint64_t>(seed))).flat;
    }
    const std::string words = std::to_string(pulls) + " square and granny knots, ";
    suite.rows.push_back(share("flat-right", words + "pulled tight by both tails: called flat",
                               flat / static_cast<double>(pulls), 0.95));
    suite.rows.push_back(share("capsized-right", words + "one strand pulled straight: called capsized",
                               capsized / static_cast<double>(pulls), 0.95));
}

// Names of knots being tied, 50 a second: none ever changes, for the thread never passes through itself and ends are
// led out straight. A flicker is a name for less than 50 ms between two that are equal.
void add_ties(Suite& suite, bool quick) {
    constexpr int period = 20;  // [ticks]
    const int seeds = quick ? 3 : 300;
    int names = 0, other = 0, flickers = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        int tick = 0;
        std::string was[2], expected;
        ties(static_cast<std::uint64_t>(seed), [&](const Thread& thread, int first, int last) {
            if (tick++ % period != 0) return;
            const std::string now = name_between(thread, first, last);
            if (expected.empty()) expected = now;
            ++names;
            other += now != expected;
            flickers += now == was[0] && now != was[1];
            was[0] = std::exchange(was[1], now);
        });
    }
    const std::string words = std::to_string(names) + " names of " + std::to_string(seeds) + " seeded ties: ";
    suite.rows.push_back(count("ties-other", words + "others than at first, or not certain", other, 0));
    suite.rows.push_back(
        count("ties-flickers", words + "there between two equal ones for less than 50 ms", flickers, 0));
}

// The seed's figures, and the other hitches, tied by the simulator.
void add_on_bar(Suite& suite, const std::filesystem::path& folder) {
    for (const std::string& curve : curves_on_bar()) {
        const OnBar tied = hitch_on_bar(folder, curve);
        const std::string words =
            tied.expected + " pulled tight round a bar: other names of " + std::to_string(tied.names);
        suite.rows.push_back(count("on-bar-" + tied.curve, words, tied.other + tied.pass_throughs, 0));
    }
}

// What a name costs by the number of vertices: a square knot, its edges cut.
void add_growth(Suite& suite, const std::vector<LabelledCurve>& curves) {
    constexpr int times = 5;
    for (const LabelledCurve& curve : curves) {
        if (curve.id != "p103") continue;
        std::vector<Component> components = curve.components;
        for (int i = 0; i < 5; ++i, components = cut_finer(components, 1)) {
            Tally tally;
            for (int k = 0; k < times; ++k) tally.name(components);
            const std::string n = std::to_string(components[0].vertices.size());
            suite.rows.push_back(
                time("square-" + n, "tight square knot of " + n + " vertices", percentile(tally.us, 0), {}));
        }
    }
}

}  // namespace

Suite naming_suite(const std::filesystem::path& folder, bool quick, const Progress& progress) {
    const std::vector<LabelledCurve> curves = labelled_curves(folder);
    sim::knot::name_link(curves.front().components);  // the table is read at first use
    Suite suite{"knots", {}};
    const auto step = [&](const std::string& what, const auto& add) {
        if (progress) progress(what);
        const Stopwatch watch;
        const std::size_t first = suite.rows.size();
        add();
        for (std::size_t i = first; i < suite.rows.size(); ++i) suite.rows[i].seconds = watch.seconds();
    };
    step("labelled curves", [&] { add_curves(suite, curves); });
    step("a thread of 300 links", [&] { add_thread(suite); });
    step("vertices", [&] { add_growth(suite, curves); });
    step("random polygons", [&] { add_polygons(suite, quick); });
    step("flat and capsized", [&] { add_capsized(suite, quick); });
    step("seeded ties", [&] { add_ties(suite, quick); });
    step("hitches round a bar", [&] { add_on_bar(suite, folder); });
    step("attitudes", [&] { add_turned(suite, curves, quick); });
    return suite;
}

}  // namespace bench::suites
