#include "instruments/tool_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <tuple>

#include "sim/geometry/closest_points.hpp"

using namespace instruments;

// A straight tube along x with 0.6 mm of wall, as two nested shells; [m], scaled.
static std::vector<Triangle> vessel(double scale = 1) {
    std::vector<Triangle> triangles;
    constexpr int around = 48;
    for (const double radius : {2.0e-3, 1.4e-3}) {
        const auto corner = [&](int i, double x) {
            const double angle = 2 * EIGEN_PI * i / around;
            return Vec3(scale * x, scale * radius * std::cos(angle), scale * radius * std::sin(angle));
        };
        for (int i = 0; i < around; ++i) {
            triangles.push_back({corner(i, -15e-3), corner(i + 1, -15e-3), corner(i + 1, 15e-3)});
            triangles.push_back({corner(i, -15e-3), corner(i + 1, 15e-3), corner(i, 15e-3)});
        }
    }
    return triangles;
}

static ToolShape scaled(ToolShape shape, double scale) {
    for (double* length : {&shape.shaft_radius, &shape.shaft_length, &shape.jaw_radius, &shape.jaw_length})
        *length *= scale;
    return shape;
}

// Tips down: +z of the tool is -z of the world.
static const Quat down(Eigen::AngleAxisd(EIGEN_PI, Vec3::UnitX()));

static double brute_gap(const std::array<Capsule, part_count>& parts, const std::vector<Triangle>& triangles) {
    double gap = 1e300;
    for (const Capsule& part : parts)
        for (const Triangle& triangle : triangles)
            gap = std::min(
                gap, std::sqrt(sim::geometry::closest_points(part.a, part.b, triangle).distance_squared) - part.radius);
    return gap;
}

// At 1 m/s a tick is 1 mm: the wall is thinner, and a test at the tick's ends alone finds the tool inside the lumen or
// beyond. Each speed must end touching the outside, and must be able to leave at once.
TEST(ToolWorld, AFastToolStopsAtAVesselWallAndCanLeave) {
    for (const Kind kind : {Kind::forceps, Kind::needle_holder, Kind::scissors, Kind::approximator})
        for (const double speed : {0.01, 0.1, 1.0, 50.0}) {
            SCOPED_TRACE(speed);
            ToolWorld world;
            world.add_surface(vessel());
            const int tool = world.add_tool(kind);
            const Vec3 start(1e-3, 0.1e-3, 5e-3);
            world.set_pose(tool, {{start, down}, 0});
            Advance last;
            for (double z = start.z(); z > -5e-3; z -= speed * 1e-3) {
                last = world.advance(tool, {{Vec3(start.x(), start.y(), z), down}, 0});
                ASSERT_GE(brute_gap(world.parts(tool), vessel()), world.skin(tool) / 4);
            }
            world.advance(tool, {{Vec3(start.x(), start.y(), -5e-3), down}, 0});
            EXPECT_TRUE(last.stopped || speed > 1);
            // Forceps are narrower than the lumen, so only the wall can have stopped them above the centre.
            EXPECT_GT(world.pose(tool).pose.position.z(), 1.9e-3);
            EXPECT_LE(brute_gap(world.parts(tool), vessel()), world.skin(tool) * 1.001);
            const ToolInput away{{world.pose(tool).pose.position + Vec3(0, 0, 1e-3), down}, 0};
            const Advance left = world.advance(tool, away);
            EXPECT_FALSE(left.stopped);
            EXPECT_EQ(left.reached.pose.position, away.pose.position);
        }
}

// Jaws are 0.4 mm thick: 2.5 of them fit into what a fast tool moves in one tick.
TEST(ToolWorld, AFastToolStopsAtAnotherToolsJaw) {
    for (const double speed : {0.01, 0.1, 1.0}) {
        SCOPED_TRACE(speed);
        ToolWorld world;
        const int moving = world.add_tool(Kind::forceps), still = world.add_tool(Kind::forceps);
        const Quat lying(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitY()));
        world.set_pose(still, {{Vec3(4e-3, 0, -4e-3), lying}, 0});
        world.set_pose(moving, {{Vec3(0, 3e-3, 0), Quat::Identity()}, 0});
        Advance last;
        for (double y = 3e-3; y > -3e-3; y -= speed * 1e-3) {
            last = world.advance(moving, {{Vec3(0, y, 0), Quat::Identity()}, 0});
            ASSERT_GT(world.clearance(moving, 1e-3), 0);
        }
        EXPECT_TRUE(last.stopped);
        EXPECT_EQ(last.tool, still);
        EXPECT_EQ(last.surface, -1);
        EXPECT_NEAR(last.reached.pose.position.y(), 0.4e-3, world.skin(moving));
        EXPECT_FALSE(world.advance(moving, {{Vec3(0, 3e-3, 0), Quat::Identity()}, 0}).stopped);
    }
}

