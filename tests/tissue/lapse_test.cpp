#include <gtest/gtest.h>

#include "tests/tissue/sewn.hpp"

namespace {

using namespace tissue;
using namespace tissue::sewn;

// A quarter of the ring stands two tenths of a millimetre off.
TEST(Lapses, Disruption) {
    Operation operation;
    operation.stitches();
    operation.move([](int vessel, const Vec3& p) {
        const double angle = std::abs(std::atan2(p.z(), p.y()));
        return Vec3(p + (vessel == 1 && angle < 50 * degree ? 0.2 * mm : 0) * Vec3::UnitX());
    });
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "disruption of suture line");
    EXPECT_GT(lapses(join)[0].value, 2);
    EXPECT_EQ(committed(join, {.gap = 0.5}), "");
    EXPECT_EQ(committed(join, {.open_spacings = 4}), "");
}

// The needle took the wall across on its way, and the thread has drawn it near: the lumen is flat.
TEST(Lapses, BackWall) {
    Operation operation;
    operation.stitches(1);
    operation.begin();
    const int pass = operation.next_pass();
    operation.bite(0, {0}, Side::outer, Side::inner, pass).both_walls = true;
    operation.bite(0, {180, 0.8 * mm}, Side::inner, Side::inner, pass).both_walls = true;
    operation.bite(1, {0}, Side::inner, Side::outer, pass);
    operation.move([](int, const Vec3& p) {
        const double radius = std::hypot(p.y(), p.z()), lumen = 1.5 * mm;
        return Vec3(p.x(), p.y() * (1 - 0.98 * lumen / radius), p.z());
    });
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "back-wall stitch");
    EXPECT_NEAR(lapses(join)[1].value, 180, 1e-6);
    EXPECT_LT(join.lumen_ratio, 0.05);
    EXPECT_EQ(join.stitches.size(), 8u);
}

// From the front of one ring to the back of the other.
TEST(Lapses, StitchAcrossTheLumen) {
    Operation operation;
    operation.stitches(0, 180);
    EXPECT_NEAR(lapses(operation.judge())[1].value, 180, 1e-6);
    EXPECT_TRUE(lapses(operation.judge())[1].committed);
    EXPECT_FALSE(lapses(operation.judge())[2].committed);
}

TEST(Lapses, Oblique) {
    Operation operation;
    operation.stitches(0, 20);
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "oblique stitch");
    EXPECT_NEAR(lapses(join)[2].value, std::atan(2 * mm * 20 * degree / (2 * mm)) / degree,
                0.5);  // sixteen sides are not quite a circle
    EXPECT_EQ(committed(join, {.obliqueness = 20}), "");
}

TEST(Lapses, WideBite) {
    Operation operation;
    operation.stitches(1);
    operation.stitch({0, 1.8 * mm}, {0});
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "wide bite");
    EXPECT_NEAR(lapses(join)[3].value, 1.8 * mm / join.wall, 1e-6);
    EXPECT_EQ(committed(join, {.bite_walls = 4}), "wide bite");  // 1.8 medians
    EXPECT_EQ(committed(join, {.bite_walls = 4, .bite_medians = 2}), "");
}

// Out by the cut instead of the lumen; in and out by the outer side.
TEST(Lapses, PartialThickness) {
    Operation by_cut;
    by_cut.stitches(1);
    by_cut.begin();
    by_cut.bite(0, {0}, Side::outer, Side::cut, by_cut.next_pass());
    by_cut.bite(1, {0}, Side::inner, Side::outer, by_cut.next_pass());
    EXPECT_EQ(committed(by_cut.judge()), "partial-thickness stitch");

    Operation outside;
    outside.stitches(1);
    outside.begin();
    Bite shallow;
    shallow.state = BiteState::open, shallow.on_needle = false, shallow.pass = outside.next_pass();
    shallow.entry = outside.pierce(0, {0}, Side::outer), shallow.exit = outside.pierce(0, {0, 0.4 * mm}, Side::outer);
    outside.bites[0].push_back(shallow);
    outside.led.back() = {{0, shallow.entry.hole}, {0, shallow.exit.hole}};
    outside.bite(1, {0}, Side::inner, Side::outer, outside.next_pass());
    const Join join = outside.judge();
    EXPECT_EQ(committed(join), "partial-thickness stitch");
    EXPECT_EQ(lapses(join)[4].value, 1);
    EXPECT_EQ(join.stitches.size(), 8u);
    EXPECT_EQ(committed(join, {.partial_bites = 1}), "");
}

