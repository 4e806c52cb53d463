// A needle's arc, equally long links on a path, and what a tree of triangles says of those that moved.
#include "sim/geometry/arc.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "sim/geometry/resample.hpp"
#include "sim/geometry/triangle_tree.hpp"

namespace arcs {

using namespace sim::geometry;

constexpr double pi = std::numbers::pi, mm = 1e-3;

// Three eighths of a circle of 4 mm radius, from its tail on the x axis over the z axis.
const Arc needle{.centre = Vec3(1 * mm, 0, 0),
                 .to_tail = Vec3::UnitX(),
                 .onwards = Vec3::UnitZ(),
                 .radius = 4 * mm,
                 .angle = 0.75 * pi};

TEST(Arc, GoesFromItsTailToItsTip) {
    EXPECT_NEAR(needle.length(), 3 * pi * mm, 1e-15);
    EXPECT_LT((needle.tail() - Vec3(5 * mm, 0, 0)).norm(), 1e-15);
    EXPECT_LT((needle.at(2 * pi * mm) - Vec3(1 * mm, 0, 4 * mm)).norm(), 1e-15);
    EXPECT_LT((needle.tip() - Vec3(mm - 4 * mm * std::sqrt(0.5), 0, 4 * mm * std::sqrt(0.5))).norm(), 1e-15);
    EXPECT_LT((needle.tangent(0) - Vec3::UnitZ()).norm(), 1e-15);
    EXPECT_LT((needle.tangent(2 * pi * mm) + Vec3::UnitX()).norm(), 1e-15);
}

TEST(Arc, IsMadeLongerAtItsTail) {
    const Arc longer = needle.longer(1 * mm);
    EXPECT_NEAR(longer.length(), needle.length() + 1 * mm, 1e-15);
    EXPECT_LT((longer.tip() - needle.tip()).norm(), 1e-15);
    EXPECT_LT((longer.at(1 * mm) - needle.tail()).norm(), 1e-15);
    EXPECT_LT((longer.tangent(1 * mm) - needle.tangent(0)).norm(), 1e-15);
}

TEST(Resample, LinksAreEquallyLongAlongThePath) {
    const std::vector<Vec3> corner{{0, 0, 0}, {3, 0, 0}, {3, 5, 0}};
    const auto nodes = resample(corner, 16);
    ASSERT_EQ(nodes.size(), 17u);
    for (int k = 0; k <= 16; ++k) {
        const double along = 0.5 * k;
        const Vec3 wanted = along <= 3 ? Vec3(along, 0, 0) : Vec3(3, along - 3, 0);
        EXPECT_LT((nodes[static_cast<std::size_t>(k)] - wanted).norm(), 1e-12) << k;
    }
}

// Turned upright it is as far from what is beside it as it says, and is found where it is now.
TEST(TriangleTree, KnowsWhereTrianglesAreThatMoved) {
    const Triangle flat{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)},
        upright{Vec3(2, -1, -1), Vec3(2, 1, -1), Vec3(2, 0, 1)};
    TriangleTree tree({flat});
    EXPECT_NEAR(tree.plane_gap(0, Vec3(0, 0, 0.3), Vec3(1, 0, 0.5)), 0.3, 1e-15);
    tree.move(std::vector<Triangle>{upright});
    EXPECT_NEAR(tree.plane_gap(0, Vec3(0, 0, 0.3), Vec3(1.5, 0, 0.5)), 0.5, 1e-15);
    EXPECT_EQ(tree.plane_gap(0, Vec3(1, 0, 0), Vec3(3, 0, 0)), 0) << "it goes through";
    std::vector<int> found;
    tree.near({Vec3(1.9, -0.1, -0.1), Vec3(2.1, 0.1, 0.1)}, found);
    EXPECT_EQ(found, std::vector<int>{0});
    found.clear();
    tree.near({Vec3(-0.1, -0.1, -0.1), Vec3(0.1, 0.1, 0.1)}, found);
    EXPECT_TRUE(found.empty());
}

TEST(TriangleTree, TellsWhichPieceOfAPathComesNearer) {
    const TriangleTree floor({{Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 9, 0)}});
    const std::vector<Vec3> path{{0, 0, 5}, {0, 0, 3}, {0, 0, 1}, {0, 0, 2}};
    EXPECT_EQ(first_nearer(path, floor, 0.99), -1);
    EXPECT_EQ(first_nearer(path, floor, 1.01), 1);
    EXPECT_EQ(first_nearer(path, floor, 3.01), 0);
}

}  // namespace arcs