// A shaft swings 80 mm behind the tip: turning alone can carry it through the other tool between two ticks.
TEST(ToolWorld, ATurningShaftStopsAtAnotherTool) {
    ToolWorld world;
    const int moving = world.add_tool(Kind::needle_holder), still = world.add_tool(Kind::forceps);
    world.set_pose(still, {{Vec3(5e-3, 0, -50e-3), Quat(Eigen::AngleAxisd(-EIGEN_PI / 2, Vec3::UnitX()))}, 0});
    world.set_pose(moving, {{Vec3::Zero(), Quat::Identity()}, 0});
    const Quat turned(Eigen::AngleAxisd(-0.6, Vec3::UnitY()));
    const Advance turn = world.advance(moving, {{Vec3::Zero(), turned}, 0});
    EXPECT_TRUE(turn.stopped);
    EXPECT_EQ(turn.part, shaft);
    EXPECT_EQ(turn.tool, still);
    EXPECT_GT(world.clearance(moving, 1e-3), 0);
    EXPECT_LT(world.clearance(moving, 1e-3), 0.2e-3);
    EXPECT_LT(turn.reached.pose.rotation.angularDistance(turned), 0.6);
}

// Jaws that close on a vessel must stop at it, and the tool they belong to must still move: a blocked jaw that held the
// whole tool would freeze a surgeon's hand.
TEST(ToolWorld, JawsStopAtWhatTheyCloseOnAndDoNotHoldTheToolBack) {
    ToolWorld world;
    world.add_surface(vessel(0.5));  // 2 mm thick, between jaws 5 mm apart
    const int tool = world.add_tool(Kind::forceps);
    const Quat across = down * Quat(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitZ()));
    world.set_pose(tool, {{Vec3(0, 0, -1e-3), across}, 1});
    EXPECT_GT(brute_gap(world.parts(tool), vessel(0.5)), 0);
    const Advance closed = world.advance(tool, {{Vec3(0, 0, -1e-3), across}, 0});
    EXPECT_TRUE(closed.stopped);
    EXPECT_GT(closed.reached.jaw, 0.2);
    EXPECT_LT(closed.reached.jaw, 0.9);
    const Advance moved = world.advance(tool, {{Vec3(1e-3, 0, -1e-3), across}, 0});
    EXPECT_EQ(moved.reached.pose.position, Vec3(1e-3, 0, -1e-3));
    EXPECT_GT(brute_gap(world.parts(tool), vessel(0.5)), 0);
}

// Pushed down and along at once, a tool that only stopped would stick to the wall for as long as it is pushed.
TEST(ToolWorld, APressedToolSlidesAlongTheVessel) {
    ToolWorld world;
    world.add_surface(vessel());
    const int tool = world.add_tool(Kind::needle_holder);
    world.set_pose(tool, {{Vec3(0, 0, 2.2e-3), down}, 0});
    for (int tick = 1; tick <= 100; ++tick) {
        world.advance(tool, {{Vec3(0.1e-3 * tick, 0, 1.5e-3), down}, 0});
        ASSERT_GT(brute_gap(world.parts(tool), vessel()), 0);
    }
    // Friction, 0.15 of the half millimetre it is pressed by, drags it behind.
    EXPECT_NEAR(world.pose(tool).pose.position.x(), 10e-3 - 0.15 * 0.5e-3, 0.01e-3);
    EXPECT_GT(world.pose(tool).pose.position.z(), 1.9e-3);
}

