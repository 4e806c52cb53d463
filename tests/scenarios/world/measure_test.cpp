// What a session is scored by: paths, pulls and moments against a way that is known, what events say, and the sizes of
// what a drill leaves out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "scenarios/world/judge.hpp"
#include "tests/scenarios/world/scene.hpp"
#include "tissue/join.hpp"

namespace measuring {

using namespace scene;
using scenarios::world::Event;
using scenarios::world::EventKind;
using scenarios::world::Measures;
using scenarios::world::VesselDef;
using scenarios::world::WorldDef;

constexpr double pi = std::numbers::pi;

std::vector<Event> told(const World& world, EventKind kind) {
    std::vector<Event> found;
    std::copy_if(world.events().begin(), world.events().end(), std::back_inserter(found),
                 [&](const Event& event) { return event.kind == kind; });
    return found;
}

// As at the end of a session.
Measures judged_sewing(const World& world) {
    return scenarios::world::judge(world);
}
Measures judged_knot(World& world) {
    world.name_knot_now();
    return scenarios::world::judge(world);
}

// Two instruments above a straight thread of 30 mm along x, their jaws across it 3 mm from its ends.
struct Pair : Scene {
    Pair(Kind left, Kind right, const char* model) {
        add("left", left, {from_above(-12 * mm), 1});
        add("right", right, {from_above(12 * mm), 1});
        def.thread.model = model;
        lay({Vec3(-15 * mm, 0, 0), Vec3(15 * mm, 0, 0)}, 100);
    }
};

struct Play {
    Pair scene;
    World world;

