#include <gtest/gtest.h>

#include "tests/tissue/sewn.hpp"

namespace {

using namespace tissue;
using namespace tissue::sewn;

double perimeter(double radius) {
    return 16 * 2 * radius * std::sqrt(2 * pi / 16 / std::sin(2 * pi / 16)) * std::sin(pi / 16);
}  // of the tube's polygon

// Sixteen sides instead of a circle: the cut's area is the ring's, its rims are longer.
double ring_wall(const TubeDef& def) {
    return pi * (def.diameter - def.wall) * def.wall /
           (0.5 * (perimeter(def.diameter / 2) + perimeter(def.diameter / 2 - def.wall)));
}

TEST(Join, OfEndsPressedFlatIsTight) {
    const Join join = Operation{}.judge();
    EXPECT_NEAR(join.wall, ring_wall({}), 1e-12);
    EXPECT_NEAR(join.rim, perimeter(2 * mm), 1e-12);
    double width = 0;
    for (const LinePiece& piece : join.line) {
        EXPECT_LE(piece.gap, 1e-15);
        EXPECT_LE(piece.overlap, 1e-15);
        width += piece.width;
    }
    EXPECT_NEAR(width, 0.5 * (perimeter(2 * mm) + perimeter(1.5 * mm)), 1e-12);
    EXPECT_LE(in_ml_per_min(join.leak()), 1e-12);
    EXPECT_NEAR(join.lumen_ratio, 1, 1e-9);
    EXPECT_TRUE(join.bites.empty());
}

// Apart all round: the slit's closed form for the ring's mean length.
TEST(Join, LeaksAsASlitRoundTheRing) {
    for (const double gap : {0.02 * mm, 0.1 * mm, 0.3 * mm}) {
        Operation operation;
        operation.move([&](int vessel, const Vec3& p) { return Vec3(p + vessel * gap * Vec3::UnitX()); });
        const Join join = operation.judge();
        const double expected = leak_of_slit(gap, 0.5 * (perimeter(2 * mm) + perimeter(1.5 * mm)), ring_wall({}));
        EXPECT_NEAR(join.leak(), expected, 1e-9 * expected);
        for (const LinePiece& piece : join.line) EXPECT_NEAR(piece.gap, gap, 1e-12);
        EXPECT_NEAR(join.lumen_ratio, 1, 1e-9);
    }
}

// Cut at 60 degrees: the slit is as wide as the cuts' planes are apart, and longer.
TEST(Join, OfSlantedCuts) {
    Operation operation({.cut_angle = 60});
    EXPECT_LE(in_ml_per_min(operation.judge().leak()), 1e-12);
    EXPECT_NEAR(operation.judge().lumen_ratio, 1, 1e-9);
    operation.move([](int vessel, const Vec3& p) { return Vec3(p + vessel * 0.1 * mm * Vec3::UnitX()); });
    const Join join = operation.judge();
    const double gap = 0.1 * mm * std::sin(60 * degree);
    double width = 0;
    for (const LinePiece& piece : join.line) {
        EXPECT_NEAR(piece.gap, gap, 1e-12);
        width += piece.width;
    }
    EXPECT_NEAR(join.leak(), leak_of_slit(gap, width, join.wall), 1e-9 * join.leak());
    EXPECT_GT(join.rim, perimeter(2 * mm));
    EXPECT_EQ(committed(join), "");
}

// What a solver leaves of one wall in the other is no gap.
TEST(Join, IsTightWhereWallsAreInEachOther) {
    Operation operation;
    operation.move([](int vessel, const Vec3& p) { return Vec3(p - vessel * 0.05 * mm * Vec3::UnitX()); });
    EXPECT_LE(in_ml_per_min(operation.judge().leak()), 1e-12);
    EXPECT_EQ(committed(operation.judge()), "");
}

TEST(Join, MeasuresACleanOne) {
    Operation operation;
    operation.stitches();
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "");
    ASSERT_EQ(join.bites.size(), 16u);
    ASSERT_EQ(join.stitches.size(), 8u);
    for (const SewnBite& bite : join.bites) {
        EXPECT_NEAR(bite.size, 1 * mm, 1e-9);
        EXPECT_NEAR(bite.through, 0.5 * mm, 0.02 * mm);  // corners of the polygon are further out
        EXPECT_NEAR(bite.inside, 1 * mm, 1e-9);
        EXPECT_NEAR(bite.strain, 0, 1e-9);
        EXPECT_NEAR(bite.hole, 2 * hole, 1e-12);
        EXPECT_FALSE(bite.partial);
    }
    for (const Stitch& stitch : join.stitches) {
        EXPECT_NEAR(stitch.arc, 0, 1e-9);
        EXPECT_NEAR(stitch.obliqueness, 0, 1e-9);
        EXPECT_NEAR(stitch.loop, 1, 1e-6);
    }
    for (const auto& spacing : join.spacing)
        for (const double s : spacing) EXPECT_NEAR(s, join.rim / 8, 1e-9);
    EXPECT_EQ(join.thread_in_lumen, 0);
    EXPECT_LE(join.leak_of_line, 1e-15);
    double expected = 0;
    for (const SewnBite& bite : join.bites)
        expected += leak_of_slit(hole - diameter / 2, pi * (hole + diameter / 2), bite.through);
    EXPECT_NEAR(join.leak_of_holes, expected, 1e-12 * expected);
}