// Random hard pushes into a vessel and another tool from all sides, with turning and jaws: whatever the order of
// events, nothing is ever inside anything. The vessel's inside is reachable only through its wall.
TEST(ToolWorld, NothingEverGetsInsideAnything) {
    for (const unsigned seed : {1u, 2u}) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> uniform(-1, 1);
        ToolWorld world;
        world.add_surface(vessel());
        const std::array<int, 2> tools{world.add_tool(Kind::forceps), world.add_tool(Kind::needle_holder)};
        world.set_pose(tools[0], {{Vec3(-4e-3, 0, 6e-3), down}, 1});
        world.set_pose(tools[1], {{Vec3(4e-3, 0, 6e-3), down}, 1});
        int stops = 0;
        for (int tick = 0; tick < 250; ++tick)
            for (const int tool : tools) {
                const Vec3 from = world.pose(tool).pose.position;
                const Vec3 position =
                    from + 1e-3 * Vec3(uniform(random), uniform(random), uniform(random)) - 0.1 * from;
                const Quat tilt(1, 0.3 * uniform(random), 0.3 * uniform(random), uniform(random));
                stops += world.advance(tool, {{position, down * tilt.normalized()}, 0.5 + uniform(random)}).stopped;
                ASSERT_GE(brute_gap(world.parts(tool), vessel()), world.skin(tool) / 5);
                ASSERT_GT(world.clearance(tool, 1e-3), 0);
            }
        EXPECT_GT(stops, 50);  // otherwise the seed does not test anything
    }
}

// Bullet's fixed lengths show at one size and hide at others: neither its unit nor the size of the scene may change
// what happens. The unit must not change a bit; the scene's size only rounding.
TEST(ToolWorld, TheUnitAndTheSizeOfTheSceneChangeNothing) {
    const auto run = [](double unit, double scale) {
        ToolWorld world(unit);
        world.add_surface(vessel(scale));
        const int tool = world.add_tool(scaled(shape_of(Kind::forceps), scale));
        const int other = world.add_tool(scaled(shape_of(Kind::needle_holder), scale));
        world.set_pose(other, {{scale * Vec3(3e-3, 0, 3e-3), down}, 0});
        world.set_pose(tool, {{scale * Vec3(-3e-3, 0.2e-3, 4e-3), down}, 1});
        std::vector<Vec3> path;
        for (int tick = 0; tick < 60; ++tick) {
            const Vec3 to(-3e-3 + 0.1e-3 * tick, 0.2e-3, 4e-3 - 0.1e-3 * tick);
            path.push_back(world.advance(tool, {{scale * to, down}, 1 - tick / 60.0}).reached.pose.position / scale);
        }
        return path;
    };
    const auto path = run(bullet_unit, 1);
    for (const double unit : {1e-4, 1e-2, 1.0}) EXPECT_EQ(run(unit, 1), path) << unit;
    for (const double scale : {10.0, 1000.0}) {
        const auto larger = run(bullet_unit, scale);
        for (std::size_t i = 0; i < path.size(); ++i)
            EXPECT_LT((larger[i] - path[i]).norm(), 1e-12) << scale << ' ' << i;
    }
}

// A tracker that loses its target for one tick sends anything. The tool must stay, the loss be told, and the next good
// tick be as if nothing had happened.
TEST(ToolWorld, UnusableInputHoldsTheTool) {
    const double nan = std::nan(""), inf = HUGE_VAL;
    const ToolInput good{{Vec3(1e-3, 2e-3, 3e-3), down}, 0.5};
    const auto with = [&](auto change) {
        ToolInput input = good;
        input.pose.position.x() += 1e-3;
        change(input);
        return input;
    };
    const std::vector<ToolInput> bad{
        with([&](auto& i) { i.pose.position.y() = nan; }),          with([&](auto& i) { i.pose.position.z() = -inf; }),
        with([&](auto& i) { i.pose.position.z() = 1e300; }),        with([&](auto& i) { i.pose.rotation.w() = nan; }),
        with([&](auto& i) { i.pose.rotation.coeffs().setZero(); }), with([&](auto& i) { i.jaw = nan; })};
    for (const ToolInput& input : bad) {
        ToolWorld world;
        const int tool = world.add_tool(Kind::forceps);
        world.set_pose(tool, good);
        const Advance held = world.advance(tool, input);
        EXPECT_TRUE(held.input_dropped);
        EXPECT_EQ(held.reached.pose.position, good.pose.position);
        EXPECT_EQ(held.reached.jaw, good.jaw);
        const Advance next = world.advance(tool, good);
        EXPECT_FALSE(next.input_dropped);
        EXPECT_EQ(next.reached.pose.position, good.pose.position);
    }
}

