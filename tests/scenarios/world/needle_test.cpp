// A needle goes with who holds it, stays where it is let go, and leads the thread by its tail.
#include <gtest/gtest.h>

#include "tests/scenarios/world/scene.hpp"

namespace needles {

using namespace scene;
using scenarios::world::EventKind;
using sim::geometry::Arc;

// A needle in the plane of x and z, tail to the right, its back up; two needle holders that come from +y and -y can
// close on it.
struct Upright : Scene {
    Upright() {
        def.needle_code = "BV-1";
        def.needle = {
            .to_tail = Vec3::UnitX(), .onwards = Vec3::UnitZ(), .radius = 3.95 * mm, .angle = 2.356, .wire = 0.1 * mm};
        lay({def.needle.tail(), def.needle.tail() - 30 * mm * def.needle.tangent(0)}, 100);
        add("right", Kind::needle_holder, {across_y(2 * mm, 1), 1});
        add("left", Kind::forceps, {across_y(7 * mm, -1), 1});
    }

    // Jaws across the wire `along` from its tail, whose tool points along y or against it.
    instruments::Pose across_y(double along, double way) const {
        return across(def.needle.at(along), def.needle.tangent(along), way * Vec3::UnitY());
    }
};

double off(const Arc& a, const Arc& b) {
    return (a.tail() - b.tail()).norm() + (a.tip() - b.tip()).norm();
}

TEST(Needle, GoesWithItsHolderAndLeadsTheThread) {
    Upright scene;
    World world = scene.world();
    const auto go = [&](int ticks) { scene.play(world, ticks); };
    go(10);
    EXPECT_EQ(off(world.needle(), scene.def.needle), 0) << "nobody holds it";
    scene.tools[0].jaw = 0;
    go(10);
    EXPECT_EQ(count(world, EventKind::needle_grasp), 1u);
    EXPECT_NEAR(world.events().back().value, 2, 0.01);  // millimetres from its tail; looks are chords
    EXPECT_TRUE(world.tools()[0].grasps.empty()) << "jaws that hold the needle hold no thread";
    for (int t = 0; t < 500; ++t) {
        scene.tools[0].pose.position.x() += 0.02 * mm;  // 20 mm/s
        world.tick(scene.tools);
    }
    go(5);
    EXPECT_LT((world.needle().tail() - scene.def.needle.tail() - Vec3(10 * mm, 0, 0)).norm(),
              1e-12);  // a millionth of the thread, for rounding
    EXPECT_LT((world.thread()[0] - world.needle().tail()).norm(), 1e-3 * scene.def.thread.diameter);
    const Vec3 first = (world.thread()[0] - world.thread()[1]).normalized();
    EXPECT_GT(first.dot(world.needle().tangent(0)), 0.999) << "along the wire";
    EXPECT_EQ(world.measures().pass_throughs, 0u);
}

// Crushed beside the wire and not held, it stopped the tool, and with it all others.
TEST(Needle, AStrandBetweenTheSameJawsIsHeldToo) {
    Upright scene;
    const Vec3 along = scene.def.needle.tangent(2 * mm), beside = scene.def.needle.at(2 * mm) - 1 * mm * Vec3::UnitY();
    scene.def.thread.model = "elastic";
    scene.def.thread.start = {scene.def.needle.tail(), scene.def.needle.tail() - 6 * mm * scene.def.needle.tangent(0),
                              beside - 8 * mm * along, beside + 8 * mm * along};
    World world = scene.world();
    for (int t = 0; t < 100; ++t) world.tick(scene.tools), scene.tools[0].jaw -= 0.01;
    EXPECT_EQ(count(world, EventKind::needle_grasp), 1u);
    EXPECT_EQ(world.tools()[0].grasps.size(), 1u);
    scene.tools[0].jaw = 0;
    for (int t = 0; t < 200; ++t) scene.tools[0].pose.position.x() += 0.02 * mm, world.tick(scene.tools);
    EXPECT_EQ(world.tools()[0].lag(), 0);
    EXPECT_EQ(world.measures().pass_throughs, 0u);
}

TEST(Needle, TellsAtWhatAngleItIsHeld) {
    for (const double aslant : {0.0, 30.0}) {
        Upright scene;
        const auto half = sim::geometry::portable_sin_cos(aslant / 360 * 3.14159265358979);
        auto& rotation = scene.tools[0].pose.rotation;
        const Vec3 at = scene.tools[0].pose.position;
        rotation = rotation * sim::geometry::Quat(half.cos, 0, 0, half.sin);  // about its own axis
        scene.tools[0].pose.position = at;
        World world = scene.world();
        for (int t = 0; t < 10; ++t) world.tick(scene.tools), scene.tools[0].jaw = 0;
        ASSERT_EQ(count(world, EventKind::needle_grasp), 1u);
        EXPECT_EQ(world.events().back().what, aslant == 0 ? "right at 90 degrees" : "right at 60 degrees");
        ASSERT_TRUE(world.measures().needle_deg);
        EXPECT_NEAR(world.measures().needle_deg->value, 90 - aslant, 0.5);  // as the event rounds
        for (int t = 0; t < 20; ++t) scene.tools[0].jaw = t < 10, world.tick(scene.tools);
        EXPECT_NEAR(world.measures().needle_deg->value, 90 - aslant, 0.5) << "taken again alike";
    }
}

// Pushed tip first against a wall that it cannot pierce: once it is pushed harder than steel of its wire bears that far
// from the jaws.
TEST(Needle, BendsOnce) {
    Upright scene;
    const Vec3 on = scene.def.needle.tangent(scene.def.needle.length());
    scenarios::world::VesselDef wall;
    wall.axis = Vec3::UnitY();
    wall.length = 8 * mm;
    wall.centre = scene.def.needle.tip() + (0.5 * wall.diameter + 0.2 * mm) * on;
    wall.is_soft = true;
    wall.young_modulus = 2e6;
    wall.puncture_force = 100;
    scene.def.vessels = {wall};
    scene.tools[1].pose.position.y() -= 40 * mm;
    World world = scene.world();
    const auto force = [&] { return world.vessels()[0].bites.force().norm(); };
    for (int t = 0; t < 5; ++t) world.tick(scene.tools), scene.tools[0].jaw = 0;
    const double arm = (scene.def.needle.tip() - scene.def.needle.at(2 * mm)).norm(),
                 bears = instruments::yield_moment(0.1 * mm) / arm;
    double before = 0;
    while (count(world, EventKind::needle_bent) == 0 && world.time_s() < 2) {
        before = force();
        scene.tools[0].pose.position += 5 * mm * 1e-3 * on;
        world.tick(scene.tools);
    }
    ASSERT_EQ(count(world, EventKind::needle_bent), 1u);
    EXPECT_LE(before, bears);
    EXPECT_NEAR(world.events().back().value, bears, 0.05 * bears);  // what a step of 10 um adds to it
    EXPECT_NEAR(bears, 1.414e-3 / 6.30e-3, 1e-3);  // [N]: pi / 4 x 1.8 GPa x (0.1 mm)^3 over the chord of 7.3 mm
    const Arc there = world.needle();
    for (int t = 0; t < 200; ++t) {
        scene.tools[0].pose.position += 10 * mm * 1e-3 * on;
        world.tick(scene.tools);
    }
    EXPECT_EQ(count(world, EventKind::needle_bent), 1u);
    EXPECT_NEAR((world.needle().tip() - there.tip()).norm(), 2 * mm, 0.05 * mm) << "it stays as it is";
}

TEST(Needle, IsHandedOverAndStaysWhereItIsLetGo) {
    Upright scene;
    World world = scene.world();
    const auto go = [&](int ticks) { scene.play(world, ticks); };
    scene.tools[0].jaw = 0;
    go(5);
    scene.tools[1].jaw = 0;
    go(5);
    scene.tools[1].pose.position.z() += 1 * mm;
    go(20);
    EXPECT_LT(off(world.needle(), scene.def.needle), 1e-12) << "the first leads";
    scene.tools[1].pose.position.z() -= 1 * mm;
    go(20);
    scene.tools[0].jaw = 1;
    go(5);
    EXPECT_LT(off(world.needle(), scene.def.needle), 1e-12) << "it does not leap when it changes hands";
    for (int t = 0; t < 100; ++t) {
        scene.tools[1].pose.position.z() += 0.02 * mm;
        world.tick(scene.tools);
    }
    EXPECT_LT((world.needle().tip() - scene.def.needle.tip() - Vec3(0, 0, 2 * mm)).norm(), 1e-12);
    const Arc there = world.needle();
    scene.tools[1].jaw = 1;
    go(10);
    scene.tools[1].pose.position.z() += 1 * mm;
    go(50);
    EXPECT_EQ(off(world.needle(), there), 0);
    EXPECT_EQ(count(world, EventKind::needle_grasp), 2u);
    EXPECT_EQ(count(world, EventKind::needle_release), 2u);
}

// Each leads its own thread, whatever becomes of the other's links.
TEST(Needle, IsHeldNoMoreByJawsThatLeftIt) {
    Upright scene;
    World world = scene.world();
    const auto go = [&](int ticks, double up) {
        for (int t = 0; t < ticks; ++t) {
            scene.tools[1].pose.position.z() += up;
            world.tick(scene.tools);
        }
    };
    scene.tools[0].jaw = 0;
    go(5, 0);
    scene.tools[1].jaw = 0;
    go(5, 0);
    go(400, 0.05 * mm);
    EXPECT_EQ(count(world, EventKind::needle_release), 1u);
    scene.tools[0].jaw = 1;
    go(5, 0);
    EXPECT_EQ(count(world, EventKind::needle_release), 2u);
    go(100, 0.05 * mm);
    EXPECT_LT(off(world.needle(), scene.def.needle), 1e-12) << "it follows jaws 20 mm away";
}

TEST(Needle, ASpareLeadsItsOwnThread) {
    Upright scene;
    const Vec3 aside(0, 60 * mm, 0);
    scene.def.thread.model = "elastic";
    scene.def.thread.shortest_link = scene.def.thread.diameter;
    scenarios::world::SpareDef spare{scene.def.needle, scene.def.thread.start};
    spare.needle.centre += aside;
    for (Vec3& corner : spare.start) corner += aside;
    scene.def.spares = {spare};
    const Arc& first = scene.def.needle;
    auto& tools = scene.tools;
    tools[0].pose.position += aside;
    scene.add("scissors", Kind::scissors,
              {across(first.tail() - 10 * mm * first.tangent(0), first.tangent(0), Vec3::UnitY()), 1});
    World world = scene.world();
    const auto go = [&](int ticks, const Vec3& way) {
        for (int t = 0; t < ticks; ++t) tools[0].pose.position += way, world.tick(tools);
    };
    const auto off_tail = [&](std::size_t needle) {
        const auto& of = world.needles()[needle];
        return (world.thread()[static_cast<std::size_t>(of.node)] - of.now.tail()).norm();
    };
    ASSERT_EQ(world.curves().size(), 2u);
    go(10, Vec3::Zero());
    tools[0].jaw = 0, tools[2].jaw = 0;
    go(50, Vec3::Zero());
    ASSERT_EQ(world.curves().size(), 3u) << "the first is cut";
    go(1000, 0.03 * mm * Vec3::UnitX());
    EXPECT_EQ(&world.needle_in_use(), &world.needles()[1]);
    EXPECT_EQ(off(world.needles()[0].now, first), 0);
    EXPECT_NEAR((world.needle().tail() - spare.needle.tail()).norm(), 30 * mm, 1e-9 * mm);
    const double touching = 1e-3 * scene.def.thread.diameter;
    EXPECT_LT(off_tail(0), touching);
    EXPECT_LT(off_tail(1), touching);
    EXPECT_GT((world.curves().back().back() - spare.start.back()).norm(), 5 * mm) << "its thread comes after it";
    EXPECT_LT((world.curves()[0].back() - first.tail()).norm(), 11 * mm) << "what is left on the first stays with it";
    EXPECT_EQ(world.measures().pass_throughs, 0u);
}

// The second has it from where the first last had it, not from where it was when the second closed on it.
TEST(Needle, IsHandedOverFromWhereItIsNow) {
    Upright scene;
    World world = scene.world();
    const auto go = [&](int ticks, double up = 0) {
        for (int t = 0; t < ticks; ++t) scene.tools[0].pose.position.z() += up, world.tick(scene.tools);
    };
    for (ToolInput& tool : scene.tools) tool.jaw = 0, go(5);
    go(10, 0.01 * mm);
    Arc moved = scene.def.needle;
    moved.centre.z() += 0.1 * mm;
    EXPECT_LT(off(world.needle(), moved), 1e-12) << "the first leads";
    scene.tools[0].jaw = 1;
    go(10);
    EXPECT_LT(off(world.needle(), moved), 1e-12);
    scene.tools[1].pose.position.z() += 0.1 * mm;
    go(5);
    moved.centre.z() += 0.1 * mm;
    EXPECT_LT(off(world.needle(), moved), 1e-12) << "the second leads";
}

}  // namespace needles
