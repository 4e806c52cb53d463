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

}  // namespace