TEST(Lapses, UnequalSpacing) {
    Operation operation;
    operation.stitches(1);
    operation.stitch({22}, {22});
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "unequal spacing");
    EXPECT_NEAR(lapses(join)[5].value, 23.0 / 45, 0.01);
    EXPECT_EQ(committed(join, {.least_spacing = 0.5, .most_spacing = 1.5, .spacing_variation = 0.25}), "");
}

// The wall about a stitch is drawn out along the ring; or it gave way to the edge.
TEST(Lapses, Tear) {
    Operation drawn;
    drawn.stitches();
    drawn.move([](int, const Vec3& p) { return Vec3(p.x(), 1.8 * p.y(), 1.8 * p.z()); });
    EXPECT_EQ(committed(drawn.judge()), "tear");
    EXPECT_NEAR(lapses(drawn.judge())[6].value, 1.8 * 2 * hole / diameter, 1e-9);

    Operation torn;
    torn.stitches();
    torn.bites[1][1].torn = true;
    EXPECT_EQ(committed(torn.judge()), "tear");
    EXPECT_EQ(lapses(torn.judge())[6].value, 1);
}

// The edges are pressed together along the axis; or the loop is too short for what it holds.
TEST(Lapses, Strangulation) {
    Operation pressed;
    pressed.stitches();
    pressed.move([](int, const Vec3& p) { return Vec3(0.65 * p.x(), p.y(), p.z()); });
    EXPECT_EQ(committed(pressed.judge()), "strangulation");
    EXPECT_NEAR(lapses(pressed.judge())[7].value, 0.35, 1e-9);
    EXPECT_EQ(committed(pressed.judge(), {.edge_strain = 0.4, .least_loop = 0.7}), "");

    const LapseLimits loop_alone{.edge_strain = 0.4};
    EXPECT_EQ(committed(pressed.judge(), loop_alone), "strangulation");
    EXPECT_NEAR(lapses(pressed.judge(), loop_alone)[7].value, (1 + 0.65 * 2) / 3, 0.01);
}

TEST(Lapses, ThreadInLumen) {
    Operation operation;
    operation.stitches();
    auto& way = operation.led[3];  // a slack loop half a millimetre high over the join
    const Vec3 in = -operation.outwards(45.0 * 3), over = 1.5 * mm * operation.outwards(45.0 * 3) + 0.5 * mm * in;
    way.insert(way.begin() + 2, {{0, -1, over - 0.5 * mm * Vec3::UnitX()}, {0, -1, over + 0.5 * mm * Vec3::UnitX()}});
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "thread in lumen");
    EXPECT_NEAR(join.deepest_thread, 0.5 * mm, 0.02 * mm);
    const double slanted = std::sqrt(0.5) * mm * (0.5 - 0.085) / 0.5;
    EXPECT_NEAR(join.thread_in_lumen, 1 * mm + 2 * slanted, 0.1 * mm);
    EXPECT_EQ(committed(join, {.depth_diameters = 7}), "");
}

// One end is in the other by six tenths of a millimetre, as slender as that takes; the threads lie along both.
TEST(Lapses, Overlap) {
    Operation operation;
    operation.stitches();
    for (int k = 0; k < 8; ++k) {
        auto& way = operation.led[static_cast<std::size_t>(k)];
        const Vec3 out = operation.outwards(45.0 * k);
        way.insert(way.begin() + 2, {{0, -1, 1.48 * mm * out - 0.63 * mm * Vec3::UnitX()},
                                     {0, -1, 1.08 * mm * out - 0.62 * mm * Vec3::UnitX()}});
    }
    operation.move(
        [](int vessel, const Vec3& p) { return vessel == 0 ? p : Vec3(p.x() - 0.6 * mm, 0.73 * p.y(), 0.73 * p.z()); });
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "overlap");
    EXPECT_NEAR(lapses(join)[9].value, 0.6 * mm / join.wall,
                0.01);  // next to holes, which keep their width, skin is not quite where the wall is
    EXPECT_NEAR(join.lumen_ratio, 0.73 * 0.73, 1e-6);
    EXPECT_EQ(committed(join, {.overlap_walls = 1.5}), "");
}

// All ten have names and numbers when nothing was sewn at all, or nothing but one stitch.
TEST(Lapses, NeedNoStitch) {
    Operation none;
    none.move([](int vessel, const Vec3& p) { return Vec3(p + vessel * 1 * mm * Vec3::UnitX()); });
    EXPECT_EQ(committed(none.judge()), "disruption of suture line");
    Operation one;
    one.stitch({0}, {0});
    for (const Lapse& lapse : lapses(one.judge())) EXPECT_TRUE(std::isfinite(lapse.value)) << lapse.name;
    EXPECT_EQ(committed(one.judge()), "");
}

}  // namespace