// Devices send q or -q as they please, and not always unit; neither may show in a recording.
TEST(ToolWorld, TheSignAndLengthOfAQuaternionDoNotMatter) {
    const Quat q(Eigen::AngleAxisd(2.5, Vec3(1, 2, -1).normalized()));
    Quat reference = Quat::Identity();
    for (const double factor : {1.0, -1.0, 4.0, -0.5, 0x1p-500}) {
        ToolWorld world;
        const int tool = world.add_tool(Kind::forceps);
        const Quat sent(Eigen::Vector4d(factor * q.coeffs()));
        const Advance advance = world.advance(tool, {{Vec3::Zero(), sent}, 2.0});
        EXPECT_FALSE(advance.stopped);
        EXPECT_EQ(advance.reached.jaw, 1.0);
        EXPECT_GE(advance.reached.pose.rotation.w(), 0);
        EXPECT_NEAR(advance.reached.pose.rotation.norm(), 1, 1e-15);
        if (factor == 1) reference = advance.reached.pose.rotation;
        EXPECT_LT((advance.reached.pose.rotation.coeffs() - reference.coeffs()).norm(), factor == -1 ? 1e-300 : 1e-15);
        // Given back, a pose is the same pose.
        world.set_pose(tool, advance.reached);
        EXPECT_EQ(world.pose(tool).pose.rotation.coeffs(), advance.reached.pose.rotation.coeffs());
    }
}

// A recording is replayed in another process, where memory lies elsewhere and other worlds came before.
TEST(ToolWorld, TheSameCallsGiveTheSameBits) {
    const auto run = [] {
        ToolWorld world;
        world.add_surface(vessel());
        const int tool = world.add_tool(Kind::forceps), other = world.add_tool(Kind::needle_holder);
        world.set_pose(other, {{Vec3(2e-3, 0, 4e-3), down}, 0.5});
        world.set_pose(tool, {{Vec3(-2e-3, 0, 4e-3), down}, 1});
        std::mt19937 random(7);
        std::uniform_real_distribution<double> uniform(-1, 1);
        std::vector<double> bits;
        for (int tick = 0; tick < 200; ++tick)
            for (const int moved : {tool, other}) {
                const Vec3 position = 4e-3 * Vec3(uniform(random), uniform(random), uniform(random));
                const Advance a = world.advance(moved, {{position, down}, uniform(random)});
                for (const double x :
                     {a.reached.pose.position.x(), a.reached.pose.position.y(), a.reached.pose.position.z(),
                      a.reached.jaw, double(a.tool), double(a.surface), double(a.part)})
                    bits.push_back(x);
            }
        return bits;
    };
    const auto first = run();
    const std::vector<std::unique_ptr<int>> elsewhere(1000);
    const auto second = run();
    EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(double)), 0);
}

// A drill is taken over at a checkpoint: a copy must go on as the original does, and neither may disturb the other.
TEST(ToolWorld, ACopyGoesOnAsTheOriginalDoes) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    ToolWorld world;
    world.add_surface(vessel());
    const std::array<int, 2> tools{world.add_tool(Kind::forceps), world.add_tool(Kind::needle_holder)};
    world.set_pose(tools[0], {{Vec3(-4e-3, 0, 6e-3), down}, 1});
    world.set_pose(tools[1], {{Vec3(4e-3, 0, 6e-3), down}, 1});
    ToolWorld copy = world;
    int stops = 0;
    for (int tick = 0; tick < 400; ++tick)
        for (const int tool : tools) {
            if (tick % 50 == 0) copy = world;
            const Vec3 position = 4e-3 * Vec3(uniform(random), uniform(random), 1 + uniform(random));
            const ToolInput wanted{{position, down}, 0.5 + uniform(random)};
            const Advance a = world.advance(tool, wanted), b = copy.advance(tool, wanted);
            stops += a.stopped;
            ASSERT_EQ(a.reached.pose.position, b.reached.pose.position) << tick;
            ASSERT_EQ(a.reached.pose.rotation.coeffs(), b.reached.pose.rotation.coeffs()) << tick;
            ASSERT_EQ(a.reached.jaw, b.reached.jaw) << tick;
            ASSERT_EQ(std::tie(a.stopped, a.part, a.tool, a.surface), std::tie(b.stopped, b.part, b.tool, b.surface));
            ASSERT_EQ(world.clearance(tool, 1e-3), copy.clearance(tool, 1e-3)) << tick;
        }
    EXPECT_GT(stops, 50);  // otherwise the seed does not test anything
}

