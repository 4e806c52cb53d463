#include <gtest/gtest.h>

#include "sim/knot/namer.hpp"
#include "tests/sim/thread/scene.hpp"

namespace {

using namespace scene;

std::string knot_of(const Thread& thread) {
    return sim::knot::name_knot({thread.nodes().begin(), thread.nodes().end()}).knot;
}

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
    for (const std::size_t node : {0, 100, 200}) EXPECT_NEAR(thread.nodes()[node].z(), ticks * by.z(), 0.1 * ticks * by.norm()) << node;
}

// One hand pulls a taut thread, the other lets it come: were both to wait for each other, the thread would hang for ever
// on a pull that nobody makes any more.
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

}  // namespace
