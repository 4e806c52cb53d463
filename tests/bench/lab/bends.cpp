#include "tests/bench/lab/bends.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/geometry/at.hpp"
#include "sim/thread/thread.hpp"
#include "tests/bench/lab/knots.hpp"
#include "tests/bench/lab/throws.hpp"

namespace bench::lab {

using sim::at;
using sim::thread::Hold;
using sim::thread::RodDef;
using sim::thread::Thread;

// In the unit of tied().
static std::vector<Vec3> corners(const Bend& bend) {
    constexpr double tail = 30, hand = 12, slack = 20, foot = -3, throw_height = 3;
    std::vector<sim::knot::Throw> throws;
    for (int i = 0; i < bend.throws; ++i) throws.push_back({1, !bend.mirrored || i % 2 == 0});
    std::vector<Vec3> path = tied(throws, {}, {tail, 0, tail / 2}),
                      second(path.begin() + static_cast<std::ptrdiff_t>(path.size() / 2), path.end());
    path.resize(path.size() / 2);
    double stands = foot;
    if (bend.opposite) {
        stands = throw_height * bend.throws;
        std::reverse(second.begin(), second.end());
        second.front() = {4, 0, stands};
        second.push_back(second.back() + Vec3(tail, 0, -tail / 2));
    }
    for (const Vec3& p :
         {Vec3(-hand, 0, foot), Vec3(-hand, slack, foot), Vec3(hand, slack, stands), Vec3(hand, 0, stands)})
        path.push_back(p);
    path.insert(path.end(), second.begin(), second.end());
    return path;
}

BendThread::BendThread(const Bend& bend, double link, double radius) : opposite(bend.opposite) {
    constexpr int rounds = 24, pieces = 600;  // of a path three times as long as that of a looped knot
    nodes = loose_thread(rounded(corners(bend), rounds, pieces), 0, link, radius).nodes;
    // From the slack back to where the rope still runs straight to its knot.
    const auto straight = [&](int i) { return std::abs(nodes[at(i)].y()) < 2 * radius; };
    const auto slack = [&](int i) { return nodes[at(i)].y() > 20 * radius; };
    for (left = 0; !slack(left);) ++left;
    for (right = static_cast<int>(nodes.size()) - 1; !slack(right);) --right;
    while (!straight(left)) --left;
    while (!straight(right)) ++right;
}

std::string BendThread::name() const {
    std::vector<Vec3> curve(nodes.begin(), nodes.begin() + left + 1), second(nodes.begin() + right, nodes.end());
    if (opposite) std::reverse(second.begin(), second.end());
    const double below = 10 * (curve.back() - second.front()).norm();
    for (const Vec3& p : {curve.back(), second.front()}) curve.push_back(p - below * Vec3::UnitZ());
    curve.insert(curve.end(), second.begin(), second.end());
    return sim::knot::name_knot(curve).knot;
}

namespace {

struct Pulling {
    Pulling(const Bend& bend, const BendPull& pull)
        : rod{.bending_share = pull.bending_share, .axial_over_bending = 0, .yield_strain = pull.yield_strain},
          start(bend, pull.link * diameter, 0.5 * diameter),
          last(static_cast<int>(start.nodes.size()) - 1),
          thread(thread_def(pull, rod), start.nodes),
          loads(start.nodes.size(), Vec3::Zero()),
          seconds(pull.tick) {
        cost.links = last;
        out = {(start.nodes[0] - start.nodes[1]).normalized(),
               (start.nodes[at(last)] - start.nodes[at(last - 1)]).normalized()};
    }

    static sim::thread::ThreadDef thread_def(const BendPull& pull, const RodDef& rod) {
        sim::thread::ThreadDef def{.friction = pull.friction, .axial_stiffness = rod.axial_stiffness(diameter)};
        if (pull.elastic) def.elastic = rod;
        return def;
    }

    double unit() const { return rod.bending_stiffness() / (diameter * diameter); }
    double bears() const { return 0.085 * rod.axial_stiffness(diameter) / unit(); }
    double pulled(int link) const { return thread.tension()[at(link)] / unit(); }
    double standing() const { return 0.5 * (pulled(start.left - 1) + pulled(start.right)); }
    double tail(int which) const { return thread.nodes()[which == 0 ? 0 : at(last)].dot(out[at(which)]) / diameter; }

