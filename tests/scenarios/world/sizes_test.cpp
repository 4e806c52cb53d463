// The sizes and strengths of what a drill leaves out, against literals with their sources.
#include <gtest/gtest.h>

#include <limits>

#include "scenarios/world/defs.hpp"
#include "scenarios/world/soft_vessel.hpp"

namespace sizes_of_scenes {

using scenarios::world::VesselDef;
using scenarios::world::WorldDef;
using sim::geometry::Vec3;

constexpr double mm = 1e-3;

// What a drill gets that says nothing: 6-0 polypropylene of 0.085 mm, the middle of USP's 0.070 to 0.099, which bears
// 1.96 N at the knot; a vessel of 4 mm that a needle goes through at 50 mN; a tick of a millisecond.
TEST(Sizes, OfASceneOfWhichNothingIsSaid) {
    const scenarios::world::ThreadDef thread;
    EXPECT_EQ(thread.size, "6-0");
    EXPECT_EQ(thread.material, "polypropylene");
    EXPECT_EQ(thread.diameter, 0.085e-3);
    EXPECT_EQ(thread.length, 0.150);
    EXPECT_EQ(thread.young_modulus, 2.8e9);
    EXPECT_EQ(thread.bending_share, 1);
    EXPECT_EQ(thread.density, 905);
    EXPECT_EQ(thread.break_force, 1.96);
    EXPECT_EQ(thread.friction, 0.15);
    EXPECT_EQ(thread.friction_tool, 0.15);
    EXPECT_EQ(thread.links, 300);
    const VesselDef vessel;
    EXPECT_EQ(vessel.diameter, 4e-3);
    EXPECT_EQ(vessel.wall, 0.6e-3);
    EXPECT_EQ(vessel.length, 30e-3);
    EXPECT_EQ(vessel.cut_angle, 90);
    EXPECT_EQ(vessel.young_modulus, 0.1e6);
    EXPECT_EQ(vessel.puncture_force, 0.05);
    EXPECT_EQ(WorldDef{}.tick_s, 1e-3);
    EXPECT_EQ(scenarios::world::InstrumentDef{}.pull, std::numeric_limits<double>::infinity());
}

// Air: 0.10 s for 6-0 and 0.01 s for 10-0 (Lamb's drag of a slender body). A needle's first link is halved until its
// far node is off the needle's circle by half the thread's radius at most.
TEST(Sizes, OfWhatFollowsFromThem) {
    scenarios::world::ThreadDef thread;
    EXPECT_NEAR(halting_time(thread), 0.0999, 1e-4);
    thread.diameter = 0.025e-3;
    EXPECT_NEAR(halting_time(thread), 0.00864, 1e-5);
    WorldDef def;
    EXPECT_NEAR(first_link(def), 0.5 * mm, 1e-12);
    def.needle_code = "BV-1";
    EXPECT_NEAR(first_link(def), 0.25 * mm, 1e-12);
    def.needle.radius = 1 * mm;
    EXPECT_NEAR(first_link(def), 0.125 * mm, 1e-12);
}

// A wall takes from its vessel how stiff it is, what pierces it and how thick it is, and from the needle's wire, of
// 0.1 mm here, how wide its holes are: half as wide again.
TEST(Sizes, OfAVesselsWall) {
    VesselDef def;
    def.is_soft = true;
    def.young_modulus = 0.37e6;
    def.puncture_force = 0.021;
    def.wall = 0.7 * mm;
    const scenarios::world::SoftVessel vessel(def, 0.1 * mm);
    EXPECT_EQ(vessel.tissue.material().young, 0.37e6);
    EXPECT_EQ(vessel.bites.def().puncture, 0.021);
    EXPECT_EQ(vessel.bites.def().wall, 0.7 * mm);
    EXPECT_EQ(vessel.bites.def().grip, 2);
    EXPECT_NEAR(vessel.bites.def().hole, 0.15 * mm, 1e-12);
    EXPECT_EQ(vessel.bites.def().axis, Vec3(Vec3::UnitX()));
}

}  // namespace sizes_of_scenes
