// Two cut ends that give way, a needle through both, a thread through their four skins.
#include <gtest/gtest.h>

#include "sim/geometry/closest_points.hpp"
#include "tests/scenarios/world/scene.hpp"

namespace sewing {

using namespace scene;
using sim::geometry::Arc;

constexpr double tick = 1e-3;

// The needle's circle stands upright over the gap, so that driven round it the needle meets both ends; its holder is
// turned about the circle's axis, as a wrist turns. A second one waits aside. Walls so soft to puncture that nobody
// need back them.
struct Gap : Scene {
    Vec3 centre = {0, 0, 4.79 * mm};

    Gap(const char* model, int links, bool with_spare) {
        def.needle_code = "BV-1";
        def.needle = {.centre = centre, .radius = 3.95 * mm, .angle = 2.356, .wire = 0.1 * mm};
        const auto tail = sim::geometry::portable_sin_cos(-3.4034);  // 195 degrees before the lowest point
        def.needle.to_tail = {tail.sin, 0, -tail.cos};
        def.needle.onwards = {tail.cos, 0, tail.sin};
        for (const double side : {-1.0, 1.0}) {
            auto end = end_at(1.5 * side * mm, -4 * side * mm);
            end.name = side < 0 ? "left" : "right";
            end.young_modulus = 0.3e6;
            end.puncture_force = 0.008;
            def.vessels.push_back(end);
        }
        def.thread.model = model;
        def.thread.length = 40 * mm;
        def.thread.links = links;
        def.thread.shortest_link = def.thread.diameter;
        const Vec3 behind = def.needle.tail() - 0.7 * mm * def.needle.tangent(0);
        def.thread.start = {def.needle.tail(), behind, behind + Vec3(-1 * mm, 3 * mm, 0),
                            behind + Vec3(-40 * mm, 4 * mm, 0)};
        add("right", Kind::needle_holder, {across_y(def.needle, 1 * mm, 1), 0});
        add("left", Kind::forceps, {{{0, 40 * mm, 40 * mm}, Quat::Identity()}, 0.6});
        if (with_spare) lay_first_aside();
    }

    // What is sewn with is then a spare.
    void lay_first_aside() {
        const Vec3 aside(0, 100 * mm, 0);
        def.spares = {{def.needle, def.thread.start}};
        def.needle.centre += aside;
        for (Vec3& corner : def.thread.start) corner += aside;
    }

    // Jaws across the wire `along` from its tail, whose tool points along y or against it.
    static instruments::Pose across_y(const Arc& needle, double along, double way) {
        return across(needle.at(along), needle.tangent(along), way * Vec3::UnitY());
    }

