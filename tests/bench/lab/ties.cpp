#include "tests/bench/lab/ties.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "sim/geometry/portable_math.hpp"
#include "tests/bench/lab/defaults.hpp"
#include "tests/bench/lab/hands.hpp"
#include "tests/bench/lab/random.hpp"

namespace bench::lab {

namespace {

// 0.01 to 2 m/s, every doubling as likely as every other.
double draw_speed(Random& random) {
    const int doublings = random.below(8);
    return std::min(2.0, std::ldexp(0.01 * random.between(1, 2), doublings));
}

}  // namespace

Tie tie_of(std::uint64_t seed) {
    Random random(seed);
    Tie tie{};
    tie.knot = known_knots[static_cast<std::size_t>(random.below(8))].knot;
    tie.links = 60 + random.below(541);
    tie.radius_per_link = random.between(0.2, 1);
    tie.friction = 0.15 * random.below(3);
    tie.speed = draw_speed(random);
    tie.wobble = random.between(0, 1);
    tie.wobble_hz = random.between(1, 20);
    tie.let_go = random.below(4) - 2;
    tie.regrasp_at = random.below(3) == 0 ? 0 : random.between(0, 1);
    tie.pause = 1 + random.below(50);
    tie.regrasp_in = random.between(0, 0.5);
    if (tie.let_go < 0) tie.let_go = -1;
    return tie;
}

namespace {

struct TiePlay {
    TiePlay(const Tie& the_tie, const Loose& start, const EachTick& each_tick, bool elastic)
        : tie(the_tie),
          each(each_tick),
          tail(start.tail),
          thread(thread_def(tie, elastic), start.nodes),
          pull(thread),
          across(pull.away.unitOrthogonal()),
          slack(taken_up(thread)) {}

    static ThreadDef thread_def(const Tie& tie, bool elastic) {
        ThreadDef def{.friction = tie.friction, .friction_tool = tie.friction};
        if (elastic) def.elastic = {.axial_over_bending = 0};
        return def;
    }

    void add(const TickReport& report) {
        ++tied.ticks;
        tied.pass_throughs += report.pass_throughs;
        tied.stretch = std::max(tied.stretch, report.stretch_max);
    }

    // A hand's way in this tick [m]: on, and round a little circle or ellipse, the hands half a turn apart.
    Vec3 way(int hand, double on) const {
        const double turn = std::remainder(
            2 * std::numbers::pi * (tie.wobble_hz * default_tick * tied.ticks + 0.5 * hand), 2 * std::numbers::pi);
        const auto wave = sim::geometry::portable_sin_cos(turn);
        const Vec3 sideways = wave.cos * across + wave.sin * pull.away.cross(across);
        return tie.speed * default_tick * ((hand == 0 ? -on : on) * pull.away + tie.wobble * sideways);
    }

    void move(double on) {
        add(pull.hands.move(thread, way(0, on), way(1, on)));
        const int last = static_cast<int>(thread.nodes().size()) - 1;
        if (each)
            each(thread, std::max(0, pull.hands.hands[0].node), pull.hands.holds(1) ? pull.hands.hands[1].node : last);
    }

    // What lets go stays off for a while and grasps farther in; the other hand wobbles meanwhile, by no more than half
    // a tail: farther it could draw the free end out of the knot, which then is untied and rightly so.
    void let_go_and_regrasp() {
        pull.hands.let_go(tie.let_go);
        const double may_go = 0.5 * tail * thread.rest_lengths()[0], step = tie.speed * default_tick * tie.wobble;
        for (int i = 0; i < tie.pause && i * step < may_go; ++i) move(0);
        const int in = static_cast<int>(tie.regrasp_in * tail), last = static_cast<int>(thread.nodes().size()) - 1;
        pull.hands.grasp(thread, tie.let_go, tie.let_go == 0 ? in : last - in);
    }

    // What the knot takes up between the hands, in diameters.
    double left() const {
        double length = 0;
        for (int k = pull.hands.hands[0].node; k < pull.hands.hands[1].node; ++k)
            length += thread.rest_lengths()[static_cast<std::size_t>(k)];
        return (length - apart()) / (2 * thread.def().radius);
    }

    double apart() const { return (pull.hands.hands[1].at - pull.hands.hands[0].at).norm(); }

    // Until the hands come apart by less than a thirtieth of what they may in a free thread, or of the thread's
    // thickness, a tick: tight, and then beyond.
    void pull_until(double slack_left, int most_ticks) {
        constexpr int beyond = 16;
        const double little = 0.033 * beyond * std::min(2 * tie.speed * default_tick, 2 * thread.def().radius);
        double was = apart();
        for (int i = 1; i <= most_ticks && left() > slack_left; ++i) {
            move(1);
            if (i % beyond != 0) continue;
            if (apart() < was + little) return;
            was = apart();
        }
    }

    Tie tie;
    const EachTick& each;
    int tail;
    Thread thread;
    Apart pull;
    Vec3 across;
    double slack;
    Tied tied;
};

}  // namespace

Tied ties(std::uint64_t seed, const EachTick& each, bool elastic) {
    constexpr int most_ticks = 300;
    const Tie tie = tie_of(seed);
    const double radius = ThreadDef{}.radius;
    TiePlay play(tie, loose_thread(tie.knot, tie.links, radius / tie.radius_per_link, radius), each, elastic);
    const int last = static_cast<int>(play.thread.nodes().size()) - 1;
    play.tied.before = name_between(play.thread, 0, last);
    if (tie.let_go >= 0) {
        play.pull_until(tie.regrasp_at * play.slack, most_ticks);
        play.let_go_and_regrasp();
    }
    play.pull_until(0, most_ticks);
    play.tied.left = play.left();
    play.tied.hash = play.thread.hash();
    play.tied.after = name_between(play.thread, play.pull.hands.hands[0].node, play.pull.hands.hands[1].node);
    return play.tied;
}

std::string words(std::uint64_t seed, const Tie& tie, const Tied& tied) {
    char line[400];
    std::snprintf(
        line, sizeof line,
        "seed %llu: %s, %d links, R/link %.2f, friction %.2f, %.3f m/s, wobble %.2f at %.1f Hz, hand off %d for %d: "
        "'%s' -> '%s', %d pass-throughs in %d ticks, stretch %.2e, takes up %.1f D",
        static_cast<unsigned long long>(seed), known(tie.knot).words, tie.links, tie.radius_per_link, tie.friction,
        tie.speed, tie.wobble, tie.wobble_hz, tie.let_go, tie.pause, tied.before.c_str(), tied.after.c_str(),
        tied.pass_throughs, tied.ticks, tied.stretch, tied.left);
    return line;
}

}  // namespace bench::lab
