#include "tissue/rim.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tissue/tube.hpp"
#include "tissue/wall.hpp"

namespace rim_shapes {

using namespace tissue;

constexpr double pi = std::numbers::pi;

// A tube of sixteen sides has one outer and one inner rim of sixteen edges, all in the plane of its cut.
TEST(Rim, GoesRoundATubesCut) {
    const TubeDef def;
    const Mesh mesh = make_tube(def);
    const double out = std::sqrt(2 * pi / 16 / std::sin(2 * pi / 16));  // corners of the same area
    for (const auto& [side, radius] : {std::pair(Side::outer, def.diameter / 2 * out),
                                       std::pair(Side::inner, (def.diameter / 2 - def.wall) * out)}) {
        const auto found = rims(mesh, side);
        ASSERT_EQ(found.size(), 1u);
        const Rim& rim = found[0];
        ASSERT_EQ(rim.nodes.size(), 16u);
        for (std::size_t k = 0; k < 16; ++k) {
            const Vec3 &at = mesh.nodes[static_cast<std::size_t>(rim.nodes[k])],
                       &next = mesh.nodes[static_cast<std::size_t>(rim.nodes[(k + 1) % 16])];
            EXPECT_EQ(at.x(), 0);
            EXPECT_NEAR(at.norm(), radius, 1e-12);
            EXPECT_NEAR(at.cross(next).normalized().x(), side == Side::outer ? -1 : 1,
                        1e-12);  // the cut to the left, seen along x
        }
        EXPECT_NEAR(rim.length, 16 * 2 * radius * std::sin(pi / 16), 1e-12);
        EXPECT_NEAR(length(rim, mesh.nodes), rim.length, 1e-15);
        EXPECT_LE(middle(rim, mesh.nodes).norm(), 1e-12);
    }
}

// The nearest place of where a place is is that place, and a point a little up the wall from there is nearest to it
// too.
TEST(Rim, KnowsItsPlaces) {
    for (const double angle : {45.0, 90.0}) {
        const Mesh mesh = make_tube({.cut_angle = angle});
        const Rim rim = rims(mesh, Side::outer)[0];
        for (int k = 0; k < 100; ++k) {
            const double place = rim.length * (k + 0.5) / 100;
            const Vec3 at = position(rim, place, mesh.nodes);
            const RimPoint found = nearest(rim, mesh, at);
            EXPECT_NEAR(found.place, place, 1e-12);
            EXPECT_NEAR(found.distance, 0, 1e-12);
            EXPECT_LE((position(rim, place + rim.length, mesh.nodes) - at).norm(), 1e-12);
            if (angle == 90) {
                EXPECT_NEAR(nearest(rim, mesh, at + Vec3(1e-3, 0, 0)).distance, 1e-3, 1e-12);
            }
        }
        EXPECT_LT(nearest(rim, mesh, position(rim, 0, mesh.nodes)).place, rim.length);
    }
}

// A wall of a surface open at both ends is cut at both; a box is not cut at all.
TEST(Rim, FindsEveryCut) {
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 3>> triangles;
    constexpr int around = 12;
    for (int i = 0; i < 2; ++i)
        for (int a = 0; a < around; ++a)
            vertices.emplace_back(4e-3 * i, 2e-3 * std::cos(2 * pi * a / around), 2e-3 * std::sin(2 * pi * a / around));
    for (int a = 0; a < around; ++a) {
        const int b = (a + 1) % around;
        triangles.push_back({a, b, b + around}), triangles.push_back({a, b + around, a + around});
    }
    for (auto& t : triangles) std::swap(t[1], t[2]);
    Wall wall = make_wall(vertices, triangles, {});
    ASSERT_FALSE(wall.problem) << *wall.problem;
    EXPECT_EQ(rims(wall.mesh, Side::outer).size(), 2u);
    EXPECT_EQ(rims(wall.mesh, Side::inner).size(), 2u);
    EXPECT_TRUE(rims(make_box({2, 2, 2}, 1e-3), Side::outer).empty());
}

}  // namespace rim_shapes
