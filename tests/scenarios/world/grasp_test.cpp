#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/scenarios/world/scene.hpp"

namespace grasping {

using namespace scene;
using scenarios::world::EventKind;

struct Seeded {
    std::mt19937 random;
    double number(double from, double to) { return from + (to - from) * random() / 4294967296.0; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v(number(-1, 1), number(-1, 1), number(-1, 1));
            if (v.norm() > 0.1 && v.norm() <= 1) return v.normalized();
        }
    }
};

// Open jaws anywhere in space, and a straight thread of 30 mm that runs between them, across them within 60 degrees.
struct Anywhere : Scene {
    explicit Anywhere(Seeded& seeded) {
        const auto shape = instruments::shape_of(Kind::needle_holder);
        const auto jaw = instruments::parts_at(shape, {}, 0)[instruments::jaw_plus];
        const double share = seeded.number(0.3, 0.9);
        const Vec3 between(0, 0, (1 - share) * jaw.a.z() + share * jaw.b.z());
        const Vec3 across = Vec3(seeded.number(-0.5, 0.5), 1, seeded.number(-1, 1)).normalized();
        const Vec3 turn = seeded.direction() * seeded.number(0, 1);
        const ToolInput tool{{0.02 * seeded.direction(), Quat(1, turn.x(), turn.y(), turn.z()).normalized()}, 1};
        add("right", Kind::needle_holder, tool);
        const auto in_world = [&](const Vec3& p) -> Vec3 { return tool.pose.position + tool.pose.rotation * p; };
        lay({in_world(between - 15e-3 * across), in_world(between + 15e-3 * across)}, 60);
    }
};

// Of the links that the first tool holds, the one that is longest or shortest for its length.
double stretch_between(const World& world) {
    const auto& grasp = world.tools()[0].grasps[0];
    const double rest = world.def().thread.length / world.def().thread.links;
    double most = 0;
    for (int k = grasp.first; k + 1 < grasp.first + grasp.count(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        most = std::max(most, std::abs((world.thread()[i + 1] - world.thread()[i]).norm() / rest - 1));
    }
    return most;
}

TEST(Grasp, ClosingJawsHoldTheStrandBetweenThem) {
    for (unsigned seed = 1; seed <= 60; ++seed)
        for (const bool elastic : {false, true}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + (elastic ? ", elastic" : ""));
            Seeded seeded{std::mt19937(seed)};
            Anywhere scene(seeded);
            if (elastic) scene.def.thread.model = "elastic";
            World world = scene.world();
            for (int tick = 0; tick < 300; ++tick) {
                scene.tools[0].jaw = std::max(0.0, 1 - 0.005 * tick);
                scene.play(world);
            }
            ASSERT_EQ(world.tools()[0].grasps.size(), 1u);
            EXPECT_EQ(world.measures().pass_throughs, 0u);
            EXPECT_LT(stretch_between(world), 1e-3);
        }
}

// A hand snaps at a strand as it goes by, at 0.4 m/s: what the jaws take must go along with them from the first tick,
// or one jaw runs over the strand that it holds.
TEST(Grasp, JawsThatCloseAsTheyGoByTakeTheStrandAlong) {
    int taken = 0;
    for (unsigned seed = 1; seed <= 60; ++seed)
        for (const bool elastic : {false, true}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + (elastic ? ", elastic" : ""));
            Seeded seeded{std::mt19937(seed)};
            Anywhere scene(seeded);
            if (elastic) scene.def.thread.model = "elastic";
            const Vec3 way = 0.4e-3 * seeded.direction();  // [m] a tick
            constexpr int closing = 20, going_on = 20;     // [ticks]
            const Vec3 closed_at = scene.tools[0].pose.position;
            scene.tools[0].pose.position = closed_at - closing * way;
            World world = scene.world();
            for (int tick = 1; tick <= closing + going_on; ++tick) {
                scene.tools[0].pose.position = closed_at + (tick - closing) * way;
                scene.tools[0].jaw = std::max(0.0, 1 - 0.8 * tick / closing);
                scene.play(world);
            }
            EXPECT_EQ(world.measures().pass_throughs, 0u);
            if (world.tools()[0].grasps.empty()) continue;
            ++taken;
            EXPECT_LT(stretch_between(world), 1e-3);
        }
    EXPECT_GE(taken, 10) << "too few to tell";
}