// A drill may start with a tool pressed into a vessel: it must come out, and must not be let in deeper.
TEST(ToolWorld, AToolPlacedInsideAWallCanOnlyLeave) {
    const auto start = [](ToolWorld& world) {
        world.add_surface(vessel());
        const int tool = world.add_tool(Kind::needle_holder);
        world.set_pose(tool, {{Vec3(0, 0, 1.9e-3), down}, 0});
        return tool;
    };
    ToolWorld in, out;
    const int deeper = start(in), leaving = start(out);
    const double gap = in.clearance(deeper, 1e-3);
    EXPECT_NEAR(gap, -0.1e-3, 0.02e-3);
    EXPECT_TRUE(in.advance(deeper, {{Vec3(0, 0, 1.7e-3), down}, 0}).stopped);
    EXPECT_GE(in.clearance(deeper, 1e-3), gap - in.skin(deeper) / 4);
    EXPECT_FALSE(out.advance(leaving, {{Vec3(0, 0, 2.5e-3), down}, 0}).stopped);
    EXPECT_GT(out.clearance(leaving, 1e-3), 0.4e-3);
}

// Bullet lists what is near in the order of its tree, which remembers how bodies moved: two recordings that reach the
// same pose on different ways would meet the same things in another order.
TEST(BulletWorld, WhatIsNearDoesNotDependOnHowItGotThere) {
    const auto near_after = [](const std::vector<int>& order) {
        BulletWorld world;
        for (int i = 0; i < 6; ++i) world.add_capsule(10e-3, 1e-3);
        world.add_surface(vessel());
        for (const int i : order)
            world.place(i, {Vec3(i * 1e-3, 0, 5e-3), Vec3(i * 1e-3, 0, 15e-3), 1e-3}, Vec3::UnitY());
        Box box;
        box.include(Vec3(2e-3, 0, 1e-3));
        box.include(Vec3(4e-3, 0, 6e-3));
        std::vector<BulletWorld::Near> found;
        world.near(box, found);
        return found;
    };
    const auto found = near_after({0, 1, 2, 3, 4, 5});
    EXPECT_GT(found.size(), 5u);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(found, near_after({5, 0, 4, 2, 1, 3, 3, 5, 0, 2}));
}

// Bullet keeps a wider box about each body than it has, wider where it moved: a copy that made its own would find less.
TEST(BulletWorld, ACopyFindsWhatTheOriginalFinds) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    BulletWorld world;
    for (int i = 0; i < 6; ++i) world.add_capsule(10e-3, 1e-3);
    world.add_surface(vessel());
    const auto place = [&](BulletWorld& in, int body, const Vec3& from) {
        in.place(body, {from, from + Vec3(0, 0, 10e-3), 1e-3}, Vec3::UnitY());
    };
    for (int round = 0; round < 20; ++round) {
        for (int body = 0; body < 6; ++body)
            place(world, body, 5e-3 * Vec3(uniform(random), uniform(random), uniform(random)));
        for (int body = 0; body < 6; ++body)  // a little way on, within the wider box
            place(world, body, 5e-3 * Vec3(body - 2.5, 0, 0) + 0.02e-3 * Vec3(uniform(random), uniform(random), 0));
        const BulletWorld copy = world;
        for (int look = 0; look < 200; ++look) {
            Box box;
            box.include(15e-3 * Vec3(uniform(random), uniform(random), uniform(random)));
            std::vector<BulletWorld::Near> expected, found;
            world.near(box, expected), copy.near(box, found);
            ASSERT_EQ(found, expected) << round << ' ' << look;
        }
    }
}
