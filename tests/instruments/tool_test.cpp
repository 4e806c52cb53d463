#include "instruments/tool.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/geometry/closest_points.hpp"

using namespace instruments;

static double gap(const Capsule& a, const Capsule& b) {
    return std::sqrt(sim::geometry::closest_points(a.a, a.b, b.a, b.b).distance_squared) - a.radius - b.radius;
}

static const Pose somewhere{{0.3, -0.1, 0.2}, Quat(Eigen::AngleAxisd(2.1, Vec3(1, -2, 0.5).normalized()))};

// Rounding of positions of this size [m], a few operations deep.
constexpr double rounding = 1e-15;

// Jaws that stay apart when closed let the thread slide out; jaws that overlap push it through themselves.
TEST(Tool, ClosedJawsTouchAndNoOpeningMakesThemOverlap) {
    for (const Kind kind : {Kind::forceps, Kind::needle_holder, Kind::scissors, Kind::approximator}) {
        const ToolShape& shape = shape_of(kind);
        const auto closed = parts_at(shape, somewhere, 0);
        EXPECT_NEAR((closed[jaw_plus].b - closed[jaw_minus].b).norm(), 2 * shape.jaw_radius, rounding);
        EXPECT_NEAR(gap(closed[jaw_plus], closed[jaw_minus]), 0, rounding);
        for (double jaw = 0; jaw <= 1; jaw += 0.125) {
            const auto parts = parts_at(shape, somewhere, jaw);
            EXPECT_GE(gap(parts[jaw_plus], parts[jaw_minus]), -rounding) << jaw;
        }
    }
}

// A tool that waits in the middle of a turn is behind its hand, though its tips are where they should be.
TEST(Tool, TurnsCountAtTheArmByTheirChord) {
    const Pose turned{somewhere.position, somewhere.rotation * Quat(Eigen::AngleAxisd(1.2, Vec3::UnitY()))};
    const Vec3 hinge(0, 0, -12e-3);
    EXPECT_NEAR(distance_between(somewhere, turned, 12e-3),
                (somewhere.rotation * hinge - turned.rotation * hinge).norm(), rounding);
    EXPECT_NEAR(distance_between(somewhere, {somewhere.position + Vec3(3e-3, 0, 4e-3), turned.rotation}, 0), 5e-3,
                rounding);
}

// Motion files place the tip: were the frame elsewhere, every drill's tools would be off by that much.
TEST(Tool, TipsOfClosedJawsAreAtTheFramesOrigin) {
    for (const Kind kind : {Kind::forceps, Kind::needle_holder, Kind::scissors, Kind::approximator}) {
        const auto parts = parts_at(shape_of(kind), {}, 0);
        EXPECT_LT((0.5 * (parts[jaw_plus].b + parts[jaw_minus].b) + Vec3(0, 0, shape_of(kind).jaw_radius)).norm(),
                  rounding);
        EXPECT_NEAR(parts[jaw_plus].a.z(), -shape_of(kind).jaw_length, rounding);
        EXPECT_LT(parts[shaft].a.z(), parts[shaft].b.z());
    }
}

// Published sizes of the real instruments; a jaw that opens too little cannot take the thread.
TEST(Tool, OpensAsFarAsTheRealOne) {
    const auto forceps = parts_at(shape_of(Kind::forceps), {}, 1),
               holder = parts_at(shape_of(Kind::needle_holder), {}, 1);
    EXPECT_NEAR((forceps[jaw_plus].b - forceps[jaw_minus].b).norm() - 0.4e-3, 5e-3, 0.01e-3);
    const Vec3 a = holder[jaw_plus].b - holder[jaw_plus].a, b = holder[jaw_minus].b - holder[jaw_minus].a;
    EXPECT_NEAR(std::acos(a.normalized().dot(b.normalized())), 20 * EIGEN_PI / 180, 0.001);
}

// A part that is placed by the pose's rotation alone, or by its inverse, goes unnoticed until a tool is turned.
TEST(Tool, PartsMoveWithThePoseAndJawsMirrorEachOther) {
    for (const Kind kind : {Kind::forceps, Kind::needle_holder, Kind::scissors, Kind::approximator}) {
        const auto own = parts_at(shape_of(kind), {}, 0.4), moved = parts_at(shape_of(kind), somewhere, 0.4);
        const auto placed = [](const Vec3& p) -> Vec3 { return somewhere.position + somewhere.rotation * p; };
        for (std::size_t i = 0; i < part_count; ++i) {
            EXPECT_LT((moved[i].a - placed(own[i].a)).norm(), rounding);
            EXPECT_LT((moved[i].b - placed(own[i].b)).norm(), rounding);
        }
        EXPECT_EQ(own[jaw_plus].b, Vec3(own[jaw_minus].b.cwiseProduct(Vec3(-1, 1, 1))));
        EXPECT_GT(own[jaw_plus].b.x(), own[jaw_minus].b.x());
    }
}

// A pose at either end that is off by rounding never settles: a held tool would creep a bit each tick.
TEST(Between, MeetsItsEndsExactlyAndTurnsAtAConstantRate) {
    const Pose from{{1, 2, 3}, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()))};
    const Pose to{{2, 2, 1}, Quat(-Quat(Eigen::AngleAxisd(1.5, Vec3::UnitY())).coeffs())};
    EXPECT_EQ(between(from, to, 0).rotation.coeffs(), from.rotation.coeffs());
    EXPECT_EQ(between(from, to, 1).rotation.coeffs(), to.rotation.coeffs());
    const Pose third = between(from, to, 1.0 / 3);
    EXPECT_LT(third.rotation.angularDistance(Quat(Eigen::AngleAxisd(0.7, Vec3::UnitY()))), 1e-7);
    EXPECT_LT((third.position - Vec3(4.0 / 3, 2, 7.0 / 3)).norm(), rounding * 10);
}
