#include "tests/bench/suites/tissue_thread.hpp"

#include <gtest/gtest.h>

#include "tests/bench/lab/thread_in_tube.hpp"

namespace {

// A thread that leaned on one side of a corner of its hole slid off and was thrown back, tick by tick, and its friction
// went sideways: a fifth too little. As slowly as a stitch is drawn tight; the bound is the suite's.
TEST(TissueThread, DrawnThroughAHoleSlidesByCoulombsFriction) {
    constexpr double friction = 0.15, slow = 2e-3, way = 4e-3;
    for (const int bites : {1, 2})
        EXPECT_NEAR(bench::suites::slides_by(bites, true, friction, slow, way), friction, 0.15 * friction)
            << bites << " bites";
}

// By Follow-The-Leader as well, which found three times as much: its strands slide along themselves, by the capstan law
// at each rim.
TEST(TissueThread, SlidesByCoulombsFrictionByFollowTheLeader) {
    constexpr double friction = 0.15, usual = 10e-3, way = 5e-3;
    for (const int bites : {1, 2})
        EXPECT_NEAR(bench::suites::slides_by(bites, false, friction, usual, way), friction, 0.15 * friction)
            << bites << " bites";
}

// Once what was slack is taut, after some 5 mm, it used to jam there for good.
TEST(TissueThread, FollowsThroughTenBites) {
    bench::lab::ThreadInTube scene({.bites = 10, .is_elastic = false});
    double gone = 0;
    for (int i = 0; i < 1000; ++i) gone += scene.draw(true, 50e-6, 0);
    EXPECT_GT(gone, 10e-3);
    EXPECT_EQ(scene.passes(), 0);
}

}  // namespace
