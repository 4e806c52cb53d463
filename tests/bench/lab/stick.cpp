#include <algorithm>

#include "sim/knot/namer.hpp"
#include "tests/bench/lab/defaults.hpp"
#include "tests/bench/lab/hands.hpp"
#include "tests/bench/lab/laws.hpp"
#include "tests/bench/lab/loop.hpp"
#include "tests/bench/lab/stopwatch.hpp"

namespace bench::lab {

namespace {

constexpr double asked_step = 0.02e-3;  // [m] a tick, 20 mm/s: asked of each hand for ever

std::string name_of(const Thread& thread) {
    return sim::knot::name_knot({thread.nodes().begin(), thread.nodes().end()}).knot;
}

}  // namespace

Held hold_knot(Knot knot, double friction, double seconds) {
    constexpr int tying = 1000;
    Loop loop({.friction = friction},
              loose_thread(looped(knot, loop_depth), 60, default_diameter, 0.5 * default_diameter).nodes);
    Held held;
    for (int i = 0; i < tying; ++i) held.pass_throughs += loop.pull_tails(asked_step).pass_throughs;
    const int ticks = static_cast<int>(seconds / default_tick);
    const double start = loop.apart();
    double settled = start;
    for (int i = 0; i < ticks; ++i) {
        held.pass_throughs += loop.pull_sides(asked_step).pass_throughs;
        if (i == ticks / 10) settled = loop.apart();
    }
    held.slip = loop.apart() - settled;
    held.way = loop.apart() - start;
    held.still_tied = name_of(loop.thread) == known(knot).type;
    return held;
}

// The last node that touches another strand.
static int end_of_knot(const Thread& thread) {
    const auto nodes = thread.nodes();
    constexpr std::size_t neighbours = 4;
    for (std::size_t i = nodes.size(); i-- > neighbours;)
        for (std::size_t j = 0; j + neighbours < i; ++j)
            if ((nodes[i] - nodes[j]).norm() < 1.3 * default_diameter) return static_cast<int>(i);
    return 0;
}

// The tail is cut four links behind the knot. Then the strand that leads to it is drawn out of the knot, the other end
// held.
Opened open_knot(double friction) {
    constexpr int most_ticks = 2000, tail = 4, in_the_knot = 6;
    const ThreadDef def{.friction = friction};
    Thread uncut(def, loose_thread(Knot::trefoil, 50, default_diameter, 0.5 * default_diameter).nodes);
    Apart pull(uncut);
    Opened opened;
    tighten(uncut, pull, 0.05, most_ticks,
            [&](const TickReport& report) { opened.pass_throughs += report.pass_throughs; });
    opened.tight = taken_up(uncut) < 13;  // within 2 D of the tightest
    const int end = end_of_knot(uncut);
    Thread thread(def, {uncut.nodes().begin(), uncut.nodes().begin() + end + tail + 1});
    Hands hands(thread);
    hands.grasp(thread, 1, end - in_the_knot);
    for (int i = 0; i < most_ticks && !opened.open; ++i) {
        opened.pass_throughs +=
            hands.move(thread, -0.5 * asked_step * pull.away, asked_step * pull.away.unitOrthogonal()).pass_throughs;
        opened.open = i % 50 == 49 && name_of(thread) == "0_1";
    }
    return opened;
}

std::vector<Row> stick_rows(bool quick) {
    const double seconds = quick ? 4 : 60;
    const std::string time = std::to_string(static_cast<int>(seconds)) + " s";
    std::vector<Row> rows;
    const auto add = [&](const std::string& id, Knot knot, double friction, std::optional<double> bound, Must must) {
        const Stopwatch watch;
        const Held held = hold_knot(knot, friction, seconds);
        const std::string what = std::string(known(knot).words) + " knot, friction " +
                                 std::to_string(friction).substr(0, 3) +
                                 ", sides of its loop pulled apart at 20 mm/s for " + time;
        rows.push_back(
            {.id = id,
             .what = what + (friction > 0 ? ": how far they come after the first tenth" : ": how far they come"),
             .value = friction > 0 ? held.slip : held.way,
             .unit = "D",
             .bound = bound,
             .must = must,
             .error = {},
             .seconds = watch.seconds()});
        rows.push_back({.id = id + "-passes",
                        .what = what + ": pass-throughs",
                        .value = static_cast<double>(held.pass_throughs),
                        .unit = "count",
                        .bound = 0,
                        .error = {}});
    };
    add("stick-square", Knot::square, 0.3, 0.1,
        Must::be_at_most);  // D21: what holds drifts by no more than a tenth of the thickness
    add("stick-granny", Knot::granny, 0.3, {}, Must::be_at_most);
    add("slip-square", Knot::square, 0, 5, Must::be_at_least);  // far more than a knot gives by tightening
    const Stopwatch watch;
    const Opened opened = open_knot(0.15);
    rows.push_back({.id = "open-overhand",
                    .what = "a tight overhand opens when a strand is drawn out of it: the short tail runs through",
                    .value = opened.tight && opened.open ? 1.0 : 0.0,
                    .unit = "count",
                    .bound = 1,
                    .must = Must::be_at_least,
                    .error = {},
                    .seconds = watch.seconds()});
    rows.push_back({.id = "open-overhand-passes",
                    .what = "the same: pass-throughs",
                    .value = static_cast<double>(opened.pass_throughs),
                    .unit = "count",
                    .bound = 0,
                    .error = {}});
    return rows;
}

}  // namespace bench::lab
