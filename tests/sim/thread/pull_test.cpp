#include <gtest/gtest.h>

#include "sim/knot/namer.hpp"
#include "tests/sim/thread/scene.hpp"

namespace {

using namespace scene;

std::string knot_of(const Thread& thread) {
    return sim::knot::name_knot({thread.nodes().begin(), thread.nodes().end()}).knot;
}

// What a tool does for a hand: it comes after it, at 0.15 m/s at most, as far as the thread lets it.
struct Hand {
    explicit Hand(const Vec3& start) : asked(start), at(start), next(start) {}

    void asks_for(const Vec3& by) {
        constexpr double most_lag = 2e-3, most_step = 0.15e-3;  // [m]: a hand that feels the pull goes no farther
        asked = at + up_to(most_lag, asked + by - at);
        next = at + up_to(most_step, asked - at);
    }
    void goes(double share) { at += share * (next - at); }

    Vec3 asked, at, next;

  private:
    static Vec3 up_to(double most, const Vec3& way) { return way.norm() > most ? Vec3(most / way.norm() * way) : way; }
};

// An overhand knot pulled tight at the slowest and the fastest a hand does it, then past what it can give. A thread
// that slips through itself, grows longer, shrinks into itself or follows tools without end would teach that any pull
// is fine.
TEST(Pull, AnOverhandTightensAndThenTheToolsWait) {
    for (const double speed : {0.1, 2.0}) {  // [m/s] of either end
        SCOPED_TRACE(speed);
        Thread thread({}, overhand());
        const std::string knot = knot_of(thread);
        ASSERT_TRUE(knot == "3_1" || knot == "m3_1") << knot;
        Pull pull(thread);
        Worst worst;
        double least_taken_up = taken_up(thread);
        const double start = least_taken_up;
        // So many that the ends would be a whole thread apart, had it no knot, and some more.
        const int ticks = static_cast<int>(0.5 * start * 2 * radius / (speed * tick)) + 20;
        for (int i = 0; i < ticks; ++i) {
            worst.add(pull.by(thread, speed * tick));
            least_taken_up = std::min(least_taken_up, taken_up(thread));
        }
        EXPECT_EQ(worst.pass_throughs, 0);
        EXPECT_LE(worst.stretch, 0.01);
        EXPECT_LE(worst.step_over_bound, 1 + 1e-12);  // rounding of a norm
        EXPECT_LT(worst.fraction, 0.5);
        EXPECT_GE(least_taken_up, 11) << "smaller than a round thread can tie";
        EXPECT_LT(least_taken_up, 0.5 * start) << "not tightened";
        EXPECT_EQ(knot_of(thread), knot);
    }
}

// A surgeon lays a taut strand aside with both hands. It has no slack from which either end could be followed alone: a
// thread that refuses would be a rod nailed into the air.
TEST(Pull, ATautThreadIsCarriedSideways) {
    Thread thread({}, straight(200));
    Pull pull(thread);
    const Vec3 by(0, 0, -0.1e-3);  // [m] a tick: 0.1 m/s
    constexpr int ticks = 100;
    for (int i = 0; i < ticks; ++i) {
        pull.left = thread.nodes().front() + by;
        pull.right = thread.nodes().back() + by;
        EXPECT_LE(pull.hold(thread).stretch_max, 1e-3);
    }
    for (const std::size_t node : {0, 100, 200})
        EXPECT_NEAR(thread.nodes()[node].z(), ticks * by.z(), 0.1 * ticks * by.norm()) << node;
}

// One hand pulls a taut thread, the other lets it come: were both to wait for each other, the thread would hang for
// ever on a pull that nobody makes any more.
TEST(Pull, AToolThatGivesWayNeedNotWaitForOneThatPulls) {
    Thread thread({}, straight(100));
    const int owners[] = {0, 1};
    Vec3 left = thread.nodes().front(), right = thread.nodes().back();
    const auto tick_with = [&](const Vec3& left_by, const Vec3& right_by) {
        const Hold holds[] = {{0, left + left_by}, {100, right + right_by}};
        thread.tick({holds, owners, {}, nullptr});
        left += thread.progress(0) * left_by;
        right += thread.progress(1) * right_by;
    };
    const Vec3 pull(0.1e-3, 0, 0), back(0.08e-3, 0, 0.06e-3);  // [m] a tick
    for (int i = 0; i < 200; ++i) tick_with(Vec3::Zero(), pull);
    const double stuck = right.x();
    for (int i = 0; i < 50; ++i) tick_with(back, pull);
    EXPECT_GT(left.x(), 0.8 * 50 * back.x());
    EXPECT_GT(right.x(), stuck);
}

// Two hands that pull a knot as tight as it goes and on, and then come back by 5 mm. No answer is found for the knot
// itself, which is pulled tighter than its strands can settle: a thread that froze with it would nail both tools into
// the air.
TEST(Pull, HandsComeBackFromAKnotPulledTooTight) {
    for (const double speed : {0.02, 0.1, 1.0}) {  // [m/s] of either hand
        SCOPED_TRACE(speed);
        Thread thread({}, overhand());
        const std::string knot = knot_of(thread);
        const Pull ends(thread);
        Hand left{thread.nodes().front()}, right{thread.nodes().back()};
        Worst worst;
        const auto both = [&](const Vec3& left_by, const Vec3& right_by) {
            left.asks_for(left_by);
            right.asks_for(right_by);
            const Hold holds[] = {{ends.first, left.next, left.asked}, {ends.last, right.next, right.asked}};
            const int owners[] = {0, 1};
            worst.add(thread.tick({holds, owners, {}, nullptr}));
            left.goes(thread.progress(0));
            right.goes(thread.progress(1));
        };
        const int pulling = static_cast<int>(0.6 * taken_up(thread) * 2 * radius / (speed * tick)) + 300;
        for (int i = 0; i < pulling; ++i) both(-speed * tick * ends.away, speed * tick * ends.away);
        constexpr double back = 0.05e-3;  // [m] a tick
        constexpr int ticks = 100;
        const Vec3 left_was = left.at, right_was = right.at;
        for (int i = 0; i < ticks; ++i) both(back * ends.away, -back * ends.away);
        EXPECT_GT((left.at - left_was).dot(ends.away), 0.5 * ticks * back);
        EXPECT_GT((right_was - right.at).dot(ends.away), 0.5 * ticks * back);
        EXPECT_EQ(knot_of(thread), knot);
        EXPECT_EQ(worst.pass_throughs, 0);
        EXPECT_LE(worst.stretch, 0.01);
    }
}

}  // namespace