// Ends with a thread of its own in each, or one that was cut between them, met in their clamps and were judged as if
// they were sewn.
TEST(Join, IsSewnByAThreadThroughBothEnds) {
    Operation operation;
    operation.begin();
    operation.bite(0, {0}, Side::outer, Side::inner, 1);
    operation.begin();
    operation.bite(1, {0}, Side::inner, Side::outer, 2);
    EXPECT_FALSE(operation.judge().is_sewn());
    operation.stitch({90}, {90});
    EXPECT_TRUE(operation.judge().is_sewn());
}

// A half circle of 1.5 mm drawn through both walls, which hold still, instead of bites by hand; the thread is tightened
// so far that it lies on the inside.
TEST(Join, KnowsTheBitesOfANeedle) {
    Operation operation;
    constexpr double radius = 1.5 * mm, bite = 1.25 * mm, needle = 2.356;
    const Vec3 up = operation.outwards(0), along = Vec3::UnitX();
    const double side = perimeter(2 * mm) / 32 / std::tan(pi / 16);  // of the tube, from its axis
    const Vec3 centre = (side + std::sqrt(radius * radius - bite * bite)) * up;
    const auto out = [&](double turn) { return Vec3(-std::cos(turn) * along - std::sin(turn) * up); };
    std::array<Bites, 2> bites{Bites({}, operation.rest[0]), Bites({}, operation.rest[1])};
    for (double turn = 0; turn < pi + needle; turn += 0.01) {
        const Arc arc{.centre = centre,
                      .to_tail = out(turn - needle),
                      .onwards = out(turn - needle + pi / 2),
                      .radius = radius,
                      .angle = needle};
        for (const std::size_t v : {0, 1}) bites[v].press(&arc, operation.skin[v]), bites[v].settle(operation.skin[v]);
    }
    std::vector<Vec3> thread;
    for (double turn = 0; turn < pi; turn += 0.02) {
        const Vec3 at = centre + radius * out(turn);
        if (at.dot(up) > 0.75 * side) thread.push_back(at);
    }
    const auto vessel = [&](std::size_t v) {
        return SewnVessel{operation.rest[v], operation.skin[v], bites[v].bites()};
    };
    const Join join = judge(vessel(0), vessel(1), {{thread}}, diameter);
    ASSERT_EQ(join.bites.size(), 2u);
    ASSERT_EQ(join.stitches.size(), 1u);
    for (const SewnBite& sewn : join.bites) {
        EXPECT_EQ(sewn.thread, 0);
        EXPECT_FALSE(sewn.partial);
        EXPECT_NEAR(sewn.size, bite, 0.05 * mm);  // the tip goes in so deep before the skin gives way
        EXPECT_NEAR(sewn.inside, std::sqrt(radius * radius - std::pow(centre.norm() - 0.75 * side, 2)), 0.05 * mm);
    }
    EXPECT_NEAR(join.stitches[0].obliqueness, 0, 1e-9);
    EXPECT_NEAR(join.stitches[0].loop, 1, 0.02);  // the arc in the wall over its chord
    EXPECT_EQ(committed(join), "");
    // Where a rim was drawn out thread lies off its middle; beyond that it is in no hole.
    const double reach = 2 * operation.skin[0].radius(0) + diameter;
    for (const auto& [aside, number] : {std::pair(0.95 * reach, 0), {1.2 * reach, -1}}) {
        std::vector<Vec3> moved = thread;
        for (Vec3& node : moved) node += aside * up.cross(along);
        for (const SewnBite& sewn : judge(vessel(0), vessel(1), {{moved}}, diameter).bites)
            EXPECT_EQ(sewn.thread, number) << aside;
    }
}

