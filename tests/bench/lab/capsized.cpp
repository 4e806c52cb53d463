#include "tests/bench/lab/capsized.hpp"

#include <cmath>

#include "tests/bench/lab/defaults.hpp"
#include "tests/bench/lab/knots.hpp"
#include "tests/bench/lab/loop.hpp"
#include "tests/bench/lab/random.hpp"

namespace bench::lab {

namespace {

// Until a hundred ticks bring what is held no farther apart than a fiftieth of the thread's thickness.
template <class Move, class Apart>
void pull_tight(const Move& move, const Apart& apart) {
    constexpr int patience = 100, most_ticks = 3000;
    double was = apart();
    for (int i = 1; i <= most_ticks; ++i) {
        move();
        if (i % patience != 0) continue;
        if (apart() < was + 0.02 * default_diameter) return;
        was = apart();
    }
}

}  // namespace

std::vector<Vec3> pulled(Pull how, std::uint64_t seed) {
    Random random(2 * seed + (how == Pull::one_strand));
    const Knot knot = random.below(2) ? Knot::square : Knot::granny;
    const double friction = 0.1 * random.below(4), link = default_diameter * random.between(1, 2);
    const double step = default_tick * 0.01 * std::pow(20, random.between(0, 1));  // 10 to 200 mm/s
    Loop loop({.friction = friction}, loose_thread(looped(knot, loop_depth), 60, link, 0.5 * link).nodes);
    if (how == Pull::tails) {
        pull_tight([&] { loop.pull_tails(step); },
                   [&] { return (loop.at(loop.held[3]) - loop.at(loop.held[0])).norm(); });
    } else {
        const bool right = random.below(2);
        const double out = right ? 1 : -1;
        Hands hands(loop.thread);
        hands.grasp(loop.thread, 0, loop.held[right ? 3 : 0]);
        hands.grasp(loop.thread, 1, loop.held[right ? 2 : 1]);
        const Vec3 up = Vec3(out * random.between(0.1, 0.8), random.between(-0.3, 0.3), 1).normalized();
        const Vec3 down = Vec3(out * random.between(0, 0.5), 0, -1).normalized();
        pull_tight([&] { hands.move(loop.thread, step * up, step * down); },
                   [&] { return (hands.hands[0].at - hands.hands[1].at).norm(); });
    }
    return {loop.thread.nodes().begin(), loop.thread.nodes().end()};
}

}  // namespace bench::lab
