// Jaws that close on walls.
#include <gtest/gtest.h>

#include "tests/scenarios/world/scene.hpp"

namespace wall_gripping {

using namespace scene;

// A vessel along x between the jaws of forceps that open along z.
struct Pinched : Scene {
    Pinched() {
        def.vessels = {held_vessel()};
        const Quat along_y(Eigen::AngleAxisd(-0.5 * EIGEN_PI, Vec3::UnitX()) *
                           Eigen::AngleAxisd(0.5 * EIGEN_PI, Vec3::UnitZ()));
        add("forceps", Kind::forceps, {{{0, 2.5 * mm, 0}, along_y}, 1});
        lay_aside();
    }
};

// A vessel pinched flat is held by both its walls; held by one, the other would spring out through a jaw.
TEST(WallGrip, HoldsBothWallsOfAVesselPinchedFlat) {
    Pinched scene;
    World world = scene.world();
    for (int t = 0; t < 500; ++t) {
        scene.tools[0].jaw = std::max(0.0, 1 - 0.0025 * t);
        scene.play(world);
    }
    const tissue::Tissue& wall = world.vessels()[0].tissue;
    int above = 0, below = 0;
    for (const auto& grip : world.tools()[0].walls)
        (tissue::position(grip.at, wall.rest(), wall.rest().nodes).z() > 0 ? above : below)++;
    EXPECT_GT(above, 20);
    EXPECT_GT(below, 20);
    for (const auto& grip : world.tools()[0].walls)
        EXPECT_LT(std::abs(wall.position(grip.at).z()), scene.def.vessels[0].wall);
    ASSERT_EQ(world.events().size(), 1u);
    EXPECT_EQ(world.events()[0].kind, scenarios::world::EventKind::wall_grasp);
    EXPECT_EQ(world.events()[0].what, "forceps, vessel");
    EXPECT_EQ(world.events()[0].value, above + below) << "points held";
}

}  // namespace wall_gripping