// Turned in space, and the other vessel named first.
TEST(Join, DoesNotDependOnTheFrame) {
    const Quat turn = Quat(0.3, -0.5, 0.7, 0.1).normalized();
    const auto moved = [&](const Vec3& p) { return Vec3(turn * p + Vec3(0.1, -0.05, 0.2)); };
    Operation operation;
    operation.stitches(1);
    operation.stitch({10, 1.2 * mm}, {4, 0.9 * mm});
    operation.move([](int vessel, const Vec3& p) {
        return Vec3(p.x() * (1 - 30 * p.y()) + vessel * 0.05 * mm, 0.9 * p.y(), p.z());
    });
    const Join here = operation.judge();
    Operation other = operation;
    for (Mesh& mesh : other.rest)
        for (Vec3& node : mesh.nodes) node = moved(node);
    for (std::size_t v : {0, 1}) {
        std::vector<Vec3> nodes(other.skin[v].nodes().begin(), other.skin[v].nodes().end());
        for (Vec3& node : nodes) node = moved(node);
        other.skin[v].update(nodes);
    }
    auto threads = operation.threads();
    for (auto& thread : threads)
        for (Vec3& node : thread) node = moved(node);
    const auto vessel = [&](std::size_t v) {
        return SewnVessel{other.rest[v], other.skin[v], other.bites[v], -(turn * Vec3::UnitX())};
    };
    const auto expect_same = [&](const Join& there, double share) {
        const auto a = lapses(here), b = lapses(there);
        for (std::size_t i = 0; i < 10; ++i)
            EXPECT_NEAR(a[i].value, b[i].value, share * std::max(1.0, a[i].value)) << a[i].name;
        EXPECT_NEAR(here.leak(), there.leak(), share * here.leak());
        EXPECT_NEAR(here.lumen_ratio, there.lumen_ratio, share);
    };
    expect_same(judge(vessel(0), vessel(1), threads, diameter), 1e-6);
    expect_same(judge(vessel(1), vessel(0), threads, diameter), 1e-3);  // pieces of the line lie elsewhere
}

// Without its thread every hole is open, and no stitch is one.
TEST(Join, LeaksThroughHolesThatAreLeft) {
    Operation operation;
    operation.stitches();
    operation.led.clear();
    const Join join = operation.judge();
    EXPECT_TRUE(join.stitches.empty());
    EXPECT_NEAR(join.leak_of_holes, 16 * leak_of_hole(pi * hole * hole), 1e-12 * join.leak_of_holes);
    operation.bites[0][3].state = BiteState::empty;  // the needle went back by the way it came
    EXPECT_NEAR(operation.judge().leak_of_holes, join.leak_of_holes, 1e-12 * join.leak_of_holes);
}

// One thread all the way round, from stitch to stitch outside.
TEST(Join, FollowsARunningSuture) {
    Operation operation;
    operation.begin();
    for (int k = 0; k < 8; ++k) {
        operation.bite(0, {45.0 * k}, Side::outer, Side::inner, k);
        operation.bite(1, {45.0 * k}, Side::inner, Side::outer, k);
        const double next = 45.0 * k + 22.5;
        operation.led.back().push_back({0, -1, 2.4 * mm * operation.outwards(next)});
    }
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "");
    ASSERT_EQ(join.stitches.size(), 8u);
    for (int k = 0; k < 8; ++k)
        for (const int b : join.stitches[static_cast<std::size_t>(k)].bites)
            EXPECT_EQ(join.bites[static_cast<std::size_t>(b)].bite, k);
}

TEST(Join, NeedsACut) {
    const Mesh box = make_box({2, 2, 2}, mm), tube = make_tube({});
    const Skin of_box(box), of_tube(tube);
    EXPECT_THROW(judge({tube, of_tube, {}}, {box, of_box, {}}, {}, diameter), std::invalid_argument);
}

}  // namespace
