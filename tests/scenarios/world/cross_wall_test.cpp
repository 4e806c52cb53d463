// Tools that are led through walls that give way.
#include <gtest/gtest.h>

#include "tests/scenarios/world/scene.hpp"

namespace crossed_walls {

using namespace scene;
using scenarios::world::EventKind;

// A vessel along x, held at both ends, and forceps above it that point down, shut.
struct Above : Scene {
    Above() {
        def.vessels = {held_vessel()};
        const Quat down(Eigen::AngleAxisd(EIGEN_PI, Vec3::UnitX()));
        add("forceps", Kind::forceps, {{{0, 0, 5 * mm}, down}, 0});
        lay({{0, 20 * mm, 0}, {6 * mm, 20 * mm, 0}}, 12);
    }
    // Leads the tool to a height of its tip at 20 mm/s, and stays for 50 ms.
    void lead_to(World& world, double height) {
        const double step = (height - tools[0].pose.position.z()) / 200;
        for (int t = 0; t < 250; ++t) {
            if (t < 200) tools[0].pose.position.z() += step;
            play(world);
        }
    }
};

TEST(CrossedWalls, ADentIsNone) {
    Above scene;
    World world = scene.world();
    scene.lead_to(world, 1.2 * mm);  // half a millimetre into the wall
    EXPECT_EQ(count(world, EventKind::wall_crossed), 0u);
    EXPECT_EQ(world.measures().walls_crossed, 0);
}

TEST(CrossedWalls, AToolLedThroughAVesselIsToldOnceEachTime) {
    Above scene;
    World world = scene.world();
    scene.lead_to(world, -6 * mm);
    ASSERT_EQ(world.events().size(), 1u);
    const auto crossed = world.events()[0];
    EXPECT_EQ(crossed.kind, EventKind::wall_crossed);
    EXPECT_EQ(crossed.what, "forceps, vessel");
    EXPECT_EQ(world.measures().walls_crossed, 1);
    EXPECT_EQ(world.measures().first_crossed_s, crossed.t_s);
    scene.lead_to(world, 6 * mm);
    EXPECT_EQ(world.tools()[0].crosses, -1);
    scene.lead_to(world, -6 * mm);
    EXPECT_EQ(world.measures().walls_crossed, 2);
}

}  // namespace crossed_walls
