// A wall that moves takes the thread along, or stops at it; it never passes through.
#include "scenarios/world/moving_wall.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/geometry/closest_points.hpp"
#include "sim/thread/thread.hpp"

namespace moving_wall {

using scenarios::world::MovingWall;
using scenarios::world::Triangle;
using sim::geometry::Vec3;
using sim::thread::Hold;
using sim::thread::Thread;

constexpr double mm = 1e-3, tick = 1e-3;

// A plate of 8 x 8 mm in squares of 1 mm at height z [m], domed so that no two triangles are alike.
std::vector<Triangle> plate(double z) {
    const auto corner = [&](int i, int j) {
        return Vec3((i - 4) * mm, (j - 4) * mm, z - 0.01 * mm * (i * i + j * j % 5));
    };
    std::vector<Triangle> triangles;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j) {
            triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
            triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
        }
    return triangles;
}

struct Scene {
    explicit Scene(const char* model)
        : thread(make(model)),
          wall(plate(-0.5 * mm), thread.def().radius),
          rooms(static_cast<std::size_t>(wall.size())) {}

    static Thread make(const char* model) {
        sim::thread::ThreadDef def;
        if (std::string(model) == "elastic") def.elastic = sim::thread::RodDef{.keeps_shape = true};
        std::vector<Vec3> nodes;
        for (int i = 0; i <= 60; ++i) nodes.push_back({(i - 30) * 0.1 * mm, 0.05 * mm, 0});
        return {def, nodes};
    }

    // The wall is asked up to height z and the thread answers; its ends are held where they are, or free.
    void step(double z, bool held) {
        const std::vector<Hold> holds =
            held ? std::vector<Hold>{{0, thread.nodes().front()}, {60, thread.nodes().back()}} : std::vector<Hold>{};
        const std::vector<int> owners(holds.size(), -1);
        const auto report = thread.tick({.holds = holds,
                                         .hold_owners = owners,
                                         .capsules = {},
                                         .surface = &wall.tree(),
                                         .seconds = tick,
                                         .surface_moved = moved});
        passes += report.pass_throughs;
        thread.surface_room(rooms, gaps);
        moved = wall.follow(plate(z), rooms, gaps);
    }
    // Of the thread's middle line over the wall [radii].
    double height() const {
        double least = 1e300;
        for (std::size_t i = 0; i + 1 < thread.nodes().size(); ++i)
            for (const Triangle& t : wall.tree().triangles())
                least = std::min(least, closest_points(thread.nodes()[i], thread.nodes()[i + 1], t).distance_squared);
        return std::sqrt(least) / thread.def().radius;
    }
    // Straight over a node.
    bool is_over(const Vec3& node) const {
        constexpr double far_up = 100 * mm, rounding = 1e-12 * far_up;
        const Vec3 far = node + far_up * Vec3::UnitZ();
        return std::any_of(wall.tree().triangles().begin(), wall.tree().triangles().end(), [&](const Triangle& t) {
            return sim::geometry::closest_points(node, far, t).distance_squared < rounding * rounding;
        });
    }
    double top() const { return wall.tree()[(4 * 8 + 4) * 2].a.z(); }  // below the middle of the thread

    Thread thread;
    MovingWall wall;
    std::vector<double> rooms;
    std::vector<sim::thread::SurfaceGap> gaps;
    double moved = 0;
    int passes = 0;
};

class MovingWallTest : public testing::TestWithParam<const char*> {};

TEST_P(MovingWallTest, TakesAFreeThreadAlong) {
    Scene scene(GetParam());
    for (int t = 0; t < 400; ++t) {
        scene.step(-0.5 * mm + 5 * mm * tick * t, false);  // 5 mm/s
        ASSERT_GE(scene.height(), 0.59) << "tick " << t;   // what the wall leaves it
    }
    for (int t = 0; t < 300; ++t) scene.step(1.5 * mm, false);
    EXPECT_DOUBLE_EQ(scene.top(), plate(1.5 * mm)[(4 * 8 + 4) * 2].a.z());
    EXPECT_GE(scene.height(), 0.8);  // passes of `ftl` leave a tenth of the thickness in walls
    for (const Vec3& node : scene.thread.nodes()) EXPECT_GT(node.z(), 0.5 * mm);
    EXPECT_EQ(scene.passes, 0);
}

