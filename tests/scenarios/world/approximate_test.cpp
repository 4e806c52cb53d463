// Two cut ends in the clamps of an approximator.
#include <gtest/gtest.h>

#include "scenarios/world/world.hpp"

namespace approximating {

using instruments::Kind;
using instruments::ToolInput;
using scenarios::world::World;
using sim::geometry::Quat;
using sim::geometry::Vec3;

constexpr double mm = 1e-3;

// Ends along x, 3 mm apart; the approximator under them stands upright, its jaws open along x.
struct Scene {
    scenarios::world::WorldDef def;
    ToolInput tool{{{0, 0, -8 * mm}, Quat::Identity()}, 1};

    Scene() {
        for (const double side : {-1.0, 1.0}) {
            scenarios::world::VesselDef end;
            end.diameter = 4 * mm, end.wall = 0.5 * mm, end.length = 4 * mm;
            end.centre = {side * 3.5 * mm, 0, 0};
            (side < 0 ? end.end_held : end.start_held) = false;
            end.is_soft = true;
            end.held_by = 0;
            def.vessels.push_back(end);
        }
        def.instruments = {{"approximator", Kind::approximator}};
        def.thread.length = 6 * mm;
        def.thread.links = 12;
        def.thread.start = {{0, 0, 30 * mm}, {6 * mm, 0, 30 * mm}};
    }
};

Vec3 clamped(const World& world, std::size_t vessel) {
    const auto& of = world.vessels()[vessel];
    return of.tissue.nodes()[static_cast<std::size_t>(of.clamps.front().node)];
}

void play(World& world, const ToolInput& tool, int ticks) {
    for (int t = 0; t < ticks; ++t) world.tick({&tool, 1});
}

constexpr double step =
    1e-5;  // [m] that a screw goes in a tick: where a vessel of two is at most a tick behind its clamp

// Closed it brings both ends together by as much, at no more than its screw's speed however it is asked.
TEST(Approximator, BringsEndsTogetherByItsScrew) {
    Scene scene;
    World world(scene.def, {}, {&scene.tool, 1});
    const Vec3 left = clamped(world, 0), right = clamped(world, 1);
    scene.tool.jaw = 0.5;
    play(world, scene.tool, 100);
    EXPECT_NEAR((clamped(world, 0) - left).norm(), 1 * mm, 2 * step);
    play(world, scene.tool, 200);
    const auto& shape = instruments::shape_of(Kind::approximator);
    const double by = instruments::opening_of(shape, 1) - instruments::opening_of(shape, 0.5);
    EXPECT_NEAR(by, 1.25 * mm, 0.01 * mm) << "half of its rail of 5 mm, half to each side";
    EXPECT_LT((clamped(world, 0) - left - Vec3(by, 0, 0)).norm(), 1e-9 * mm);
    EXPECT_LT((clamped(world, 1) - right + Vec3(by, 0, 0)).norm(), 1e-9 * mm);
}

// Turned over both ends go round with it, for the stitches of the back wall.
TEST(Approximator, CarriesAndTurnsWhatItHolds) {
    Scene scene;
    World world(scene.def, {}, {&scene.tool, 1});
    const Vec3 left = clamped(world, 0), place = scene.tool.pose.position;
    const Quat over(Eigen::AngleAxisd(EIGEN_PI / 18, Vec3::UnitX()));
    scene.tool.pose = {place + Vec3(0, 0, mm), over};
    play(world, scene.tool, 600);
    EXPECT_LT((clamped(world, 0) - (place + Vec3(0, 0, mm) + over * (left - place))).norm(), 1e-9 * mm);
}

}  // namespace approximating