    void turn(ToolInput& tool, double degrees) {
        const auto half = sim::geometry::portable_sin_cos(-degrees / 360 * 3.14159265358979);
        const Quat by(half.cos, 0, half.sin, 0);
        tool.pose = {centre + by * (tool.pose.position - centre), (by * tool.pose.rotation).normalized()};
    }
};

struct Case {
    const char *name, *model;
    int links;
    bool with_spare;
};

void PrintTo(const Case& of, std::ostream* out) {
    *out << of.name;
}  // by default it would be bytes, with addresses among them

class SewingTest : public testing::TestWithParam<Case> {};

TEST_P(SewingTest, ThreadFollowsTheNeedleThroughFourSkins) {
    Gap scene(GetParam().model, GetParam().links, GetParam().with_spare);
    World world = scene.world();
    const auto length = [&] {
        double sum = 0;
        for (const auto& piece : world.curves())
            for (std::size_t k = 0; k + 1 < piece.size(); ++k) sum += (piece[k + 1] - piece[k]).norm();
        return sum;
    };
    const double at_first = length();
    ToolInput &right = scene.tools[0], &left = scene.tools[1];
    const auto go = [&](int ticks, const auto& move) {
        for (int t = 0; t < ticks; ++t) move(), world.tick(scene.tools);
    };
    go(5, [] {});
    go(1300, [&] { scene.turn(right, 0.1); });  // 100 degrees a second: the tip moves at 7 mm/s
    left.pose = Gap::across_y(world.needle(), world.needle().length() - 0.6 * mm, -1);
    left.pose.position.y() += 15 * mm;
    go(300, [] {});  // a hand that leaps: the tool comes after it
    go(750, [&] { left.pose.position.y() -= 0.02 * mm; });
    go(200, [] {});
    left.jaw = 0;
    go(50, [] {});
    right.jaw = 0.6;
    go(50, [] {});
    go(600, [&] { right.pose.position.y() -= 0.02 * mm; });
    go(1300, [&] { scene.turn(left, 0.1); });
    const Vec3 away = Vec3(0.5, 0, 1).normalized();
    go(800, [&] { left.pose.position += 15 * mm * tick * away; });
    EXPECT_EQ(world.measures().pass_throughs, 0u);
    for (const auto& vessel : world.vessels()) {
        SCOPED_TRACE(vessel.name);
        ASSERT_EQ(vessel.bites.bites().size(), 1u);
        const tissue::Bite& bite = vessel.bites.bites()[0];
        EXPECT_EQ(bite.state, tissue::BiteState::open);
        EXPECT_FALSE(bite.partial() || bite.both_walls || bite.torn || bite.on_needle);
        for (const tissue::BiteEnd* end : {&bite.entry, &bite.exit}) {  // thread is in each hole
            double nearest = 1e300;
            const Vec3 hole = vessel.skin.centre(end->hole);
            for (const auto& piece : world.curves())
                for (std::size_t k = 0; k + 1 < piece.size(); ++k)
                    nearest = std::min(
                        nearest,
                        std::sqrt(sim::geometry::closest_points(piece[k], piece[k + 1], hole, hole).distance_squared));
            EXPECT_LT(nearest, 0.15 * mm);  // its radius
        }
        double farthest = 0;  // the walls are where they were, but for what little the thread still draws
        for (std::size_t n = 0; n < vessel.tissue.nodes().size(); ++n)
            farthest = std::max(farthest, (vessel.tissue.nodes()[n] - vessel.tissue.rest().nodes[n]).norm());
        EXPECT_LT(farthest, 1 * mm);
    }
    EXPECT_NEAR(length(), at_first, 1e-3 * at_first);
    EXPECT_GT((world.needle().tail() - world.vessels()[1].skin.centre(0)).norm(), 8 * mm) << "the needle is on its way";
}

// Walls feel one needle at a time. One that is taken while another is in a wall waits until that is out, not until it
// is taken again.
TEST(Sewing, AnotherNeedleIsFeltOnceTheFirstIsOut) {
    Gap scene("ftl", 130, true);
    std::swap(scene.def.needle, scene.def.spares[0].needle);
    std::swap(scene.def.thread.start, scene.def.spares[0].start);
    ToolInput &right = scene.tools[0], &left = scene.tools[1];
    left = {Gap::across_y(scene.def.spares[0].needle, 5 * mm, 1), 0.6};
    World world = scene.world();
    const auto go = [&](int ticks, double degrees) {
        for (int t = 0; t < ticks; ++t) scene.turn(right, degrees), world.tick(scene.tools);
    };
    const auto in_use = [&] { return &world.needle_in_use() - world.needles().data(); };
    go(5, 0);
    go(500, 0.1);
    ASSERT_GT(world.vessels()[0].bites.holes_on_needle(), 0);
    left.jaw = 0;
    go(50, 0);
    EXPECT_EQ(world.needles()[1].holder.tool, 1);
    EXPECT_EQ(in_use(), 0);
    go(500, -0.1);
    ASSERT_EQ(world.vessels()[0].bites.holes_on_needle(), 0);
    EXPECT_EQ(in_use(), 1);
}

// What it took to pierce a wall is told: its puncture force, and what one more step of the tip adds to that.
TEST(Sewing, TellsWithWhatForceASkinWasPierced) {
    Gap scene("ftl", 130, false);
    World world = scene.world();
    for (int t = 0; t < 500 && world.vessels()[0].bites.bites().empty(); ++t)
        scene.turn(scene.tools[0], t < 5 ? 0 : 0.1), world.tick(scene.tools);
    ASSERT_EQ(world.events().size(), 2u);
    EXPECT_EQ(world.events()[0].kind, scenarios::world::EventKind::needle_grasp);
    EXPECT_EQ(world.events()[1].kind, scenarios::world::EventKind::pierced);
    EXPECT_EQ(world.events()[1].what, "left");
    EXPECT_NEAR(world.events()[1].value, 0.008, 0.0016);
}

INSTANTIATE_TEST_SUITE_P(Models, SewingTest,
                         testing::Values(Case{"ftl", "ftl", 130, false}, Case{"elastic", "elastic", 130, false},
                                         Case{"ftl_few_links_and_a_spare", "ftl", 15, true},
                                         Case{"elastic_few_links_and_a_spare", "elastic", 15, true}),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace sewing
