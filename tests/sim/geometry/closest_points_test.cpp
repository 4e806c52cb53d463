#include "sim/geometry/closest_points.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

using namespace sim::geometry;

static double length_of(const ClosestPair& pair) {
    return std::sqrt(pair.distance_squared);
}

// Two 0.4 mm pieces of thread crossing 0.1 mm apart, as inside a knot: a routine with an absolute threshold for "this
// is a point" or "these are parallel" measures between ends at one scale and is right at the others.
TEST(ClosestPoints, ACrossingIsFoundAtEveryScale) {
    for (const double unit : {1e-9, 1e-6, 1e-3, 1.0, 1e3}) {
        SCOPED_TRACE(unit);
        const auto pair = closest_points(unit * Vec3(-0.2, 0, 0), unit * Vec3(0.2, 0, 0), unit * Vec3(0, -0.2, 0.1),
                                         unit * Vec3(0, 0.2, 0.1));
        EXPECT_NEAR(length_of(pair), 0.1 * unit, 1e-15 * unit);
        EXPECT_NEAR(pair.s, 0.5, 1e-15);
        EXPECT_NEAR(pair.t, 0.5, 1e-15);
    }
}

// Strands end to end: the infinite lines meet, the strands do not.
TEST(ClosestPoints, StrandsEndToEndAreAsFarApartAsTheirEnds) {
    for (const double sideways : {0.0, 1e-12, 1e-9, 1e-6}) {
        SCOPED_TRACE(sideways);
        const Vec3 a1(0.005, sideways, 0), b0(0.006, 2 * sideways, 0);
        const auto pair = closest_points(Vec3(0, 0, 0), a1, b0, Vec3(0.011, 5 * sideways, 0));
        EXPECT_NEAR(length_of(pair), (b0 - a1).norm(), 1e-15);
    }
}

TEST(ClosestPoints, PointsAreSegmentsToo) {
    const Vec3 p(1, 2, 3), q(1, 2, 5), a(0, 0, 4), b(4, 0, 4);
    EXPECT_EQ(length_of(closest_points(p, p, q, q)), 2);
    EXPECT_EQ(length_of(closest_points(p, p, p, p)), 0);
    EXPECT_NEAR(length_of(closest_points(p, p, a, b)), std::sqrt(5.0), 1e-15);
    EXPECT_NEAR(length_of(closest_points(a, b, p, p)), std::sqrt(5.0), 1e-15);
}

namespace {
struct Scene {
    std::mt19937 random;
    std::uniform_real_distribution<double> uniform{-1, 1};
    explicit Scene(unsigned seed) : random(seed) {}
    Vec3 point() { return {uniform(random), uniform(random), uniform(random)}; }
    // Every fourth direction nearly or exactly that of `other`, every ninth no length at all.
    Vec3 side(int i, const Vec3& other) {
        if (i % 9 == 0) return Vec3::Zero();
        return i % 4 == 0 ? Vec3(other * uniform(random) + (i % 8 ? 1e-9 : 0) * point()) : point();
    }
};
}  // namespace

// The distance of points is convex along both segments, so two nested ternary searches are a slow but sure answer.
static double slow_distance(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
    const auto to_b = [&](double s) {
        const Vec3 p = a0 + s * (a1 - a0);
        double low = 0, high = 1;
        for (int i = 0; i < 60; ++i) {
            const double third = (high - low) / 3, l = low + third, h = high - third;
            ((p - b0 - l * (b1 - b0)).squaredNorm() < (p - b0 - h * (b1 - b0)).squaredNorm() ? high : low) =
                (p - b0 - l * (b1 - b0)).squaredNorm() < (p - b0 - h * (b1 - b0)).squaredNorm() ? h : l;
        }
        return (p - b0 - low * (b1 - b0)).norm();
    };
    double low = 0, high = 1, best = std::min(to_b(0), to_b(1));
    for (int i = 0; i < 60; ++i) {
        const double third = (high - low) / 3, l = to_b(low + third), h = to_b(high - third);
        best = std::min({best, l, h});
        (l < h ? high : low) = l < h ? high - third : low + third;
    }
    return best;
}

// The search stops where rounding hides which side is lower: at the root of double's precision times the size.
constexpr double search_rounding = 1e-7;

TEST(ClosestPoints, SegmentsAgreeWithASlowSearch) {
    for (const unsigned seed : {1u, 2u}) {
        SCOPED_TRACE(seed);
        Scene scene(seed);
        for (int i = 0; i < 150; ++i) {
            const Vec3 a0 = scene.point(), da = scene.side(i, Vec3::UnitX()), b0 = scene.point(),
                       db = scene.side(i + 3, da);
            const auto pair = closest_points(a0, a0 + da, b0, b0 + db);
            EXPECT_NEAR(length_of(pair), slow_distance(a0, a0 + da, b0, b0 + db), search_rounding) << i;
            EXPECT_LT((pair.on_a - a0 - pair.s * da).norm() + (pair.on_b - b0 - pair.t * db).norm(), 1e-15);
            EXPECT_EQ(pair.distance_squared, (pair.on_a - pair.on_b).squaredNorm());
            EXPECT_TRUE(pair.s >= 0 && pair.s <= 1 && pair.t >= 0 && pair.t <= 1);
        }
    }
}

