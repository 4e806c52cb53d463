// Tools that are led through walls that give way.
#include <gtest/gtest.h>

#include "tests/scenarios/world/scene.hpp"

namespace crossed_walls {

using namespace scene;
using scenarios::world::EventKind;

// A vessel along x, held at both ends, and forceps above it that point down, shut.
struct Above : Scene {
    Above() {
        scenarios::world::VesselDef vessel;
        vessel.diameter = 3.5 * mm, vessel.wall = 0.6 * mm, vessel.length = 12 * mm;
        vessel.is_soft = true;
        vessel.young_modulus = 0.2e6;
        def.vessels = {vessel};
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

std::vector<scenarios::world::Event> crossings(const World& world) {
    std::vector<scenarios::world::Event> found;
    for (const auto& event : world.events())
        if (event.kind == EventKind::wall_crossed) found.push_back(event);
    return found;
}

TEST(CrossedWalls, ADentIsNone) {
    Above scene;
    World world = scene.world();
    scene.lead_to(world, 1.2 * mm);  // half a millimetre into the wall
    EXPECT_TRUE(crossings(world).empty());
    EXPECT_EQ(world.measures().walls_crossed, 0);
}

TEST(CrossedWalls, AToolLedThroughAVesselIsToldOnceEachTime) {
    Above scene;
    World world = scene.world();
    scene.lead_to(world, -6 * mm);
    ASSERT_EQ(crossings(world).size(), 1u);
    EXPECT_EQ(crossings(world)[0].what, "forceps, vessel");
    EXPECT_EQ(world.measures().walls_crossed, 1);
    EXPECT_EQ(world.measures().first_crossed_s, crossings(world)[0].t_s);
    scene.lead_to(world, 6 * mm);
    EXPECT_EQ(world.tools()[0].crosses, -1);
    scene.lead_to(world, -6 * mm);
    EXPECT_EQ(world.measures().walls_crossed, 2);
}

}  // namespace crossed_walls
