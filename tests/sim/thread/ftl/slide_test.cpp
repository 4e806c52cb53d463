// Follow-The-Leader over walls: what is drawn with its other end free slides along itself, and is pulled at by friction
// alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/geometry/resample.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/thread.hpp"

namespace slide {

using sim::geometry::Triangle;
using sim::geometry::Vec3;
using sim::thread::Hold;
using sim::thread::Thread;
using sim::thread::ThreadDef;

constexpr double radius = 0.0425e-3, tube = 2e-3, link = 0.3e-3, lag = 10 * radius;  // [m]
constexpr double pi = std::numbers::pi, friction = 0.15;

Vec3 on_circle(double r, double angle) {
    return {0, r * std::cos(angle), r * std::sin(angle)};
}

// Along x.
std::vector<Triangle> cylinder() {
    constexpr int sides = 60;
    const Vec3 along(5e-3, 0, 0);
    std::vector<Triangle> wall;
    for (int i = 0; i < sides; ++i) {
        const Vec3 a = on_circle(tube, 2 * pi * i / sides), b = on_circle(tube, 2 * pi * (i + 1) / sides);
        wall.push_back({a - along, a + along, b + along});
        wall.push_back({a - along, b + along, b - along});
    }
    return wall;
}

// Hanging over it on either side, `tail` long where y > 0; with 18 mm of another piece 30 mm away, or without.
Thread half_round(double tail, bool with_other) {
    std::vector<Vec3> path{{0, tube + 1.1 * radius, -tail}};
    for (int i = 0; i <= 30; ++i) path.push_back(on_circle(tube + 1.1 * radius, pi * i / 30));
    path.emplace_back(0, -tube - 1.1 * radius, -10e-3);
    auto nodes = sim::geometry::resample(path, static_cast<int>((tail + 10e-3 + pi * tube) / link));
    std::vector<int> cuts;
    if (with_other) {
        cuts.push_back(static_cast<int>(nodes.size()) - 1);
        for (int i = 0; i <= 60; ++i) nodes.emplace_back(30e-3, link * i, 0);
    }
    return {{.radius = radius, .friction = friction, .axial_stiffness = 2.8e9 * pi * radius * radius}, nodes, cuts};
}

struct Hand {
    Thread thread;
    int held;
    sim::geometry::TriangleTree wall{cylinder()};
    int passes = 0;

    explicit Hand(double tail = 30e-3, bool with_other = false)
        : thread(half_round(tail, with_other)), held(thread.pieces().front().last) {}

    // Down by `way` a tick, and wants to be `ahead` of where the thread lets it come.
    void draw(int ticks, double way, double ahead = lag) {
        for (int i = 0; i < ticks; ++i) {
            const Vec3 at = thread.nodes()[static_cast<std::size_t>(held)], down(0, 0, -1);
            const Hold hold{.node = held, .target = at + way * down, .wanted = at + (way + ahead) * down};
            const int owner = -1;
            passes += thread.tick({.holds = {&hold, 1}, .hold_owners = {&owner, 1}, .capsules = {}, .surface = &wall})
                          .pass_throughs;
        }
    }
    double at_hand() const { return thread.tension()[static_cast<std::size_t>(held) - 1]; }
    double of_tail() const { return thread.tension()[0]; }
};

TEST(Slide, PullsByTheCapstanLaw) {
    for (const bool with_other : {false, true}) {  // that lies elsewhere, limp, and follows nobody
        Hand hand(30e-3, with_other);
        hand.draw(500, 20e-6);
        ASSERT_GT(hand.of_tail(), 0);
        EXPECT_NEAR(std::log(hand.at_hand() / hand.of_tail()) / pi, friction, 0.05 * friction) << with_other;
        EXPECT_EQ(hand.passes, 0);
    }
}

// What a tick cannot afford is lag, and no pull: a free end was told to break.
TEST(Slide, AHandThatIsTooFastDoesNotPullHarder) {
    Hand hand;
    hand.draw(200, 20e-6);
    const double slow = hand.at_hand();
    hand.draw(20, 1e-3, 10e-3);
    EXPECT_LT(hand.at_hand(), 1.5 * slow);
    EXPECT_GT(hand.at_hand(), 0.5 * slow);
}

// The end of it that has gone round touches nothing any more, so that nothing holds it.
TEST(Slide, WhatHasComeOffIsNotHeld) {
    Hand hand(2e-3);
    double most = 0;
    for (int i = 0; i < 1000; ++i) {
        hand.draw(1, 20e-6);
        most = std::max(most, hand.at_hand());
    }
    EXPECT_LT(most, 1);
    EXPECT_EQ(hand.at_hand(), 0) << "its end hangs 8 mm below";
}

}  // namespace slide