// However deep a taut thread is pressed into it: what goes away, or along it, needs no room.
TEST_P(MovingWallTest, LeavesATautOneAtOnce) {
    Scene scene(GetParam());
    for (int t = 0; t < 30 && scene.height() >= 1; ++t) scene.step(-0.5 * mm + 100 * mm * tick * t, true);
    ASSERT_LT(scene.height(), 1);
    for (int t = 0; t < 30; ++t) scene.step(-0.5 * mm, true);
    EXPECT_GT(scene.height(), 2);
    EXPECT_EQ(scene.passes, 0);
}

TEST_P(MovingWallTest, StopsAtATautOne) {
    Scene scene(GetParam());
    for (int t = 0; t < 400; ++t) {
        scene.step(-0.5 * mm + 100 * mm * tick * t, true);
        ASSERT_GE(scene.height(), 0.59) << "tick " << t;
    }
    for (const Vec3& node : std::span(scene.thread.nodes()).subspan(10, 41))  // round the thread's ends it may come
        EXPECT_FALSE(scene.is_over(node)) << node.x() / mm;
    for (const int beside : {2, 6})
        EXPECT_GT(scene.wall.tree()[(4 * 8 + beside) * 2].a.z(), 1 * mm);  // two squares from the thread it goes on
    EXPECT_EQ(scene.passes, 0);
    double up = 0;  // the wall pushes, so the thread pushes back
    for (const auto& force : scene.thread.surface_forces()) up += force.force.z();
    EXPECT_LE(up, 0);
}

// Each strand of a knot turns a corner's way a little more, until it looks back: a corner under one ran metres away.
TEST(MovingWall, DoesNotTurnBack) {
    MovingWall wall(plate(0), 0.1 * mm);
    const std::vector<double> rooms(static_cast<std::size_t>(wall.size()), 1);
    std::vector<sim::thread::SurfaceGap> gaps;
    constexpr double degree = EIGEN_PI / 180, no_room = 0.06 * mm;
    for (int turn = 170; turn > -10; turn -= 10)
        for (int t = 0; t < wall.size(); ++t)
            gaps.push_back({t, Vec3(std::cos(turn * degree), 0, std::sin(turn * degree)), no_room});
    wall.follow(plate(0.1 * mm), rooms, gaps);
    for (int t = 0; t < wall.size(); ++t) EXPECT_GE(wall.tree()[t].a.z(), plate(0)[static_cast<std::size_t>(t)].a.z());
}

// Some way behind, one of its triangles is split and another one taken out: what is left of what is shown is where it
// was, and goes on from there.
TEST(MovingWall, StaysWhereItIsShownWhenItIsRenewed) {
    MovingWall wall(plate(0), 0.1 * mm);
    const std::vector<double> rooms(static_cast<std::size_t>(wall.size()), 0.2 * mm);
    wall.follow(plate(1 * mm), rooms, {});
    const std::vector<Triangle> shown = wall.tree().triangles(), target = plate(1 * mm);
    const Vec3 inside(0.2, 0.3, 0.5);
    std::vector<Triangle> left;
    std::vector<tissue::Part> parts;
    for (int t = 2; t < static_cast<int>(target.size()); ++t)
        left.push_back(target[static_cast<std::size_t>(t)]), parts.push_back({t});
    const auto within = [&](const Triangle& t) -> Vec3 {
        return inside.x() * t.a + inside.y() * t.b + inside.z() * t.c;
    };
    Eigen::Matrix3d weights = Eigen::Matrix3d::Identity();
    weights.col(2) = inside;
    left.push_back({target[1].a, target[1].b, within(target[1])}), parts.push_back({1, weights});
    wall.renew(left, parts, std::vector<MovingWall::Holes>(parts.size(), {-1, -1, -1}));
    ASSERT_EQ(wall.size(), static_cast<int>(shown.size()) - 1);
    for (int t = 0; t + 1 < wall.size(); ++t)
        for (const auto& corner : {&Triangle::a, &Triangle::b, &Triangle::c})
            EXPECT_LE((wall.tree()[t].*corner - shown[static_cast<std::size_t>(t + 2)].*corner).norm(),
                      1e-15);  // rounding
    EXPECT_LE((wall.tree()[wall.size() - 1].c - within(shown[1])).norm(), 1e-15);
    const std::vector<double> wide(static_cast<std::size_t>(wall.size()), 1);
    wall.follow(left, wide, {});
    EXPECT_LE((wall.tree()[wall.size() - 1].c - left.back().c).norm(), 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Models, MovingWallTest, testing::Values("ftl", "elastic"),
                         [](const auto& of) { return std::string(of.param); });

}  // namespace moving_wall
