#include <gtest/gtest.h>

#include "sim/geometry/triangle_tree.hpp"
#include "tests/sim/thread/scene.hpp"

using namespace scene;
using sim::geometry::TriangleTree;

// Two nodes that nobody's jaws hold: one is led into a floor, and neither may the other be led aside by it nor wait for
// it.
TEST(Advance, WhatSlidesAlongAWallLeadsNoOtherAside) {
    const double high = 2 * radius, far = 1;
    const TriangleTree floor({{{-far, -far, -high}, {far, -far, -high}, {0, far, -high}}});
    ThreadDef def;
    def.elastic = sim::thread::RodDef{.young = 2.8e9, .axial_over_bending = 0};
    Thread thread(def, straight(60));
    const Vec3 middle = thread.nodes()[30], last = thread.nodes()[60];
    constexpr int ticks = 100;
    for (int i = 1; i <= ticks; ++i) {
        const double share = static_cast<double>(i) / ticks;
        const Hold holds[] = {{30, middle + share * Vec3(0, 10 * radius, -6 * radius)},
                              {60, last + share * Vec3(0, 20 * radius, 0)}};
        const int owners[] = {-1, -1};
        const TickReport report =
            thread.tick({.holds = holds, .hold_owners = owners, .capsules = {}, .surface = &floor});
        ASSERT_EQ(report.pass_throughs, 0);
        ASSERT_LT((thread.nodes()[60] - holds[1].target).norm(), 1e-9 * radius) << i;
    }
    EXPECT_NEAR(thread.nodes()[30].y(), 10 * radius, 1e-9 * radius);
    EXPECT_GT(thread.nodes()[30].z(), -high + 0.6 * radius);  // a fifth of the thickness into the floor at most
    EXPECT_LT(thread.nodes()[30].z(), -high + 1.1 * radius);
}
