// Two cut ends in the clamps of an approximator.
#include <gtest/gtest.h>

#include "tests/scenarios/world/scene.hpp"

namespace approximating {

using namespace scene;

// Ends along x, 3 mm apart; the approximator under them stands upright, its jaws open along x.
struct Clamped : Scene {
    Clamped() {
        for (const double side : {-1.0, 1.0}) {
            auto end = end_at(1.5 * side * mm, -4 * side * mm);
            end.held_by = 0;
            def.vessels.push_back(end);
        }
        add("approximator", Kind::approximator, {{{0, 0, -8 * mm}, Quat::Identity()}, 1});
        lay_aside();
    }
};

Vec3 clamped(const World& world, std::size_t vessel) {
    const auto& of = world.vessels()[vessel];
    return of.tissue.nodes()[static_cast<std::size_t>(of.clamps.front().node)];
}

constexpr double step =
    1e-5;  // [m] that a screw goes in a tick: where a vessel of two is at most a tick behind its clamp

// Closed it brings both ends together by as much, at no more than its screw's speed however it is asked.
TEST(Approximator, BringsEndsTogetherByItsScrew) {
    Clamped scene;
    World world = scene.world();
    const Vec3 left = clamped(world, 0), right = clamped(world, 1);
    scene.tools[0].jaw = 0.5;
    scene.play(world, 100);
    EXPECT_NEAR((clamped(world, 0) - left).norm(), 1 * mm, 2 * step);
    scene.play(world, 200);
    const auto& shape = instruments::shape_of(Kind::approximator);
    const double by = instruments::opening_of(shape, 1) - instruments::opening_of(shape, 0.5);
    EXPECT_NEAR(by, 1.25 * mm, 0.01 * mm) << "half of its rail of 5 mm, half to each side";
    EXPECT_LT((clamped(world, 0) - left - Vec3(by, 0, 0)).norm(), 1e-9 * mm);
    EXPECT_LT((clamped(world, 1) - right + Vec3(by, 0, 0)).norm(), 1e-9 * mm);
}

// Turned over both ends go round with it, for the stitches of the back wall.
TEST(Approximator, CarriesAndTurnsWhatItHolds) {
    Clamped scene;
    World world = scene.world();
    const Vec3 left = clamped(world, 0), place = scene.tools[0].pose.position;
    const Quat over(Eigen::AngleAxisd(EIGEN_PI / 18, Vec3::UnitX()));
    scene.tools[0].pose = {place + Vec3(0, 0, mm), over};
    scene.play(world, 600);
    EXPECT_LT((clamped(world, 0) - (place + Vec3(0, 0, mm) + over * (left - place))).norm(), 1e-9 * mm);
}

}  // namespace approximating