// Two needle holders above a straight thread along x, their jaws across it near its ends.
struct TwoTools : Scene {
    TwoTools() {
        for (const double side : {-1.0, 1.0})
            add(side < 0 ? "left" : "right", Kind::needle_holder, {from_above(12 * side * mm), 1});
        lay({Vec3(-15 * mm, 0, 0), Vec3(15 * mm, 0, 0)}, 100);
    }
};

// Led into another tool it stays behind its hand, which is told once, and again when it had come free.
TEST(Tools, SayWhatHoldsThemUp) {
    TwoTools scene;
    World world = scene.world();
    const auto lead = [&](double to_mm) {
        for (int t = 0; t < 600; ++t) {
            const double left = 1e-3 * to_mm - scene.tools[0].pose.position.x();
            scene.tools[0].pose.position.x() += std::clamp(left, -50e-6, 50e-6);
            world.tick(scene.tools);
        }
    };
    const auto told = [&] {
        return std::count_if(world.events().begin(), world.events().end(),
                             [](const auto& event) { return event.kind == EventKind::held_up; });
    };
    lead(8);
    EXPECT_EQ(told(), 0);
    lead(20);
    ASSERT_EQ(told(), 1);
    EXPECT_EQ(world.events().back().what, "left by right");
    EXPECT_NEAR(world.events().back().value, 2e3 * world.tools()[0].shape.jaw_radius,
                0.06);  // a tick's way of the hand
    lead(0);
    lead(20);
    EXPECT_EQ(told(), 2);
}

// Held back by a taut thread it is told once as well, however long the hand goes on.
TEST(Tools, AreToldOnceThatTheThreadHoldsThem) {
    TwoTools scene;
    World world = scene.world();
    for (int t = 0; t < 400; ++t) {
        for (auto& tool : scene.tools) tool.jaw = std::max(0.0, tool.jaw - 4e-3);
        world.tick(scene.tools);
    }
    ASSERT_EQ(std::count_if(world.events().begin(), world.events().end(),
                            [](const auto& event) { return event.kind == EventKind::grasp; }),
              2);
    double behind = 0;
    for (int t = 0; t < 300; ++t) {
        scene.tools[1].pose.position.x() += 20e-6;
        world.tick(scene.tools);
        behind = std::max(behind, world.tools()[1].lag());
    }
    ASSERT_GT(behind, 4 * world.tools()[1].shape.jaw_radius);
    EXPECT_EQ(std::count_if(world.events().begin(), world.events().end(),
                            [](const auto& event) {
                                return event.kind == EventKind::held_up && event.what == "right by the thread";
                            }),
              1);
}

// Strands that cross between closing jaws lie on one another there: jaws that shut all the way would press them through
// each other.
TEST(Grasp, JawsStopOnStrandsThatCross) {
    for (const bool elastic : {false, true}) {
        TwoTools scene;
        scene.def.instruments.pop_back(), scene.tools.pop_back();
        scene.def.thread.model = elastic ? "elastic" : "ftl";
        scene.def.thread.length = 60e-3;
        scene.def.thread.links = 200;
        scene.def.thread.start = {Vec3(-20e-3, -0.4e-3, -3e-3), Vec3(-4e-3, -0.4e-3, 3e-3), Vec3(0, -0.4e-3, 4e-3),
                                  Vec3(0, 0.4e-3, -4e-3),       Vec3(-4e-3, 0.4e-3, -3e-3), Vec3(-20e-3, 0.4e-3, 3e-3)};
        World world = scene.world();
        for (int tick = 1; tick <= 500; ++tick) {
            scene.tools[0].jaw = std::max(0.0, 1 - 0.0025 * tick);
            scene.play(world);
        }
        const auto& tool = world.tools()[0];
        EXPECT_EQ(tool.grasps.size(), 2u);
        EXPECT_GT(tool.now.jaw, 0) << "as far as they are thick";
        EXPECT_LT(tool.now.jaw, 0.1);
        EXPECT_GE(world.worst().separation, 0.99);
        EXPECT_LE(world.worst().separation, 1.2) << "diameters: they touch";
        EXPECT_EQ(world.measures().pass_throughs, 0u);
    }
}

