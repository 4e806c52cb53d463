#include <gtest/gtest.h>

#include <random>

#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/motion.hpp"
#include "scenarios/session/scene.hpp"

namespace {

using instruments::ToolInput;
using scenarios::world::World;
using sim::geometry::Quat;
using sim::geometry::Vec3;

// A hand that knows nothing: every 0.15 s it wants to be somewhere else near the vessel, turned anyhow, open or shut.
struct WildHand {
    std::mt19937& random;
    double speed;  // [m/s]
    ToolInput now{}, goal{};

    double number() { return 2.0 * random() / 4294967296.0 - 1; }
    void choose() {
        goal.pose.position = Vec3(10e-3 * number(), 10e-3 * number(), 6e-3 + 8e-3 * number());
        goal.pose.rotation = (Quat(1, 0.5 * number(), 0.5 * number(), 0.5 * number()) * now.pose.rotation).normalized();
        goal.jaw = number() > 0 ? 1 : 0;
    }
    void tick() {
        const Vec3 way = goal.pose.position - now.pose.position;  // none: all of it at once
        now.pose = instruments::between(now.pose, goal.pose, std::min(1.0, speed * 1e-3 / way.norm()));
        now.jaw += std::clamp(goal.jaw - now.jaw, -0.01, 0.01);
    }
};

// No motion is so wild that thread passes through thread, steel or vessel, or grows: a trainee will find the one that
// does. 0.1 m/s is a quick instrument, 1 m/s a quick open hand.
TEST(Chaos, WildHandsNeverBreakTheThread) {
    const auto drill = scenarios::drill::load_drill(CARREL_SOURCE "/scenarios/drills/square-knot.json");
    const auto meshes = scenarios::session::vessel_meshes(drill.world);
    const std::vector<std::string> names{"left", "right"};
    const auto motion = scenarios::drill::load_motion(drill.motion, names);
    for (const double speed : {0.1, 1.0}) {
        SCOPED_TRACE(speed);
        std::mt19937 random(speed < 0.5 ? 1 : 2);
        std::vector<ToolInput> inputs(2);
        motion.at(0, inputs);
        World world = scenarios::session::make_world(drill.world, meshes, inputs);
        WildHand hands[] = {{random, speed, inputs[0]}, {random, speed, inputs[1]}};
        for (int tick = 0; tick < 1200; ++tick) {
            // First the long strand is grasped, as in the drill.
            if (tick < 200) {
                motion.at(2e-3 * tick, inputs);
                for (const std::size_t i : {0, 1}) hands[i].now = hands[i].goal = inputs[i];
            }
            for (const std::size_t i : {0, 1}) {
                if (tick >= 200 && tick % 150 == 50) hands[i].choose();
                hands[i].tick();
                inputs[i] = hands[i].now;
            }
            world.tick(inputs);
        }
        EXPECT_GT(world.worst().contacts, 20) << "nothing was touched";
        EXPECT_GT(world.measures().grasps[0] + world.measures().grasps[1], 0);
        EXPECT_EQ(world.measures().pass_throughs, 0u);
        EXPECT_LE(world.worst().stretch, 0.01);
        EXPECT_LE(world.worst().step_over_bound, 1 + 1e-12);  // rounding of a norm
    }
}

}  // namespace