    // Hands at the last two nodes go towards the pull that is asked of them, by what ten diameters of thread would give
    // and a tenth at most in a millisecond.
    void tick(double standing_pull, double tail_pull) {
        loads.front() = tail_pull * unit() * out[0], loads.back() = tail_pull * unit() * out[1];
        const double most = 100 * seconds * diameter, give = 10 * diameter * unit() / rod.axial_stiffness(diameter);
        const auto way = [&](int link) {
            return std::clamp(give * (standing_pull - pulled(link)), -most, most) * Vec3::UnitX();
        };
        const Vec3 l = -way(start.left - 1), r = way(start.right);
        const auto x = thread.nodes();
        const auto by = [&](int node, const Vec3& go) { return Hold{node, x[at(node)] + go}; };
        const Hold holds[] = {by(start.left, l), by(start.left + 1, l), by(start.right, r), by(start.right - 1, r)};
        constexpr int owners[] = {0, 0, 1, 1};
        const auto go = [&] {
            return thread.tick(
                {.holds = holds, .hold_owners = owners, .capsules = {}, .seconds = seconds, .loads = loads});
        };
        pass_throughs += cost.of(go).pass_throughs;
    }

    // All four ends alike, until it stands still.
    void tighten(double pull) {
        const int ramp = ticks_in(0.3, seconds), ticks = ticks_in(1.5, seconds);
        for (int t = 1; t <= ticks; ++t) {
            const double now = pull * std::min(1.0, static_cast<double>(t) / ramp);
            tick(now, now);
        }
        tight = {tail(0), tail(1)};
    }

    // From what it was tied with to what its tails are pulled with, in a second.
    void ease(double from, double to) {
        constexpr int ramp = 1000;
        for (int t = 1; t <= ramp && from > to; ++t) {
            const double pull = from + (to - from) * t / ramp;
            tick(pull, pull);
        }
        tight = {tail(0), tail(1)};
    }

    double run_in() const { return std::max(tight[0] - tail(0), tight[1] - tail(1)); }
    bool slipped() const { return run_in() > 20; }

    double apart() const {
        return (thread.nodes()[at(start.right)] - thread.nodes()[at(start.left)]).norm() / diameter;
    }

    static constexpr double diameter = 2 * sim::thread::ThreadDef{}.radius;
    RodDef rod;
    BendThread start;
    int last;
    Thread thread;
    std::vector<Vec3> loads;
    std::array<Vec3, 2> out;  // where tails are pulled
    std::array<double, 2> tight{};
    int pass_throughs = 0;
    double seconds;  // in a tick
    Cost cost;
};

}  // namespace

// Pulled no harder while a tail runs in: then a slow ramp and a slower one come to the same.
Pulled pull_bend(const Bend& bend, const BendPull& pull) {
    constexpr double mean_of = 20;                                         // ticks
    const double creeping = 5 * pull.tick, ramp = ticks_in(6, pull.tick);  // [D] in a tick; ticks
    const int most_ticks = ticks_in(20, pull.tick);                        // what has run in all that time has slipped
    Pulling pulling(bend, pull);
    const double tied = std::max(pull.tying, pull.tails);
    pulling.tighten(tied);
    pulling.ease(tied, pull.tails);
    const double bears = pulling.bears(), more = std::pow(bears / pull.tails, 1 / ramp);
    double asked = pull.tails, now = asked, most = asked, running = 0, run_in = pulling.run_in();
    for (int t = 0; t < most_ticks && now < 0.99 * bears && !pulling.slipped(); ++t) {
        if (running < creeping) asked = std::min(asked * more, bears);
        pulling.tick(asked, pull.tails);
        now += (pulling.standing() - now) / mean_of;
        running += (pulling.run_in() - run_in - running) / mean_of;
        run_in = pulling.run_in();
        most = std::max(most, now);
    }
    return {most, most / bears, pulling.pass_throughs, pulling.cost};
}

LetGo let_go(const Bend& bend, const BendPull& pull) {
    const int ticks = ticks_in(1, pull.tick), free = ticks_in(2, pull.tick);
    constexpr double most = 20;  // [D]
    Pulling pulling(bend, pull);
    pulling.tighten(pull.tails);
    const double before = pulling.apart();
    double left = pull.tails, run_in = 0;
    for (int t = 1; t <= ticks + free && run_in < most; ++t) {
        left = pull.tails * std::max(0.0, 1 - static_cast<double>(t) / ticks);
        pulling.tick(pull.tails, left);
        run_in = pulling.apart() - before;  // whatever way free tails swing
    }
    return {left, run_in};
}

}  // namespace bench::lab