// A hand has pulled 10 mm past what the thread gives; the other lets go. The tool that waited must not leap after its
// hand and whip the thread, and must be there within the time that a hand's speed of 0.1 m/s takes.
TEST(Grasp, AToolThatWaitedComesAfterItsHandAtAHandsSpeed) {
    TwoTools scene;
    scene.def.thread.break_force = 2 * instruments::shape_of(Kind::needle_holder).grip_force;  // it must not part
    World world = scene.world();
    auto& right = scene.tools[1];
    const auto tick = [&] { world.tick(scene.tools); };
    for (int i = 1; i <= 100; ++i) {
        for (auto& tool : scene.tools) tool.jaw = 1 - 0.01 * i;
        tick();
    }
    ASSERT_EQ(world.tools()[0].grasps.size(), 1u);
    ASSERT_EQ(world.tools()[1].grasps.size(), 1u);
    for (int i = 0; i < 100; ++i) right.pose.position.x() += 0.1e-3, tick();
    const auto behind = [&] { return (right.pose.position - world.tools()[1].now.pose.position).norm(); };
    const double lag = behind();
    EXPECT_GT(lag, 9e-3);
    EXPECT_GT(world.tension_now(), 0);
    EXPECT_EQ(world.events().back().what, "right by the thread");
    scene.tools[0].jaw = 1;
    constexpr double a_tick = 0.1e-3;  // [m] of catching up
    double left = lag;
    for (int i = 0; i < 1.3 * lag / a_tick; ++i) {
        tick();
        EXPECT_LE(left - behind(), a_tick * (1 + 1e-9)) << i;  // rounding
        left = behind();
    }
    EXPECT_EQ(left, 0);
    EXPECT_EQ(world.measures().pass_throughs, 0u);
}

// A tool that comes up against the other goes no farther, however far its hand goes. It holds no thread: to score that
// as a pull on one would teach a fault nobody made.
TEST(Grasp, AToolThatHoldsNothingPullsNothing) {
    TwoTools scene;
    World world = scene.world();
    auto& right = scene.tools[1];
    for (int i = 0; i < 240; ++i) {
        right.pose.position.x() -= 0.1e-3;
        world.tick(scene.tools);
    }
    EXPECT_GT((world.tools()[1].now.pose.position - right.pose.position).norm(), 1e-3) << "nothing was in its way";
    EXPECT_EQ(world.measures().lag_max_mm[1].value, 0);
}

// An elastic thread has hardly any lag: what the jaws bear shows in the link outside them. Forceps that let a thread
// slide too soon drop it while a knot is laid, those that never do pull it until it breaks.
TEST(Grasp, AnElasticThreadSlidesAtTheGripForceAndHoldsBelow) {
    TwoTools scene;
    scene.def.instruments[1].kind = Kind::forceps;
    scene.def.thread.model = "elastic";
    World world = scene.world();
    auto& right = scene.tools[1];
    const auto tick = [&] { world.tick(scene.tools); };
    for (int i = 1; i <= 100; ++i) {
        for (auto& tool : scene.tools) tool.jaw = 1 - 0.01 * i;
        tick();
    }
    ASSERT_EQ(world.tools()[1].grasps.size(), 1u);
    const double grip = world.tools()[1].shape.grip_force, speed = 10e-6;     // [m] a tick
    const auto tension = [&] { return world.thread_state().tension()[50]; };  // midway
    const auto held = [&] { return world.tools()[1].grasps.at(0).first; };
    const int first = held();
    while (tension() < 0.95 * grip) right.pose.position.x() += speed, tick();
    for (int i = 0; i < 1000; ++i) tick();
    EXPECT_FALSE(world.tools()[1].slipping);
    EXPECT_EQ(held(), first);
    EXPECT_NEAR(tension(), 0.95 * grip, 0.02 * grip);

    for (int i = 0; i < 100; ++i)
        right.pose.position.x() += speed, tick();  // what is left to the grip, and until the first link is through
    for (int i = 0; i < 200; ++i) {
        right.pose.position.x() += speed;
        tick();
        EXPECT_NEAR(tension(), grip, 0.03 * grip) << i;
    }
    EXPECT_GT(held(), first) << "it must run through the jaws";
    EXPECT_EQ(world.measures().pass_throughs, 0u);
}