    explicit Play(const Pair& of) : scene(of), world(scene.world()) {}
    void tick(int times = 1) { scene.play(world, times); }
    void close() {
        for (int t = 1; t <= 100; ++t) {
            for (auto& tool : scene.tools) tool.jaw = 1 - 0.01 * t;
            tick();
        }
        for (const auto& tool : world.tools()) ASSERT_EQ(tool.grasps.size(), 1u);
    }
    void move(std::size_t tool, const Vec3& by, int ticks) {
        for (int t = 0; t < ticks; ++t) scene.tools[tool].pose.position += by / ticks, tick();
    }
};

// Ten millimetres there and five back are fifteen, whatever the hand does that the tool does not: lost by its tracker,
// or held back by a taut thread.
TEST(Measures, APathIsWhatTheToolWent) {
    Play play(Pair(Kind::needle_holder, Kind::needle_holder, "ftl"));
    play.move(1, Vec3(0, 10 * mm, 0), 200);
    play.move(1, Vec3(3 * mm, 0, 4 * mm), 100);
    EXPECT_NEAR(play.world.measures().path_mm[1], 15, 1e-9);
    EXPECT_EQ(play.world.measures().path_mm[0], 0);
    play.scene.tools[0].pose.position.x() = std::numeric_limits<double>::quiet_NaN();
    play.tick(10);
    EXPECT_EQ(play.world.measures().path_mm[0], 0);

    Play taut(Pair(Kind::needle_holder, Kind::needle_holder, "ftl"));
    taut.close();
    const double before = taut.world.measures().path_mm[1];
    double went = 0;
    for (int t = 0; t < 200; ++t) {
        const Vec3 from = taut.world.tools()[1].now.pose.position;
        taut.move(1, Vec3(25e-6, 0, 0), 1);
        went += (taut.world.tools()[1].now.pose.position - from).norm() / mm;
    }
    EXPECT_NEAR(taut.world.measures().path_mm[1] - before, went, 1e-9);
    EXPECT_LT(went, 1) << "the hand went five";
}

// Between forceps, which hold one newton, and a needle holder, which holds four, no thread is pulled with more than
// one.
TEST(Measures, APullIsNoMoreThanTheWeakerGripHolds) {
    for (const bool turned : {false, true}) {
        Play play(turned ? Pair(Kind::needle_holder, Kind::forceps, "ftl")
                         : Pair(Kind::forceps, Kind::needle_holder, "ftl"));
        play.close();
        double most = 0;
        for (int t = 0; t < 250; ++t) {
            play.move(1, Vec3(20e-6, 0, 0), 1);
            most = std::max(most, play.world.tension_now());
        }
        EXPECT_LE(most, 1);
        EXPECT_GT(most, 0.98);
        EXPECT_EQ(play.world.measures().tension_max_N.value, most);
    }
}

// What the jaws of each kind hold, in newtons: a strand that is drawn harder runs out between them.
TEST(Measures, AStrandSlipsOutAtTheGripOfItsJaws) {
    for (const auto& [kind, grip] : {std::pair(Kind::forceps, 1.0), {Kind::needle_holder, 4.0}}) {
        Pair scene(kind, kind, "elastic");
        scene.def.thread.break_force = 8;
        Play play(scene);
        play.close();
        const auto tension = [&] { return play.world.thread_state().tension()[50]; };  // midway
        double before = 0;
        for (int t = 0; t < 1000 && told(play.world, EventKind::slip).empty(); ++t) {
            before = tension();
            play.move(1, Vec3(15e-6, 0, 0), 1);
        }
        ASSERT_FALSE(told(play.world, EventKind::slip).empty());
        EXPECT_NEAR(tension(), grip, 0.02 * grip);
        EXPECT_LT(before, grip);
        EXPECT_EQ(told(play.world, EventKind::slip)[0].value, grip);
        for (int t = 0; t < 100; ++t) play.move(1, Vec3(15e-6, 0, 0), 1);
        EXPECT_NEAR(tension(), grip, 0.03 * grip) << "and no harder after that";
    }
}

// A resident is led to the moment of the largest pull, not to the first or the last.
TEST(Measures, MomentsAreThoseOfTheMost) {
    Play play(Pair(Kind::needle_holder, Kind::needle_holder, "ftl"));
    play.close();
    double pull = 0, pull_s = 0, lag = 0, lag_s = 0;
    const auto look = [&](double by) {
        play.move(1, Vec3(by, 0, 0), 1);
        const auto& tool = play.world.tools()[1];
        if (play.world.tension_now() > pull) pull = play.world.tension_now(), pull_s = play.world.time_s();
        if (tool.lag() / mm > lag) lag = tool.lag() / mm, lag_s = play.world.time_s();
    };
    for (int t = 0; t < 60; ++t) look(15e-6);
    for (int t = 0; t < 60; ++t) look(-15e-6);
    for (int t = 0; t < 30; ++t) look(15e-6);
    const Measures& measures = play.world.measures();
    EXPECT_GT(pull, 0);
    EXPECT_EQ(measures.tension_max_N.value, pull);
    EXPECT_EQ(measures.tension_max_N.at_s, pull_s);
    EXPECT_NEAR(measures.lag_max_mm[1].value, lag, 1e-12);
    EXPECT_EQ(measures.lag_max_mm[1].at_s, lag_s);
    EXPECT_LT(lag_s, 0.17);
    EXPECT_GT(lag_s, 0.13);
    EXPECT_NEAR(measures.duration_s, 0.25, 1e-9);
    EXPECT_EQ(measures.grasps, (std::vector<int>{1, 1}));
    EXPECT_FALSE(measures.broke_s);
    EXPECT_FALSE(measures.needle_deg);
}

// The thread's own figures come out of every tick: the worst of them, and the sum of all steps.
TEST(Measures, TheWorstIsThatOfAllTicks) {
    Play play(Pair(Kind::needle_holder, Kind::needle_holder, "ftl"));
    play.tick(5);
    EXPECT_EQ(play.world.worst().contacts, 0);
    EXPECT_EQ(play.world.worst().separation, 1e300);
    EXPECT_LT(play.world.worst().stretch, 1e-6);
    EXPECT_LT(play.world.worst().step_over_bound, 1e-6);
    const std::uint64_t at_rest = play.world.substeps();
    play.tick(5);
    EXPECT_EQ(play.world.substeps(), at_rest);
    play.close();
    play.move(1, Vec3(-2 * mm, 1 * mm, 0), 100);
    EXPECT_GE(play.world.substeps(), at_rest + 100);
    EXPECT_GT(play.world.worst().contacts, 0);
    EXPECT_GT(play.world.worst().step_over_bound, 0.05);
    EXPECT_LE(play.world.worst().step_over_bound, 1);
    EXPECT_EQ(play.world.measures().pass_throughs, 0u);
}

// Where along the thread, by how much, by whom: each event's words and value.
TEST(Events, SayWhoWhereAndHowMuch) {
    Play play(Pair(Kind::needle_holder, Kind::needle_holder, "ftl"));
    play.close();
    const auto grasps = told(play.world, EventKind::grasp);
    ASSERT_EQ(grasps.size(), 2u);
    for (const auto& [number, name, place] : {std::tuple(0u, "left", 3.0), {1u, "right", 27.0}}) {
        EXPECT_EQ(grasps[number].what, name);
        EXPECT_NEAR(grasps[number].value, place, 0.3) << "mm, to a link";
        EXPECT_NEAR(grasps[number].t_s, 0.076, 0.002) << "when its jaws are a quarter open";
    }
    play.scene.tools[0].jaw = std::numeric_limits<double>::quiet_NaN();
    play.tick();
    ASSERT_EQ(told(play.world, EventKind::input_dropped).size(), 1u);
    EXPECT_EQ(told(play.world, EventKind::input_dropped)[0].what, "left");
    EXPECT_EQ(told(play.world, EventKind::input_dropped)[0].value, 0);
    play.scene.tools[0].jaw = 0;
    EXPECT_TRUE(told(play.world, EventKind::release).empty());
    play.scene.tools[1].jaw = 1;
    play.tick(2);
    ASSERT_EQ(told(play.world, EventKind::release).size(), 1u);
    EXPECT_EQ(told(play.world, EventKind::release)[0].what, "right");
    EXPECT_TRUE(told(play.world, EventKind::pass_through).empty());
    EXPECT_TRUE(told(play.world, EventKind::held_up).empty());
}

// Jaws are shut below a quarter of their opening and let go above four tenths, so that a trembling hand does not
// chatter.
TEST(Grasps, BeginAtAQuarterAndEndAtFourTenths) {
    Play play(Pair(Kind::needle_holder, Kind::needle_holder, "ftl"));
    for (const auto& [jaw, holds] :
         {std::pair(0.255, 0u), {0.245, 1u}, {0.395, 1u}, {0.405, 0u}, {0.255, 0u}, {0.245, 1u}}) {
        play.scene.tools[0].jaw = jaw;
        play.tick(3);
        EXPECT_EQ(play.world.tools()[0].grasps.size(), holds) << jaw;
    }
    EXPECT_EQ(play.world.measures().grasps[0], 2);
}

// An overhand whose loop goes round a vessel of 4 mm: from surface to surface, so that a thicker thread
// is nearer by half of what it is thicker.
TEST(Measures, AKnotIsOffTheVesselFromSurfaceToSurface) {
    const auto off = [](double diameter) {
        std::vector<Vec3> path{Vec3(6, 0, 6)}, back;
        const auto strand = [](double side) {
            std::vector<Vec3> points;
            for (int i = 0; i <= 36; ++i) {
                const double turn = -pi / 2 - side * pi * i / 12;
                points.push_back(Vec3(2 * side * (1 - i / 18.0), std::cos(turn), std::sin(turn)));
            }
            return points;
        };
        const std::vector<Vec3> one = strand(-1), other = strand(1);
        path.insert(path.end(), one.rbegin(), one.rend());
        for (const Vec3& foot : {Vec3(-2.5, 0, -3), Vec3(-2.5, 0, -9), Vec3(2.5, 0, -9), Vec3(2.5, 0, -3)})
            path.push_back(foot);
        path.insert(path.end(), other.begin(), other.end());
        path.push_back(Vec3(-6, 0, 6));
        WorldDef def;
        def.thread.diameter = diameter;
        def.thread.length = 0;
        for (Vec3& p : path) p *= mm;
        for (std::size_t i = 1; i < path.size(); ++i) def.thread.length += (path[i] - path[i - 1]).norm();
        def.thread.start = path;
        VesselDef vessel;
        vessel.axis = Vec3::UnitY();
        vessel.centre = Vec3(0, 0, -6 * mm);
        def.vessels = {vessel};
        World world(def, {}, {});
        const Measures measures = judged_knot(world);
        EXPECT_EQ(measures.knot.factors.size(), 1u);
        EXPECT_EQ(measures.around, std::vector<std::string>{"vessel"});
        return measures.off_tissue_mm;
    };
    EXPECT_NEAR(off(0.085 * mm), std::hypot(2.5, 3) - 2 - 0.085 / 2, 0.03) << "from where its loop begins";
    EXPECT_NEAR(off(0.085 * mm) - off(0.185 * mm), 0.05, 1e-9);
}

// In and out by the outer side, 1 and 2.5 mm from the cut: as large as its farther end says, whichever was first.
TEST(Measures, ABiteIsAsLargeAsItsFartherEnd) {
    for (const bool turned : {false, true}) {
        VesselDef end;
        end.length = 6 * mm;
        end.centre = {-3 * mm, 0, 0};
        end.end_held = false;
        end.is_soft = true;
        // Its outer side is of sixteen faces; a straight needle goes from the middle of one to that of the next but
        // one.
        const double radius = 2 * std::sqrt(pi / 8 / std::sin(pi / 8)) * std::cos(pi / 16);
        const auto on = [&](double angle, double from_cut) {
            return Vec3(Vec3(-from_cut, radius * std::cos(angle), radius * std::sin(angle)) * mm);
        };
        const Vec3 a = on(3.5 * pi / 8, 1), b = on(5.5 * pi / 8, 2.5), way = 0.2 * (b - a);
        end.bitten = {turned ? std::array<Vec3, 2>{b + way, a - way} : std::array<Vec3, 2>{a - way, b + way}};
        WorldDef def;
        def.thread.start = {Vec3(50 * mm, 0, 0), Vec3(80 * mm, 0, 0)};
        def.thread.length = 30 * mm;
        def.vessels = {end};
        World world(def, {}, {});
        const Measures measures = judged_sewing(world);
        ASSERT_EQ(measures.bites.size(), 1u);
        const auto& bite = measures.bites[0];
        EXPECT_TRUE(bite.partial);
        EXPECT_EQ(bite.from, "outer");
        EXPECT_EQ(bite.to, "outer");
        EXPECT_NEAR(bite.size_mm, 2.5, 0.02);
        EXPECT_TRUE(bite.is_empty) << "no thread is in it";
    }
}

// Two ends that meet at x = 0, a bite in each, and a thread through both whose tails two needle holders draw up.
struct Stitch : Scene {
    Stitch(double left, double right) {
        for (const double side : {-1.0, 1.0}) {
            auto end = end_at(0, -6 * side * mm);
            end.name = side < 0 ? "left" : "right";
            const double x = side < 0 ? -left : right;
            end.bitten = {{Vec3(x, 0, 2.5 * mm), Vec3(x, 0, 1 * mm)}};
            def.vessels.push_back(end);
            const Vec3 at(2 * side * mm, 0, (side < 0 ? 6 : 9) * mm);
            add(end.name, Kind::needle_holder, {across(at, Vec3::UnitZ(), -side * Vec3::UnitY()), 0.6});
        }
        def.needle.wire = 0.1 * mm;
        def.thread.model = "elastic";
        std::vector<Vec3> path{{-2, 0, 13},
                               {-2, 0, 4},
                               {-left / mm, 0, 2.3},
                               {-left / mm, 0, 1.2},
                               {right / mm, 0, 1.2},
                               {right / mm, 0, 2.3},
                               {2, 0, 4},
                               {2, 0, 13}};
        for (Vec3& p : path) p *= mm;
        lay(path, 100);
        def.thread.shortest_link = def.thread.diameter;
    }
};

tissue::SewnVessel sewn(const scenarios::world::SoftVessel& vessel) {
    return {vessel.tissue.rest(), vessel.skin, vessel.bites.bites(), vessel.bites.def().axis};
}

// The longest hole, over the three radii of wire that it is made as [1].
double longest_hole(const World& world) {
    const auto threads = world.curves();
    const auto join = tissue::judge(sewn(world.vessels()[0]), sewn(world.vessels()[1]), threads, 0.085 * mm);
    double longest = 0;
    for (const auto& bite : join.bites) longest = std::max(longest, bite.hole);
    return longest / (3 * 0.1 * mm);
}

// Drawn on until one bite tears out: a hole that is less than twice as long as it was made is no tear, one that is
// longer is; and once the only bite of one end is torn there is no join to judge, though the thread still lies in it.
TEST(Measures, AHoleTwiceAsLongIsATearAndATornOneHoldsNothing) {
    Stitch stitch(0.5 * mm, 1.5 * mm);
    World world(stitch.def, {}, stitch.tools);
    for (ToolInput& tool : stitch.tools) tool.jaw = 0;
    for (int t = 0; t < 50; ++t) world.tick(stitch.tools);
    for (const auto& tool : world.tools()) ASSERT_EQ(tool.grasps.size(), 1u);
    int less = 0, more = 0;
    for (int t = 0; t < 300 && told(world, EventKind::torn).empty(); ++t) {
        for (ToolInput& tool : stitch.tools) tool.pose.position.z() += 30e-6;
        world.tick(stitch.tools);
        if (t % 8 != 0 || !told(world, EventKind::torn).empty()) continue;
        const double hole = longest_hole(world);
        const Measures measures = judged_sewing(world);
        ASSERT_EQ(measures.join.lapses.size(), 10u) << t;
        EXPECT_EQ(measures.join.lapses[6].name, "tear");
        EXPECT_EQ(measures.join.lapses[6].committed, hole > 2) << hole;
        less += hole > 1.4 && hole<1.95, more += hole> 2.05 && hole < 2.6;
    }
    EXPECT_GT(less, 0);
    EXPECT_GT(more, 0);
    ASSERT_EQ(told(world, EventKind::torn).size(), 1u);
    const auto& left = world.vessels()[0];
    const double bears = 1.35 * (0.5 / 0.4) * (0.5 / 2);
    EXPECT_EQ(told(world, EventKind::torn)[0].what, "left");
    EXPECT_NEAR(told(world, EventKind::torn)[0].value, bears, 0.15 * bears);
    ASSERT_GE(tissue::thread_in(left.bites.bites()[0], left.skin, world.curves(), 0.085 * mm), 0);
    const Measures measures = judged_sewing(world);
    EXPECT_TRUE(measures.join.lapses.empty());
    ASSERT_EQ(measures.bites.size(), 2u);
    EXPECT_TRUE(measures.bites[0].torn);
    EXPECT_FALSE(measures.bites[0].is_empty);
    EXPECT_FALSE(measures.bites[1].torn);
}

}  // namespace measuring
