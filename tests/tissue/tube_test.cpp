#include "tissue/tube.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace tissue {

static void PrintTo(const TubeDef& def, std::ostream* out) {
    *out << 1e3 * def.diameter << "_mm_cut_at_" << def.cut_angle << "_" << def.around << "_around";
}

}  // namespace tissue

namespace {

using namespace tissue;

constexpr double pi = std::numbers::pi;

double volume_of(const Mesh& mesh) {
    double sum = 0;
    for (const Tetrahedron& tet : mesh.tetrahedra) sum += volume(tet, mesh.nodes);
    return sum;
}

Vec3 area_of(const Mesh& mesh, const Face& face) {
    const auto at = [&](std::size_t k) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(face.nodes[k])]; };
    return 0.5 * (at(1) - at(0)).cross(at(2) - at(0));
}

double area_of(const Mesh& mesh, Side side) {
    double sum = 0;
    for (const Face& face : mesh.faces)
        if (face.side == side) sum += area_of(mesh, face).norm();
    return sum;
}

double volume_inside_faces(const Mesh& mesh) {
    double sum = 0;
    for (const Face& face : mesh.faces)
        sum += mesh.nodes[static_cast<std::size_t>(face.nodes[0])].dot(area_of(mesh, face)) / 3;
    return sum;
}

// As many ways along an edge as back: the surface has no hole, and all of it faces outwards.
bool is_watertight(const Mesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (const Face& face : mesh.faces)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{face.nodes[k], face.nodes[(k + 1) % 3]}];
    for (const auto& [edge, uses] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        if (uses != 1 || back == edges.end()) return false;
    }
    return true;
}

struct Tube : testing::TestWithParam<TubeDef> {};

// Slanted or straight, the cylinder's volume to rounding: each section has the ring's area, and a slant takes from one
// side what it gives to the other.
TEST_P(Tube, HasTheVolumeOfARing) {
    const TubeDef& def = GetParam();
    const Mesh mesh = make_tube(def);
    const double expected = pi * (def.diameter - def.wall) * def.wall * def.length;
    EXPECT_NEAR(volume_of(mesh), expected, 1e-12 * expected);
    EXPECT_NEAR(volume_inside_faces(mesh), expected, 1e-12 * expected);
    for (const Tetrahedron& tet : mesh.tetrahedra) EXPECT_GT(volume(tet, mesh.nodes), 0);
}

TEST_P(Tube, IsWatertight) {
    EXPECT_TRUE(is_watertight(make_tube(GetParam())));
}

// Flat ends are as large as the ring, over the sine of the cut's angle; a polygon's side is below a circle's by a share
// of 2 (pi / around)^2 at most.
TEST_P(Tube, KnowsItsSides) {
    const TubeDef& def = GetParam();
    const Mesh mesh = make_tube(def);
    const double ring = pi * (def.diameter - def.wall) * def.wall, polygon = 2 * pi * pi / (def.around * def.around);
    EXPECT_NEAR(area_of(mesh, Side::far_end), ring, 1e-9 * ring);
    EXPECT_NEAR(area_of(mesh, Side::cut), ring / std::sin(def.cut_angle * pi / 180), 1e-9 * ring);
    if (def.cut_angle == 90) {
        EXPECT_NEAR(area_of(mesh, Side::outer), pi * def.diameter * def.length,
                    polygon * pi * def.diameter * def.length);
        const double inner = pi * (def.diameter - 2 * def.wall) * def.length;
        EXPECT_NEAR(area_of(mesh, Side::inner), inner, polygon * inner);
    }
    for (const Face& face : mesh.faces) {
        const Vec3 out = area_of(mesh, face), middle = mesh.nodes[static_cast<std::size_t>(face.nodes[0])];
        const double from_axis = out.y() * middle.y() + out.z() * middle.z();
        switch (face.side) {
            case Side::outer:
                EXPECT_GT(from_axis, 0);
                break;
            case Side::inner:
                EXPECT_LT(from_axis, 0);
                break;
            case Side::cut:
                EXPECT_LT(out.x(), 0);
                break;
            case Side::far_end:
                EXPECT_GT(out.x(), 0);
                break;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Defs, Tube,
                         testing::Values(TubeDef{}, TubeDef{.cut_angle = 60},
                                         TubeDef{.cut_angle = 45, .around = 6, .through = 1},
                                         TubeDef{.diameter = 1e-3,
                                                 .wall = 0.1e-3,
                                                 .length = 2e-3,
                                                 .around = 32,
                                                 .through = 3,
                                                 .near = 5,
                                                 .near_length = 2e-3,
                                                 .far = 0}));

TEST(TubeDef, IsFineNearTheCut) {
    const TubeDef def;
    const Mesh mesh = make_tube(def);
    int near = 0;
    for (const Tetrahedron& tet : mesh.tetrahedra) {
        double end = 0;
        for (const int i : tet) end = std::max(end, mesh.nodes[static_cast<std::size_t>(i)].x());
        near += end <= def.near_length * (1 + 1e-12);
    }
    EXPECT_GE(near, 1500);
    EXPECT_EQ(near, 6 * def.around * def.through * def.near);
    EXPECT_EQ(mesh.tetrahedra.size(), mesh.cells.size() * 6 - 6);
}

TEST(TubeDef, SaysWhatIsWrong) {
    EXPECT_FALSE(problem_with({}));
    EXPECT_EQ(problem_with({.wall = 2e-3}), "wall must be above 0 and below half of the diameter");
    EXPECT_EQ(problem_with({.cut_angle = 30}), "cut angle must be 45 to 90 degrees");
    EXPECT_EQ(problem_with({.around = 7}), "cells around must be an even number, at least 6");
    EXPECT_TRUE(problem_with({.through = 0}));
    EXPECT_TRUE(problem_with({.length = 3e-3}));
    EXPECT_TRUE(problem_with({.far = 0}));
    EXPECT_TRUE(problem_with({.diameter = std::nan("")}));
}

TEST(Box, IsWatertightAndWhole) {
    const Mesh box = make_box({2, 3, 1}, 1e-3);
    EXPECT_NEAR(volume_of(box), 6e-9, 1e-21);
    EXPECT_TRUE(is_watertight(box));
}

}  // namespace