// Sides are looked at three at once. Every fifth segment ends beyond a corner, where sides tie, every eleventh is as
// parallel to a side as is told apart: another order of sums, or a tie taken otherwise, is another bit here and another
// knot an hour later.
TEST(ClosestPoints, SidesOfATriangleAtOnceAreTheSameBitsAsOneByOne) {
    Scene scene(4);
    int beside = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 corner = 2 * scene.point();
        const Triangle triangle{corner, corner + scene.point(), corner + scene.side(i, Vec3::UnitZ())};
        const Vec3 a0 = 2 * scene.point(), along = i % 11
                                                       ? scene.side(i + 1, Vec3::UnitX())
                                                       : Vec3(0.3 * (triangle.c - triangle.b) + 1e-3 * scene.point());
        const Vec3 a1 = i % 5 ? Vec3(a0 + along) : Vec3(2 * triangle.b - 0.5 * (triangle.a + triangle.c));
        const auto pair = closest_points(a0, a1, triangle);
        ClosestPair best = closest_points(a0, a1, triangle.a, triangle.b);
        for (const auto& edge :
             {closest_points(a0, a1, triangle.b, triangle.c), closest_points(a0, a1, triangle.c, triangle.a)})
            if (edge.distance_squared < best.distance_squared) best = edge;
        if (pair.distance_squared < best.distance_squared) continue;  // within the face
        ++beside;
        ASSERT_EQ(pair.distance_squared, best.distance_squared) << i;
        ASSERT_EQ(pair.s, best.s) << i;
        ASSERT_TRUE(pair.on_a == best.on_a && pair.on_b == best.on_b) << i;
    }
    EXPECT_GT(beside, 10000);
}

// Every third triangle is a sliver, as beside a hole, every seventh of them has no area: one whose sides are mistaken
// says that a wall is pushed from elsewhere.
TEST(ClosestPoints, APointsPlaceOnATriangleIsTheSegmentsOfNoLength) {
    Scene scene(5);
    std::array<int, 3> regions{};
    for (int i = 0; i < 20000; ++i) {
        const Vec3 corner = scene.point(), side = scene.point();
        const Triangle triangle{
            corner, corner + side,
            i % 3 ? Vec3(corner + scene.point()) : Vec3(corner + 0.5 * side + (i % 7 ? 1e-3 : 0) * scene.point())};
        const Vec3 p = 2 * scene.point(), place = closest_point(p, triangle);
        const auto pair = closest_points(p, p, triangle);
        ASSERT_NEAR((place - p).norm(), length_of(pair), 1e-12) << i;
        int on = 0;  // sides
        for (const auto& [a, b] :
             {std::pair(triangle.a, triangle.b), std::pair(triangle.b, triangle.c), std::pair(triangle.c, triangle.a)})
            on += closest_points(place, place, a, b).distance_squared < 1e-24;
        ++regions[static_cast<std::size_t>(on)];
    }
    for (const int found : regions) EXPECT_GT(found, 100);
}

// A triangle is the sum of its chords from one corner, and along those the distance is convex as well.
static double slow_distance(const Vec3& a0, const Vec3& a1, const Triangle& triangle) {
    const auto over = [&](double u) {
        return slow_distance(a0, a1, triangle.a, triangle.b + u * (triangle.c - triangle.b));
    };
    double best = 1e300;
    for (int i = 0; i <= 60; ++i) best = std::min(best, over(i / 60.0));
    return best;
}

// Every seventh triangle has no area, every ninth no length: a division by its area would answer NaN, and NaN is nearer
// than nothing. A missed piercing or a region of the triangle taken for another is a wall that lets a tool in. The slow
// answer is an upper bound of the distance, at most a chord's spacing too large.
TEST(ClosestPoints, TrianglesAgreeWithASlowSearch) {
    Scene scene(3);
    int pierced = 0;
    for (int i = 0; i < 40; ++i) {
        const Vec3 a0 = scene.point(), along = 2 * scene.side(i + 1, Vec3::UnitY());
        const Vec3 corner = scene.point(), side = scene.side(i + 2, along);
        const Triangle triangle{corner, corner + side, i % 7 ? scene.point() : Vec3(corner + 0.5 * side)};
        // Every third segment is aimed through the middle, and stops just before it or goes on.
        const Vec3 through = (triangle.a + triangle.b + triangle.c) / 3 - a0;
        const Vec3 a1 = a0 + (i % 3 ? along : Vec3((i % 2 ? 0.95 : 1.5) * through));
        const auto pair = closest_points(a0, a1, triangle);
        const double slow = slow_distance(a0, a1, triangle), spacing = (triangle.c - triangle.b).norm() / 60;
        EXPECT_LE(length_of(pair), slow + search_rounding) << i;
        EXPECT_GE(length_of(pair), slow - spacing) << i;
        EXPECT_LT((pair.on_a - a0 - pair.s * (a1 - a0)).norm(), 1e-15) << i;
        EXPECT_LT(slow_distance(pair.on_b, pair.on_b, triangle), spacing + search_rounding) << i;
        pierced += pair.distance_squared < 1e-20;
    }
    EXPECT_GT(pierced, 5);
}
