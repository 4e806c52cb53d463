#include "tissue/lumen.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tissue/tube.hpp"

namespace lumen_areas {

using namespace tissue;

constexpr double pi = std::numbers::pi, mm = 1e-3;

struct Lumen {
    explicit Lumen(double cut_angle = 90) : mesh(make_tube({.cut_angle = cut_angle})) {
        for (const Face& face : mesh.faces)
            if (face.side == Side::inner) faces.push_back(face);
    }
    template <class Moved>
    double ratio(const Moved& moved, const Vec3& axis = Vec3::UnitX()) const {
        std::vector<Vec3> nodes;
        for (const Vec3& p : mesh.nodes) nodes.push_back(moved(p));
        return lumen_ratio(rims(mesh, Side::inner)[0], mesh, nodes, axis);
    }
    Mesh mesh;
    std::vector<Face> faces;
};

// Of a tube 3 mm wide within: across, aslant, and where a plane runs out of its end.
TEST(Lumen, HasTheSectionsOfATube) {
    const Lumen tube;
    const double across = pi * 1.5 * mm * 1.5 * mm;
    EXPECT_NEAR(section_area(tube.faces, tube.mesh.nodes, {3.1 * mm, 0, 0}, Vec3::UnitX()).value(), across,
                1e-9 * across);
    EXPECT_NEAR(section_area(tube.faces, tube.mesh.nodes, {3.1 * mm, 0, 0}, -Vec3::UnitX()).value(), across,
                1e-9 * across);
    const Vec3 slanted = Vec3(1, 0.8, 0.3).normalized();
    EXPECT_NEAR(section_area(tube.faces, tube.mesh.nodes, {4 * mm, 0, 0}, slanted).value(), across / slanted.x(),
                1e-9 * across);
    EXPECT_FALSE(section_area(tube.faces, tube.mesh.nodes, {0.1 * mm, 0, 0}, slanted));
    EXPECT_FALSE(section_area(tube.faces, tube.mesh.nodes, {-1 * mm, 0, 0}, Vec3::UnitX()));
}

// Drawn together like a purse at its rim; a waist further in; moved, turned and wider: what it narrows to, whichever
// way its axis was named.
TEST(Lumen, KnowsWhereItIsNarrow) {
    for (const double angle : {90.0, 60.0}) {
        const Lumen tube(angle);
        for (const double way : {1.0, -1.0}) {
            const Vec3 axis = way * Vec3::UnitX();
            EXPECT_NEAR(tube.ratio([](const Vec3& p) { return p; }, axis), 1, 1e-9);
            EXPECT_NEAR(tube.ratio([](const Vec3& p) { return Vec3(p.x(), 0.8 * p.y(), 0.7 * p.z()); }, axis), 0.56,
                        1e-9);
            const sim::geometry::Quat turn = sim::geometry::Quat(0.2, 0.4, -0.6, 0.3).normalized();
            EXPECT_NEAR(tube.ratio([&](const Vec3& p) { return Vec3(turn * p * 1.3 + Vec3(0, 0.1, 0)); }, axis), 1.69,
                        1e-9);
        }
    }
    const auto narrowed = [](const Vec3& p, double share) { return Vec3(p.x(), share * p.y(), share * p.z()); };
    EXPECT_NEAR(Lumen().ratio([&](const Vec3& p) { return narrowed(p, 0.6 + 100 * p.x()); }), 0.36, 1e-9);
    const double waist =
                     Lumen().ratio([&](const Vec3&p) { return narrowed(p, 0.5 + 250 * std::abs(p.x() - 1.5 * mm)); }),
                 off = 250 * 3.02 * mm / 32;
    EXPECT_GE(waist, 0.25 - 1e-9);
    EXPECT_LE(waist, (0.5 + off) * (0.5 + off));  // half way between two sections
}

TEST(Lumen, KnowsWhatIsInIt) {
    const Lumen tube;
    const Skin skin(tube.mesh);
    Mesh mirrored = tube.mesh;
    for (Vec3& node : mirrored.nodes) node = {-node.x(), -node.y(), node.z()};
    const Skin other(mirrored);
    const double side = 1.5 * mm * std::sqrt(2 * pi / 16 / std::sin(2 * pi / 16)) * std::cos(pi / 16);  // the polygon's
    const Vec3 out(0, std::cos(pi / 16), std::sin(pi / 16));
    for (const double x : {-3 * mm, -0.01 * mm, 0.01 * mm, 2 * mm}) {
        EXPECT_NEAR(depth_in_lumen({x, 0, 0}, skin, other, 3 * mm), side, 1e-9);
        EXPECT_NEAR(depth_in_lumen(x * Vec3::UnitX() + (side - 0.2 * mm) * out, skin, other, 3 * mm), 0.2 * mm, 1e-9);
        EXPECT_EQ(depth_in_lumen({x, 0, 0}, skin, other, 1 * mm), 0);
        for (const double wall : {0.01, 0.2, 0.45, 0.6, 2.0})
            EXPECT_EQ(depth_in_lumen(x * Vec3::UnitX() + (side + wall * mm) * out, skin, other, 3 * mm), 0);
    }
    EXPECT_EQ(depth_in_lumen({-2 * mm, 0, 0}, skin, skin, 3 * mm), 0);  // well off an open end
}

// All the way to a diameter, 3 mm, from the cut, and no further: what is narrow beyond that is no lapse of this join.
TEST(Lumen, LooksADiameterFar) {
    const auto waist = [](double at) {
        return Lumen().ratio([&](const Vec3& p) {
            const double share = std::min(1.0, 0.5 + 400 * std::abs(p.x() - at));
            return Vec3(p.x(), share * p.y(), share * p.z());
        });
    };
    for (const double at : {0.5 * mm, 1.5 * mm, 2.5 * mm, 2.9 * mm}) {
        EXPECT_GE(waist(at), 0.25 - 1e-9) << at;
        EXPECT_LE(waist(at), 0.4) << at;
    }
    EXPECT_NEAR(waist(4.8 * mm), 1, 1e-9);
}

}  // namespace lumen_areas
