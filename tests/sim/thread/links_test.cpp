#include <gtest/gtest.h>

#include <numeric>

#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/resample.hpp"
#include "sim/knot/namer.hpp"
#include "tests/sim/thread/scene.hpp"

namespace {

using namespace scene;

constexpr double long_link = 16 * radius;  // eight diameters

double distance_to(const Vec3& p, std::span<const Vec3> nodes) {
    double least2 = 1e300;
    for (std::size_t i = 1; i < nodes.size(); ++i)
        least2 = std::min(least2, sim::geometry::closest_points(p, p, nodes[i - 1], nodes[i]).distance_squared);
    return std::sqrt(least2);
}

std::vector<Vec3> copy_of(const Thread& thread) {
    return {thread.nodes().begin(), thread.nodes().end()};
}

double length(const Thread& thread) {
    return std::accumulate(thread.rest_lengths().begin(), thread.rest_lengths().end(), 0.0);
}

// An overhand as loose as in a rope that is as thick as these links are long.
Thread long_links(double shortest) {
    return {{.shortest_link = shortest}, overhand(60, 0.5 * long_link)};
}

// A link that is changed must not carry the thread anywhere, or through anything; neither may length be lost.
TEST(Links, ChangingThemMovesNeitherTheThreadNorWhatIsHeld) {
    Thread thread = long_links(2 * radius);
    const double whole = length(thread);
    const std::string knot = sim::knot::name_knot(copy_of(thread)).knot;
    bench::lab::Apart pull(thread);
    std::size_t most = 0;
    int changes = 0;
    for (int i = 0; i < 1000; ++i) {
        const std::vector<Vec3> before = copy_of(thread);
        const std::vector<Vec3> held{thread.nodes()[static_cast<std::size_t>(pull.hands.hands[0].node)],
                                     thread.nodes()[static_cast<std::size_t>(pull.hands.hands[1].node)]};
        if (pull.hands.fit_links(thread)) {
            ++changes;
            for (const Vec3& p : before) ASSERT_LE(distance_to(p, thread.nodes()), 0.1 * radius) << i;
            for (std::size_t h = 0; h < 2; ++h)
                ASSERT_EQ(thread.nodes()[static_cast<std::size_t>(pull.hands.hands[h].node)], held[h]) << i;
        }
        ASSERT_EQ(pull.by(thread, 0.05e-3).pass_throughs, 0) << i;
        ASSERT_NEAR(length(thread), whole, 1e-12 * whole) << i;  // rounding of a thousand sums
        most = std::max(most, thread.rest_lengths().size());
    }
    EXPECT_GT(changes, 10);
    EXPECT_GT(most, 70u);   // 60 at first; a knot of ten diameters takes as many
    EXPECT_LT(most, 240u);  // half of what short links everywhere would be
    EXPECT_EQ(sim::knot::name_knot(copy_of(thread)).knot, knot);
}

// The point of it all: the knot comes out as tight as short links make it, not as long ones do.
TEST(Links, AKnotPulledTightHasShortOnes) {
    Thread fitted = long_links(2 * radius), unfitted = long_links(0);
    for (Thread* thread : {&fitted, &unfitted}) {
        bench::lab::Apart pull(*thread);
        bench::lab::tighten(*thread, pull, 0.05, 4000);
    }
    EXPECT_LT(taken_up(fitted), 0.6 * taken_up(unfitted));
    EXPECT_EQ(unfitted.rest_lengths().size(), 60u);
    for (const double link : fitted.rest_lengths()) {
        EXPECT_GE(link, 2 * radius / std::sqrt(2.0) * 0.999);
        EXPECT_LE(link, 1.002 * long_link);
    }
}

// A bend that went by leaves the thread as coarse as it was: else every session ends in short links everywhere.
TEST(Links, WhatIsPulledStraightHasLongOnesAgain) {
    std::vector<Vec3> bent;
    constexpr double bend = 10 * radius;
    for (int i = 0; i <= 30; ++i) bent.emplace_back(-long_link * (30 - i), 0, 0);
    for (int i = 1; i <= 8; ++i) bent.emplace_back(bend * std::sin(i * 0.35), 0, bend * (1 - std::cos(i * 0.35)));
    const Vec3 on = (bent.back() - bent[bent.size() - 2]).normalized();
    for (int i = 1; i <= 30; ++i) bent.push_back(bent[38] + i * long_link * on);
    Thread thread({.shortest_link = 2 * radius}, sim::geometry::resample(bent, 64));
    bench::lab::Hands hands(thread);
    for (int i = 0; i < 3; ++i) hands.fit_links(thread);
    const std::size_t when_bent = thread.rest_lengths().size();
    bench::lab::Apart pull(thread);
    for (int i = 0; i < 3000; ++i) pull.by(thread, 0.05e-3);
    EXPECT_GT(when_bent, 68u);
    EXPECT_LE(thread.rest_lengths().size(), 67u);  // a half may be left over on either side
}

TEST(Links, StayAsTheyAreUnlessAsked) {
    Thread thread({}, overhand());
    int held[] = {0, 200};
    EXPECT_FALSE(thread.fit_links(held));
    EXPECT_EQ(thread.rest_lengths().size(), 200u);
}

}  // namespace