// A hand that goes on pulls an elastic thread until it breaks. One that feels it stops at its pull, gives way where the
// other pulls harder, and is where it would be when the pull is over.
TEST(Grasp, AToolThatPullsByFeelPullsNoHarderAndGivesWay) {
    TwoTools scene;
    scene.def.thread.model = "elastic";
    const double pull = scene.def.instruments[1].pull = 0.5;
    World world = scene.world();
    const auto tick = [&] { world.tick(scene.tools); };
    for (int i = 1; i <= 100; ++i) {
        for (auto& tool : scene.tools) tool.jaw = 1 - 0.01 * i;
        tick();
    }
    const auto tension = [&] { return world.thread_state().tension()[50]; };  // midway
    const auto lag = [&] { return world.tools()[1].lag(); };
    auto& right = scene.tools[1].pose.position;
    constexpr double speed = 10e-6, way = 8e-3;  // [m] a tick, [m]: breaks a thread of 30 mm twice over
    double most = 0;
    for (double gone = 0; gone < way; gone += speed) right.x() += speed, tick(), most = std::max(most, tension());
    EXPECT_NEAR(most, pull, 0.02 * pull);
    EXPECT_NEAR(tension(), pull, 0.02 * pull) << "it goes on pulling";
    EXPECT_GT(lag(), way / 2);

    // The other, which feels nothing, draws it along.
    const double before = world.tools()[1].now.pose.position.x();
    for (int i = 0; i < 300; ++i) scene.tools[0].pose.position.x() -= speed, tick(), most = std::max(most, tension());
    EXPECT_NEAR(before - world.tools()[1].now.pose.position.x(), 300 * speed, 10 * speed);
    EXPECT_LT(most, 1.05 * pull);

    for (double gone = 0; gone < 2 * way; gone += speed) right.x() -= speed, tick();
    EXPECT_EQ(lag(), 0);
    EXPECT_EQ(world.measures().pass_throughs, 0u);
}

// Forceps close on the end of a fine thread that lies at rest along their jaws, 2 mm or 9 mm deep between them, in
// links shorter than jaws are wide. They hold all of it: nodes that they leave out are wedged in metal and pushed apart
// until the thread breaks. Nothing moves it, so no tension is right.
TEST(Grasp, JawsThatCloseOnAFineThreadAlongThemDoNotPullIt) {
    for (const double diameter : {0.025e-3, 0.085e-3})
        for (const double link : {0.1e-3, 0.05e-3})
            for (const double deep : {2e-3, 9e-3}) {
                SCOPED_TRACE(testing::Message() << diameter << " m thick, links of " << link << " m, " << deep << " m");
                scenarios::world::WorldDef def;
                def.instruments = {{"left", instruments::Kind::forceps}};
                def.thread.model = "elastic";
                def.thread.diameter = diameter;
                def.thread.length = 24e-3;
                def.thread.links = static_cast<int>(std::lround(def.thread.length / link));
                def.thread.start = {Vec3(0, 0, -deep), Vec3(0, 0, def.thread.length - deep)};
                ToolInput tool{{}, 0.6};
                World world(def, {}, {&tool, 1});
                double pulled = 0;
                for (int tick = 0; tick < 400; ++tick) {
                    tool.jaw = std::max(0.0, 0.6 - 0.002 * tick);
                    world.tick({&tool, 1});
                    for (const double tension : world.thread_state().tension())
                        pulled = std::max(pulled, std::abs(tension));
                }
                ASSERT_EQ(world.tools()[0].grasps.size(), 1u);
                EXPECT_GE(world.tools()[0].grasps[0].count() * link, deep);
                EXPECT_LT(pulled, 1e-3);
                EXPECT_LT(world.worst().stretch, 1e-3);
            }
}

}  // namespace grasping
