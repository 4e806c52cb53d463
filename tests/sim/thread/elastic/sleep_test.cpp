#include <gtest/gtest.h>

#include "sim/geometry/triangle_tree.hpp"
#include "tests/sim/thread/scene.hpp"

// Pieces of a cut thread that lie still are not solved, and nobody may see that.

namespace sleeping {

using namespace scene;
using sim::geometry::Capsule;
using sim::geometry::Triangle;
using sim::geometry::TriangleTree;
using sim::thread::MovingCapsule;

constexpr int links =
    20;  // of each piece; the first lies on a floor, the second hangs over it, across, from a tool at either end
const Vec3 nowhere = Vec3::Zero();
constexpr double length = links * 2 * radius, floor_half = 2 * length;

std::vector<Triangle> floor_at(double z) {
    const Vec3 a(-floor_half, -floor_half, z), b(floor_half, -floor_half, z), c(floor_half, floor_half, z),
        d(-floor_half, floor_half, z);
    return {{a, b, c}, {a, c, d}};
}

std::vector<Vec3> both() {
    std::vector<Vec3> nodes = straight(links);
    for (Vec3& p : nodes) p += Vec3(-0.5 * length, 0, radius);
    for (int i = 0; i <= links; ++i) nodes.emplace_back(0, 2 * radius * i - 0.5 * length, 20 * radius);
    return nodes;
}

ThreadDef def() {
    ThreadDef def;
    def.elastic = {.gravity = Vec3(0, 0, -9.81)};
    return def;
}

struct Scene {
    Scene() { rest(500); }

    // Tools go on by `hands` a tick, a rod that lies along y by `steel`, the floor by `sinks`.
    void step(const Vec3& hands = nowhere, const Vec3& steel = nowhere, double sinks = 0) {
        const int first = static_cast<int>(thread.nodes().size()) - links - 1, last = first + links;
        left += hands, right += hands;
        const Hold holds[] = {{first, left}, {last, right}};
        constexpr int owners[] = {0, 1};
        const MovingCapsule moving[] = {{rod, {rod.a + steel, rod.b + steel, rod.radius}, 2}};
        rod = moving[0].to;
        if (sinks != 0) floor.move(floor_at(height -= sinks));
        report = thread.tick({holds, owners, moving, &floor, tick, {}, std::abs(sinks)});
        worst.add(report);
    }
    void rest(int ticks) {
        for (int i = 0; i < ticks; ++i) step();
    }
    std::vector<Vec3> lying() const { return {thread.nodes().begin(), thread.nodes().begin() + links + 1}; }
    double on_floor() const {
        double sum = 0;
        for (const auto& pressed : thread.surface_forces()) sum -= pressed.force.z();
        return sum;
    }
    bool sleeps() const { return report.contacts == 0; }  // it lies on the floor, but that is not looked at

    Thread thread{def(), both(), std::vector<int>{links}};
    TriangleTree floor{floor_at(0)};
    double height = 0;
    Vec3 left = thread.nodes()[links + 1], right = thread.nodes().back();
    Capsule rod{Vec3(length, -length, 3 * radius), Vec3(length, length, 3 * radius), 2 * radius};
    TickReport report;
    Worst worst;
    double weight = length * def().elastic->density * 3.14159265358979 * radius * radius * 9.81;  // [N]
};

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

TEST(Sleep, WhatLiesStillIsNotLookedAtAndWeighsWhatItWeighs) {
    Scene scene;
    EXPECT_TRUE(scene.sleeps());
    const auto before = scene.lying();
    scene.rest(200);
    EXPECT_TRUE(scene.sleeps());
    EXPECT_EQ(farthest(before, scene.lying()), 0);
    EXPECT_NEAR(scene.on_floor(), scene.weight, 0.05 * scene.weight);  // as it came to rest
}

TEST(Sleep, AToolThatComesNearWakesAndPushesIt) {
    Scene scene;
    const auto before = scene.lying();
    const double way = 0.5 * length;
    for (int i = 0; i < 500; ++i) scene.step(nowhere, Vec3(-way / 500, 0, 0));
    EXPECT_FALSE(scene.sleeps());
    scene.rest(1);
    EXPECT_LE(scene.lying().back().x(), scene.rod.a.x());  // pushed along the floor, end first
    EXPECT_GT(farthest(before, scene.lying()), 0);
    EXPECT_EQ(scene.worst.pass_throughs, 0);
}

TEST(Sleep, AnotherPieceThatComesDownOnItIsHeldUp) {
    Scene scene;
    for (int i = 0; i < 400; ++i) scene.step(Vec3(0, 0, -17 * radius / 400));
    EXPECT_FALSE(scene.sleeps());
    EXPECT_GT(scene.on_floor(), 1.1 * scene.weight);
    EXPECT_GE(scene.report.separation_min, 0.98);
    EXPECT_EQ(scene.worst.pass_throughs, 0);
}

TEST(Sleep, AFloorThatSinksTakesItAlong) {
    Scene scene;
    const double way = 4 * radius;
    for (int i = 0; i < 200; ++i) scene.step(nowhere, nowhere, way / 200);
    scene.rest(500);
    for (const Vec3& p : scene.lying())
        EXPECT_NEAR(p.z(), radius - way, 0.25 * radius);  // so far it may sink unnoticed
    EXPECT_TRUE(scene.sleeps());
}

TEST(Sleep, OneThatIsCutWakes) {
    Scene scene;
    std::vector<int> held{links + 1, 2 * links + 1};
    ASSERT_TRUE(scene.thread.cut(links / 2, 0.5, held));
    scene.rest(1);
    EXPECT_FALSE(scene.sleeps());
    scene.rest(500);
    EXPECT_TRUE(scene.sleeps());
    EXPECT_NEAR(scene.on_floor(), scene.weight * (links - 1) / links, 0.05 * scene.weight);
    EXPECT_EQ(scene.worst.pass_throughs, 0);
}

// As a thread that is worked with: what of it slides on slowly for good is not to be stopped.
TEST(Sleep, AThreadInOnePieceDoesNot) {
    const std::vector<Vec3> nodes = both();
    Thread thread(def(), {nodes.begin(), nodes.begin() + links + 1});
    const TriangleTree floor(floor_at(0));
    TickReport report;
    for (int i = 0; i < 500; ++i) report = thread.tick({{}, {}, {}, &floor});
    EXPECT_GT(report.contacts, 0);
}

}  // namespace sleeping
