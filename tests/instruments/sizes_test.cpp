// Every size and strength of an instrument against a literal with its source: a test that reads them from the shape
// says nothing of them.
#include <gtest/gtest.h>

#include <cmath>

#include "instruments/needle.hpp"
#include "instruments/tool.hpp"
#include "instruments/tool_world.hpp"

namespace instrument_sizes {

using namespace instruments;

constexpr double mm = 1e-3;

struct Size {
    Kind kind;
    double shaft_radius, shaft_length, tip_width, jaw_length;  // [mm]
    double opening_deg, between_tips;                          // full angle; [mm], when open
    double grip;                                               // [N]
};

// Fine anastomosis forceps: 0.8 mm across the closed tips, these 5 mm apart when open; fingers close them.
// Needle holder of Castroviejo's pattern: 1.2 mm across the closed tips, 20 degrees open; locked, it grips four times
// as hard. Spring microscissors of Vannas' pattern: blades of 6 mm, tips 0.2 mm across each, 25 degrees open.
// Double clamp after Acland: a rail of 5 mm.
const Size table[] = {{Kind::forceps, 1.5, 80, 0.4, 12, 24.47, 5, 1},
                      {Kind::needle_holder, 1.6, 80, 0.6, 10, 20, 3.37, 4},
                      {Kind::scissors, 1.5, 80, 0.2, 6, 25, 2.55, 0},
                      {Kind::approximator, 1.5, 30, 0.8, 20, 14.67, 5, 0}};

TEST(Sizes, OfAllFourKinds) {
    for (const Size& size : table) {
        SCOPED_TRACE(static_cast<int>(size.kind));
        const ToolShape& shape = shape_of(size.kind);
        EXPECT_EQ(shape.shaft_radius, size.shaft_radius * mm);
        EXPECT_EQ(shape.shaft_length, size.shaft_length * mm);
        EXPECT_NEAR(2 * shape.jaw_radius, size.tip_width * mm, 1e-12);
        EXPECT_EQ(shape.jaw_length, size.jaw_length * mm);
        EXPECT_NEAR(shape.jaw_opening * 180 / EIGEN_PI, size.opening_deg, 0.02);
        EXPECT_EQ(shape.grip_force, size.grip);
        const auto open = parts_at(shape, {}, 1), half = parts_at(shape, {}, 0.5), closed = parts_at(shape, {}, 0);
        const auto between = [&](const auto& parts) {
            return ((parts[jaw_plus].b - parts[jaw_minus].b).norm() - 2 * shape.jaw_radius) / mm;
        };
        EXPECT_NEAR(between(open), size.between_tips, 0.01);
        EXPECT_NEAR(between(half), 0.5 * size.between_tips, 0.02);
        EXPECT_NEAR(between(closed), 0, 1e-12);
        EXPECT_NEAR(2 * opening_of(shape, 1) / mm, size.between_tips, 0.01);
        EXPECT_NEAR(open[shaft].radius / mm, size.shaft_radius, 1e-12);
        EXPECT_NEAR((open[shaft].b - open[shaft].a).norm() / mm, size.shaft_length, 1e-9);
        EXPECT_NEAR(open[shaft].b.z() / mm, -size.jaw_length - size.shaft_radius, 1e-9);
        EXPECT_NEAR(closed[jaw_plus].radius / mm, 0.5 * size.tip_width, 1e-12);
    }
}

// A needle bends where its outermost fibres yield: 1.8 GPa of hard-drawn stainless steel times pi r^3 / 4.
TEST(Sizes, OfWhatBendsANeedle) {
    EXPECT_NEAR(yield_moment(0.1 * mm), 1.8e9 * EIGEN_PI / 4 * 1e-12, 1e-9);
    EXPECT_NEAR(yield_moment(0.05 * mm) / yield_moment(0.1 * mm), 0.125, 1e-12);
}

// Its capsules are as thick as its wire, lie on its arc to a fourteenth of that, and end round at its tail.
TEST(Sizes, OfANeedlesParts) {
    const Arc needle{
        .to_tail = Vec3::UnitX(), .onwards = Vec3::UnitZ(), .radius = 3.95 * mm, .angle = 2.356, .wire = 0.1 * mm};
    const auto parts = parts_of(needle);
    double length = 0;
    for (const Capsule& part : parts) {
        EXPECT_EQ(part.radius, 0.1 * mm);
        length += (part.b - part.a).norm();
        const double off = needle.radius - (0.5 * (part.a + part.b)).norm();
        EXPECT_GE(off, 0);
        EXPECT_LT(off, 2 * 0.1 * mm / 14);
    }
    EXPECT_EQ(parts.size(), 16u);
    EXPECT_NEAR((parts.front().a - needle.tail()).norm(), 0.1 * mm, 1e-3 * mm);
    EXPECT_LT((parts.back().b - needle.tip()).norm(), 1e-12);
    EXPECT_NEAR(length, needle.length() - 0.1 * mm, 1e-3 * needle.length());
}

// A device that says a tool is eight metres away has lost it: a hundred shaft lengths are the most.
TEST(Sizes, OfTheRoomThatInputsAreIn) {
    const ToolShape& shape = shape_of(Kind::forceps);
    for (const double away : {7.99, 8.01}) {
        const ToolInput input{{Vec3(0, away, 0), Quat::Identity()}, 0.5};
        EXPECT_EQ(usable(input, shape).has_value(), away < 8) << away;
    }
    EXPECT_EQ(usable({{}, 1.5}, shape)->jaw, 1);
    EXPECT_EQ(usable({{}, -0.5}, shape)->jaw, 0);
    EXPECT_EQ(usable({{}, 0.375}, shape)->jaw, 0.375);
}

// A tool stops a fiftieth of its jaw's radius before what it meets.
TEST(Sizes, OfTheGapThatToolsKeep) {
    ToolWorld tools;
    EXPECT_NEAR(tools.skin(tools.add_tool(Kind::forceps)), 0.2 * mm / 50, 1e-12);
    EXPECT_NEAR(tools.skin(tools.add_tool(Kind::needle_holder)), 0.3 * mm / 50, 1e-12);
}

}  // namespace instrument_sizes
