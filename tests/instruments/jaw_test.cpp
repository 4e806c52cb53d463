#include "instruments/jaw.hpp"

#include <gtest/gtest.h>

using namespace instruments;

static const Pose somewhere{{0.03, -0.01, 0.02}, Quat(Eigen::AngleAxisd(2.1, Vec3(1, -2, 0.5).normalized()))};
static Vec3 world(double x, double y, double z) {
    return somewhere.position + somewhere.rotation * Vec3(x, y, z);
}

// Taken too wide, closing jaws grasp a thread that lies beside them; too narrow, they lose the one between them.
TEST(Jaw, TheRoomBetweenReachesFromJawToJawAndHingeToTip) {
    for (const Kind kind : {Kind::forceps, Kind::needle_holder}) {
        const ToolShape& shape = shape_of(kind);
        for (const double jaw : {0.0, 0.5, 1.0}) {
            const auto parts = parts_at(shape, somewhere, jaw);
            const auto inside = [&](const Vec3& p) { return between_jaws(shape, somewhere, jaw, p); };
            for (const double along : {0.05, 0.5, 0.95}) {
                const Vec3 plus = parts[jaw_plus].a + along * (parts[jaw_plus].b - parts[jaw_plus].a);
                const Vec3 minus = parts[jaw_minus].a + along * (parts[jaw_minus].b - parts[jaw_minus].a);
                const Vec3 out = somewhere.rotation * Vec3(0, 1.01 * shape.jaw_radius, 0);
                EXPECT_TRUE(inside((plus + minus) / 2));
                EXPECT_TRUE(inside(0.99 * plus + 0.01 * minus));
                EXPECT_FALSE(inside(1.01 * plus - 0.01 * minus));
                EXPECT_FALSE(inside((plus + minus) / 2 + out));
                EXPECT_FALSE(inside((plus + minus) / 2 - out));
            }
            EXPECT_FALSE(inside(world(0, 0, 0.01e-3)));
            EXPECT_FALSE(inside(world(0, 0, -shape.jaw_length - 0.01e-3)));
        }
    }
}

// Links of 0.5 mm have no node in jaws 0.4 mm deep more often than not: a grasp that looks at nodes alone misses.
TEST(Jaw, ALinkThatCrossesIsFoundThoughBothItsEndsAreOutside) {
    const ToolShape& shape = shape_of(Kind::forceps);
    for (const double offset : {-0.1e-3, 0.0, 0.1e-3}) {
        const Vec3 a = world(1e-3, offset - 0.25e-3, -2e-3), b = world(1e-3, offset + 0.25e-3, -2e-3);
        const auto place = between_jaws(shape, somewhere, 1, a, b);
        ASSERT_TRUE(place.has_value());
        // Inside from -0.2 to 0.2 mm or to the link's end.
        const double low = std::max(-0.2e-3, offset - 0.25e-3), high = std::min(0.2e-3, offset + 0.25e-3);
        EXPECT_NEAR(*place, ((low + high) / 2 - offset + 0.25e-3) / 0.5e-3, 1e-9);
        EXPECT_FALSE(between_jaws(shape, somewhere, 0, a, b));  // it lies 1 mm beside the closed jaws
    }
    EXPECT_FALSE(between_jaws(shape, somewhere, 1, world(-9e-3, 0, -2e-3), world(-1e-3, 9e-3, -2e-3)));
}

TEST(Jaw, StationRunsFromHingeToTip) {
    const ToolShape& shape = shape_of(Kind::needle_holder);
    EXPECT_NEAR(jaw_station(shape, somewhere, world(0, 0, 0)), 1, 1e-12);
    EXPECT_NEAR(jaw_station(shape, somewhere, world(1e-3, 0, -shape.jaw_length)), 0, 1e-12);
    EXPECT_NEAR(jaw_station(shape, somewhere, world(0, 1e-3, -shape.jaw_length / 4)), 0.75, 1e-12);
}
