#include <algorithm>
#include <cmath>

#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/resample.hpp"
#include "sim/knot/namer.hpp"
#include "tests/bench/lab/core.hpp"
#include "tests/bench/lab/defaults.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/knots.hpp"
#include "tests/bench/lab/loop.hpp"
#include "tests/bench/lab/stopwatch.hpp"
#include "tests/bench/suites/speed.hpp"

// 150 mm of 6-0 lie in a loose square knot above a loop, which is pulled tight by its tails: in links as long as the
// thread is thick, in links eight times as long, and in such that are halved where they are needed.
namespace bench::suites {

using namespace lab;

namespace {

constexpr double fitted_length = 0.15, hand_step = 0.05e-3;  // [m], [m] that either hand is asked to go in a tick
constexpr double long_link = 8 * default_diameter;

struct FittedTie {
    std::vector<double> tick_us;
    std::size_t links_most = 0;
    double moved = 0;  ///< By changing links alone: largest distance of a node from the new links [R].
    double takes_up = 0, gap = 3, stretch = 0;
    int pass_throughs = 0;
    bool kept = false;
};

double distance_to(const Vec3& p, std::span<const Vec3> nodes) {
    double least2 = 1e300;
    for (std::size_t i = 1; i < nodes.size(); ++i)
        least2 = std::min(least2, sim::geometry::closest_points(p, p, nodes[i - 1], nodes[i]).distance_squared);
    return std::sqrt(least2);
}

// One tick of both tails going out, timed.
void pull(Loop& loop, FittedTie& tied, std::vector<Vec3>& before) {
    Thread& thread = loop.thread;
    before.assign(thread.nodes().begin(), thread.nodes().end());
    double begin = processor_time();
    const bool changed = thread.fit_links(loop.held);
    double spent = processor_time() - begin;
    if (changed)
        for (const Vec3& p : before)
            tied.moved = std::max(tied.moved, distance_to(p, thread.nodes()) / thread.def().radius);
    begin = processor_time();
    const TickReport report = loop.pull_tails(hand_step);
    spent += processor_time() - begin;
    tied.tick_us.push_back(1e6 * spent);
    tied.links_most = std::max(tied.links_most, thread.rest_lengths().size());
    tied.stretch = std::max(tied.stretch, report.stretch_max);
    tied.gap = std::min(tied.gap, report.separation_min);
    tied.pass_throughs += report.pass_throughs;
}

// Thread between the tails' ends and the sides of the loop, less the straight ways from where they are held to the
// knot's middle, over the thickness.
double takes_up(const Loop& loop) {
    const auto rest = loop.thread.rest_lengths();
    const auto nodes = loop.thread.nodes();
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    const auto between = [&](int first, int last) {
        double sum = 0;
        for (int k = first; k < last; ++k) sum += rest[at(k)];
        return sum;
    };
    // The middle: of all places where the one strand touches the other.
    Vec3 middle = Vec3::Zero();
    double touching = 0;
    for (int i = loop.held[0]; i < loop.held[1]; ++i)
        for (int j = loop.held[2]; j < loop.held[3]; ++j) {
            const auto pair =
                sim::geometry::closest_points(nodes[at(i)], nodes[at(i + 1)], nodes[at(j)], nodes[at(j + 1)]);
            if (pair.distance_squared > 1.44 * default_diameter * default_diameter) continue;
            middle += 0.5 * (pair.on_a + pair.on_b);
            ++touching;
        }
    double straight = 0;
    for (const int node : loop.held) straight += (nodes[at(node)] - middle / touching).norm();
    return (between(loop.held[0], loop.held[1]) + between(loop.held[2], loop.held[3]) - straight) / default_diameter;
}

FittedTie tie(double link, double shortest) {
    constexpr int patience = 200, most_ticks = 6000;
    // As loose as a rope would lie in it that is as thick as the long links are long.
    std::vector<Vec3> nodes = loose_thread(looped(Knot::square, loop_depth),
                                           static_cast<int>(fitted_length / long_link), long_link, 0.5 * long_link)
                                  .nodes;
    nodes = sim::geometry::resample(nodes, static_cast<int>(std::lround(fitted_length / link)));
    Loop loop({.shortest_link = shortest}, nodes);
    FittedTie tied;
    double was = (loop.at(loop.held[3]) - loop.at(loop.held[0])).norm();
    for (int i = 1; i <= most_ticks; ++i) {
        pull(loop, tied, nodes);
        if (i % patience != 0) continue;
        const double now = (loop.at(loop.held[3]) - loop.at(loop.held[0])).norm();
        if (now < was + 0.01 * default_diameter) break;
        was = now;
    }
    tied.takes_up = takes_up(loop);
    tied.kept =
        sim::knot::name_knot({loop.thread.nodes().begin(), loop.thread.nodes().end()}).knot == known(Knot::square).type;
    return tied;
}

}  // namespace

void add_fitted(Suite& suite, const Progress& progress) {
    struct Case {
        const char *id, *words;
        double link, shortest;
    };
    const Case cases[] = {{"links-short", "D", default_diameter, 0},
                          {"links-long", "8 D", long_link, 0},
                          {"links-fitted", "8 D to D", long_link, default_diameter}};
    double short_p50 = 0;
    for (const Case& c : cases) {
        progress(std::string("150 mm into a square knot, links of ") + c.words);
        const Stopwatch watch;
        const FittedTie found = tie(c.link, c.shortest);
        const auto add = [&](const char* figure, const std::string& what, double value, const char* unit) -> Row& {
            const std::string words = std::string("150 mm of 6-0 into a square knot, links of ") + c.words + ": ";
            suite.rows.push_back(told(std::string(c.id) + "-" + figure, words + what, value, unit, watch.seconds()));
            return suite.rows.back();
        };
        add("most", "links, at most", static_cast<double>(found.links_most), "count");
        const double p50 = percentile(found.tick_us, 0.5);
        add("tick-p50", "median tick", p50, "us");
        add("tick-p99", "99 of 100 ticks", percentile(found.tick_us, 0.99), "us");
        add("takes-up", "the tight knot takes up", found.takes_up, "D");
        add("stretch", "longest link", 100 * found.stretch, "%").bound = 0.1;
        Row& gap = add("gap", "smallest gap", found.gap, "D");
        gap.bound = 0.99, gap.must = Must::be_at_least;
        Row& kept = add("knot-kept", "still square in the end", found.kept, "count");
        kept.bound = 1, kept.must = Must::be_at_least;
        add("pass-throughs", "pass-throughs", found.pass_throughs, "count").bound = 0;
        if (c.shortest > 0) {
            add("moved", "the curve moved by changing links", found.moved, "R").bound = 0.1;
            add("ratio", "median tick over that with links of D", p50 / short_p50, "ratio");
        }
        if (c.link == default_diameter) short_p50 = p50;
    }
}

}  // namespace bench::suites
