// Jaws that close on walls.
#include <gtest/gtest.h>

#include "scenarios/world/world.hpp"

namespace wall_gripping {

using instruments::ToolInput;
using scenarios::world::World;
using sim::geometry::Quat;
using sim::geometry::Vec3;

constexpr double mm = 1e-3;

// A vessel along x between the jaws of forceps that open along z.
struct Scene {
    scenarios::world::WorldDef def;
    ToolInput tool{
        {{0, 2.5 * mm, 0},
         Quat(Eigen::AngleAxisd(-0.5 * EIGEN_PI, Vec3::UnitX()) * Eigen::AngleAxisd(0.5 * EIGEN_PI, Vec3::UnitZ()))},
        1};

    Scene() {
        scenarios::world::VesselDef vessel;
        vessel.diameter = 3.5 * mm, vessel.wall = 0.6 * mm, vessel.length = 12 * mm;
        vessel.is_soft = true;
        vessel.young_modulus = 0.2e6;
        def.vessels = {vessel};
        def.instruments = {{"forceps", instruments::Kind::forceps}};
        def.thread.length = 6 * mm;
        def.thread.links = 12;
        def.thread.start = {{0, 0, 30 * mm}, {6 * mm, 0, 30 * mm}};
    }
};

// A vessel pinched flat is held by both its walls; held by one, the other would spring out through a jaw.
TEST(WallGrip, HoldsBothWallsOfAVesselPinchedFlat) {
    Scene scene;
    World world(scene.def, {}, {&scene.tool, 1});
    for (int t = 0; t < 500; ++t) {
        scene.tool.jaw = std::max(0.0, 1 - 0.0025 * t);
        world.tick({&scene.tool, 1});
    }
    const tissue::Tissue& wall = world.vessels()[0].tissue;
    int above = 0, below = 0;
    for (const auto& grip : world.tools()[0].walls)
        (tissue::position(grip.at, wall.rest(), wall.rest().nodes).z() > 0 ? above : below)++;
    EXPECT_GT(above, 20);
    EXPECT_GT(below, 20);
    for (const auto& grip : world.tools()[0].walls)
        EXPECT_LT(std::abs(wall.position(grip.at).z()), scene.def.vessels[0].wall);
}

}  // namespace wall_gripping
