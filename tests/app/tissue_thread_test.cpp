#include "app/bench/tissue_thread.hpp"

#include <gtest/gtest.h>

namespace {

// A thread that leaned on one side of a corner of its hole slid off and was thrown back, tick by tick, and its friction went sideways: a fifth too
// little. As slowly as a stitch is drawn tight; the bound is the suite's.
TEST(TissueThread, DrawnThroughAHoleSlidesByCoulombsFriction) {
    constexpr double friction = 0.15, slow = 2e-3, way = 4e-3;
    for (const int bites : {1, 2}) EXPECT_NEAR(app::bench::slides_by(bites, true, friction, slow, way), friction, 0.15 * friction) << bites << " bites";
}

}  // namespace
