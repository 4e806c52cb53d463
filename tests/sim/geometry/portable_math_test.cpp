#include "sim/geometry/portable_math.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace sim::geometry;

// Placing tools with a poor sine shows as jaws that do not meet; the header promises 1e-15 within half a turn.
TEST(PortableMath, SineAndCosineAreThoseOfTheLibrary) {
    for (int i = -1000; i <= 1000; ++i) {
        const double angle = EIGEN_PI * i / 1000;
        const auto [sin, cos] = portable_sin_cos(angle);
        EXPECT_NEAR(sin, std::sin(angle), 1e-15) << angle;
        EXPECT_NEAR(cos, std::cos(angle), 1e-15) << angle;
    }
    for (const double tiny : {1e-3, 1e-8, 1e-300})
        EXPECT_NEAR(portable_sin_cos(tiny).sin / tiny, std::sin(tiny) / tiny, 1e-15);
    EXPECT_EQ(portable_sin_cos(0).sin, 0);
    EXPECT_EQ(portable_sin_cos(0).cos, 1);
}

// Too coarse a slerp makes a tool that turns slowly jump; the wrong arc turns it the long way round.
TEST(PortableMath, SlerpIsEigensOnBothSignsAndAtEveryAngle) {
    const Vec3 axis = Vec3(1, -2, 0.5).normalized();
    for (const double angle : {0.0, 1e-9, 1e-3, 0.5, 2.0, 3.1}) {
        const Quat from(Eigen::AngleAxisd(0.7, Vec3::UnitX())), to = from * Quat(Eigen::AngleAxisd(angle, axis));
        for (const double t : {0.0, 0.1, 1.0 / 3, 0.5, 0.999, 1.0}) {
            const Quat q = portable_slerp(from, to, t), minus = portable_slerp(from, Quat(-to.coeffs()), t);
            EXPECT_LT((q.coeffs() - from.slerp(t, to).coeffs()).norm(), 1e-14) << angle << ' ' << t;
            EXPECT_EQ(q.coeffs(), minus.coeffs());
            EXPECT_NEAR(q.norm(), 1, 1e-15);
        }
    }
}

// A capstan's pull grows by it, over many turns.
TEST(PortableMath, ExponentialIsThatOfTheLibrary) {
    for (int i = -700; i <= 700; ++i) {
        const double x = i + 0.1 * (i % 7);
        EXPECT_NEAR(portable_exp(x) / std::exp(x), 1, 2e-15 * (1 + std::abs(x))) << x;
        EXPECT_NEAR(portable_exp(x / 700) / std::exp(x / 700), 1, 2e-15) << x / 700;
    }
    EXPECT_EQ(portable_exp(0), 1);
    EXPECT_EQ(portable_exp(-1e5), 0);
    EXPECT_EQ(portable_exp(1e5), std::numeric_limits<double>::infinity());
}

// A vessel laid along a wrong axis, or one that vanishes because it points backwards. Nearly opposite directions lose
// digits of the sum's direction, as many as their angle is close to half a turn.
TEST(PortableMath, RotationBetweenTurnsOneDirectionIntoTheOther) {
    const Vec3 from(0.3, -2, 0.7), across = from.unitOrthogonal();
    for (const double angle : {0.0, 1e-9, 0.3, 1.6, 3.0, 3.14159}) {
        const Vec3 to = 5 * (std::cos(angle) * from.normalized() + std::sin(angle) * across);
        const Quat turn = rotation_between(from, to);
        const double rounding = 1e-15 / (EIGEN_PI - angle);
        EXPECT_NEAR(turn.norm(), 1, 1e-15) << angle;
        EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 10 * rounding) << angle;
        EXPECT_LT((turn.vec() - std::sin(angle / 2) * from.cross(to).normalized()).norm(), 10 * rounding) << angle;
    }
    EXPECT_LT((rotation_between(from, -from) * from + from).norm(), 1e-15);
}

// A twist read off by a quarter turn at the wrong side of an axis winds a rod up.
TEST(PortableMath, AngleOfAPointIsTheLibrarysInEveryQuadrant) {
    for (int i = -999; i <= 1000; ++i)
        for (const double length : {1e-200, 1.0, 1e150}) {
            const double angle = EIGEN_PI * i / 1000, x = length * std::cos(angle), y = length * std::sin(angle);
            EXPECT_NEAR(portable_atan2(y, x), std::atan2(y, x), 2e-15) << angle;
        }
    EXPECT_EQ(portable_atan2(0, 1), 0);
    EXPECT_NEAR(portable_atan2(1, 0), EIGEN_PI / 2, 1e-15);
    EXPECT_NEAR(portable_atan2(0, -1), EIGEN_PI, 1e-15);
    EXPECT_NEAR(portable_atan2(1e-20, 1), 1e-20, 1e-35);
}
