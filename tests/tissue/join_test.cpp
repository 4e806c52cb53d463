#include "tissue/join.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tissue/lapse.hpp"
#include "tissue/tube.hpp"

namespace {

using namespace tissue;
using sim::geometry::Quat;

constexpr double pi = std::numbers::pi, degree = pi / 180, mm = 1e-3;
constexpr double diameter = 0.085 * mm, hole = 0.055 * mm;  // of 6-0 thread, and radius of what it runs in

Mesh turned_about(Mesh mesh) {
    for (Vec3& node : mesh.nodes) node = {-node.x(), -node.y(), node.z()};
    return mesh;
}

// Where a stitch goes through a wall: round the ring [degrees], how far from the cut [m].
struct Place {
    double angle, from_cut = 1 * mm;
};

// Two vessels of 4 mm end to end along x, vessel 0 where x < 0, and what was sewn by hand.
struct Operation {
    explicit Operation(const TubeDef& tube = {}) : def(tube) {}
    TubeDef def;
    std::array<Mesh, 2> rest{turned_about(make_tube(def)), make_tube(def)};
    std::array<Skin, 2> skin{Skin(rest[0]), Skin(rest[1])};
    std::array<std::vector<Bite>, 2> bites;
    std::array<std::vector<bool>, 2> torn;
    struct Waypoint {
        int vessel, hole;              // no hole: -1
        Vec3 at = Vec3::Zero();
    };
    std::vector<std::vector<Waypoint>> led;

    // Counted from the middle of one of the tube's sixteen sides.
    Vec3 outwards(double angle) const { return {0, std::cos((angle + 11.25) * degree), std::sin((angle + 11.25) * degree)}; }

    // On a side of a wall; in the cut halfway through.
    BiteEnd pierce(int vessel, const Place& place, Side side) {
        const auto v = static_cast<std::size_t>(vessel);
        const double radius = side == Side::outer ? def.diameter / 2 : side == Side::inner ? def.diameter / 2 - def.wall : (def.diameter - def.wall) / 2;
        const double along = (vessel == 0 ? -1 : 1) * (side == Side::cut ? 0 : place.from_cut);
        const Vec3 at = radius * outwards(place.angle) + along * Vec3::UnitX();
        const auto spot = skin[v].closest(at, at, 0.2 * mm);
        const Vec3 normal = skin[v].normal(spot.triangle);
        const int made = skin[v].pierce(skin[v].face(spot.triangle), spot.at, -normal, hole);
        EXPECT_EQ(skin[v].side_of_face(skin[v].face_of_hole(made)), side);
        return {made, skin[v].point_of_hole(made), side, 0};
    }
    Bite& bite(int vessel, const Place& place, Side entry, Side exit, int pass) {
        Bite made;
        made.state = BiteState::open;
        made.entry = pierce(vessel, place, entry), made.exit = pierce(vessel, place, exit);
        made.depth = def.wall, made.pass = pass, made.on_needle = false;
        auto& all = bites[static_cast<std::size_t>(vessel)];
        all.push_back(made);
        led.back().push_back({vessel, made.entry.hole}), led.back().push_back({vessel, made.exit.hole});
        return all.back();
    }
    void begin() { led.emplace_back(); }
    int next_pass() const { return static_cast<int>(led.size()); }
    // From outside through the first wall, and through the second one out.
    void stitch(const Place& first, const Place& second) {
        begin();
        bite(0, first, Side::outer, Side::inner, next_pass());
        bite(1, second, Side::inner, Side::outer, next_pass());
    }
    void stitches(int from = 0, double turned = 0) {
        for (int k = from; k < 8; ++k) stitch({45.0 * k}, {45.0 * k + turned});
    }

    template <class Moved>
    void move(const Moved& moved) {
        for (std::size_t v : {0, 1}) {
            std::vector<Vec3> nodes;
            for (const Vec3& p : rest[v].nodes) nodes.push_back(moved(static_cast<int>(v), p));
            skin[v].update(nodes);
        }
    }

    // Threads as they were led, through the holes' middles, with tails of two millimetres.
    std::vector<std::vector<Vec3>> threads() const {
        std::vector<std::vector<Vec3>> all;
        for (const auto& way : led) {
            std::vector<Vec3> line;
            for (const Waypoint& w : way) line.push_back(w.hole < 0 ? w.at : skin[static_cast<std::size_t>(w.vessel)].centre(w.hole));
            const auto tail = [&](const Vec3& from) { return Vec3(from + 2 * mm * Vec3(0, from.y(), from.z()).normalized()); };
            line.insert(line.begin(), tail(line.front())), line.push_back(tail(line.back()));
            all.push_back(line);
        }
        return all;
    }
    SewnVessel vessel(std::size_t v) const { return {rest[v], skin[v], bites[v], Vec3::UnitX(), torn[v]}; }
    Join judge() const { return tissue::judge(vessel(0), vessel(1), threads(), diameter); }
};

// Which of the ten.
std::string committed(const Join& join, const LapseLimits& limits = {}) {
    std::string names;
    for (const Lapse& lapse : lapses(join, limits)) {
        if (lapse.committed) names += std::string(names.empty() ? "" : ", ") + lapse.name;
    }
    return names;
}

double perimeter(double radius) { return 16 * 2 * radius * std::sqrt(2 * pi / 16 / std::sin(2 * pi / 16)) * std::sin(pi / 16); }  // of the tube's polygon

// Sixteen sides instead of a circle: the cut's area is the ring's, its rims are longer.
double ring_wall(const TubeDef& def) {
    return pi * (def.diameter - def.wall) * def.wall / (0.5 * (perimeter(def.diameter / 2) + perimeter(def.diameter / 2 - def.wall)));
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
        EXPECT_NEAR(bite.through, 0.5 * mm, 0.02 * mm);   // corners of the polygon are further out
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
    for (const SewnBite& bite : join.bites) expected += leak_of_slit(hole - diameter / 2, pi * (hole + diameter / 2), bite.through);
    EXPECT_NEAR(join.leak_of_holes, expected, 1e-12 * expected);
}

// A half circle of 1.5 mm drawn through both walls, which hold still, instead of bites by hand; the thread is tightened so far that it lies on the inside.
TEST(Join, KnowsTheBitesOfANeedle) {
    Operation operation;
    constexpr double radius = 1.5 * mm, bite = 1.25 * mm, needle = 2.356;
    const Vec3 up = operation.outwards(0), along = Vec3::UnitX();
    const double side = perimeter(2 * mm) / 32 / std::tan(pi / 16);  // of the tube, from its axis
    const Vec3 centre = (side + std::sqrt(radius * radius - bite * bite)) * up;
    const auto out = [&](double turn) { return Vec3(-std::cos(turn) * along - std::sin(turn) * up); };
    std::array<Bites, 2> bites{Bites({}, operation.rest[0]), Bites({}, operation.rest[1])};
    for (double turn = 0; turn < pi + needle; turn += 0.01) {
        const Arc arc{.centre = centre, .to_tail = out(turn - needle), .onwards = out(turn - needle + pi / 2), .radius = radius, .angle = needle};
        for (const std::size_t v : {0, 1}) bites[v].press(&arc, operation.skin[v]), bites[v].settle(operation.skin[v]);
    }
    std::vector<Vec3> thread;
    for (double turn = 0; turn < pi; turn += 0.02) {
        const Vec3 at = centre + radius * out(turn);
        if (at.dot(up) > 0.75 * side) thread.push_back(at);
    }
    const auto vessel = [&](std::size_t v) { return SewnVessel{operation.rest[v], operation.skin[v], bites[v].bites()}; };
    const Join join = judge(vessel(0), vessel(1), {{thread}}, diameter);
    ASSERT_EQ(join.bites.size(), 2u);
    ASSERT_EQ(join.stitches.size(), 1u);
    for (const SewnBite& sewn : join.bites) {
        EXPECT_EQ(sewn.thread, 0);
        EXPECT_FALSE(sewn.partial);
        EXPECT_NEAR(sewn.size, bite, 0.05 * mm);                  // the tip goes in so deep before the skin gives way
        EXPECT_NEAR(sewn.inside, std::sqrt(radius * radius - std::pow(centre.norm() - 0.75 * side, 2)), 0.05 * mm);
    }
    EXPECT_NEAR(join.stitches[0].obliqueness, 0, 1e-9);
    EXPECT_NEAR(join.stitches[0].loop, 1, 0.02);                  // the arc in the wall over its chord
    EXPECT_EQ(committed(join), "");
}

// Turned in space, and the other vessel named first.
TEST(Join, DoesNotDependOnTheFrame) {
    const Quat turn = Quat(0.3, -0.5, 0.7, 0.1).normalized();
    const auto moved = [&](const Vec3& p) { return Vec3(turn * p + Vec3(0.1, -0.05, 0.2)); };
    Operation operation;
    operation.stitches(1);
    operation.stitch({10, 1.2 * mm}, {4, 0.9 * mm});
    operation.move([](int vessel, const Vec3& p) { return Vec3(p.x() * (1 - 30 * p.y()) + vessel * 0.05 * mm, 0.9 * p.y(), p.z()); });
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
    const auto vessel = [&](std::size_t v) { return SewnVessel{other.rest[v], other.skin[v], other.bites[v], -(turn * Vec3::UnitX()), {}}; };
    const auto expect_same = [&](const Join& there, double share) {
        const auto a = lapses(here), b = lapses(there);
        for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(a[i].value, b[i].value, share * std::max(1.0, a[i].value)) << a[i].name;
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
        for (const int b : join.stitches[static_cast<std::size_t>(k)].bites) EXPECT_EQ(join.bites[static_cast<std::size_t>(b)].bite, k);
}

// A quarter of the ring stands two tenths of a millimetre off.
TEST(Lapses, Disruption) {
    Operation operation;
    operation.stitches();
    operation.move([](int vessel, const Vec3& p) {
        const double angle = std::abs(std::atan2(p.z(), p.y()));
        return Vec3(p + (vessel == 1 && angle < 50 * degree ? 0.2 * mm : 0) * Vec3::UnitX());
    });
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "disruption of suture line");
    EXPECT_GT(lapses(join)[0].value, 2);
    EXPECT_EQ(committed(join, {.gap = 0.5}), "");
    EXPECT_EQ(committed(join, {.open_spacings = 4}), "");
}

// The needle took the wall across on its way, and the thread has drawn it near: the lumen is flat.
TEST(Lapses, BackWall) {
    Operation operation;
    operation.stitches(1);
    operation.begin();
    const int pass = operation.next_pass();
    operation.bite(0, {0}, Side::outer, Side::inner, pass).both_walls = true;
    operation.bite(0, {180, 0.8 * mm}, Side::inner, Side::inner, pass).both_walls = true;
    operation.bite(1, {0}, Side::inner, Side::outer, pass);
    operation.move([](int, const Vec3& p) {
        const double radius = std::hypot(p.y(), p.z()), lumen = 1.5 * mm;
        return Vec3(p.x(), p.y() * (1 - 0.98 * lumen / radius), p.z());
    });
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "back-wall stitch");
    EXPECT_NEAR(lapses(join)[1].value, 180, 1e-6);
    EXPECT_LT(join.lumen_ratio, 0.05);
    EXPECT_EQ(join.stitches.size(), 8u);
}

// From the front of one ring to the back of the other.
TEST(Lapses, StitchAcrossTheLumen) {
    Operation operation;
    operation.stitches(0, 180);
    EXPECT_NEAR(lapses(operation.judge())[1].value, 180, 1e-6);
    EXPECT_TRUE(lapses(operation.judge())[1].committed);
    EXPECT_FALSE(lapses(operation.judge())[2].committed);
}

TEST(Lapses, Oblique) {
    Operation operation;
    operation.stitches(0, 20);
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "oblique stitch");
    EXPECT_NEAR(lapses(join)[2].value, std::atan(2 * mm * 20 * degree / (2 * mm)) / degree, 0.5);  // sixteen sides are not quite a circle
    EXPECT_EQ(committed(join, {.obliqueness = 20}), "");
}

TEST(Lapses, WideBite) {
    Operation operation;
    operation.stitches(1);
    operation.stitch({0, 1.8 * mm}, {0});
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "wide bite");
    EXPECT_NEAR(lapses(join)[3].value, 1.8 * mm / join.wall, 1e-6);
    EXPECT_EQ(committed(join, {.bite_walls = 4}), "wide bite");  // 1.8 medians
    EXPECT_EQ(committed(join, {.bite_walls = 4, .bite_medians = 2}), "");
}

// Out by the cut instead of the lumen; in and out by the outer side.
TEST(Lapses, PartialThickness) {
    Operation by_cut;
    by_cut.stitches(1);
    by_cut.begin();
    by_cut.bite(0, {0}, Side::outer, Side::cut, by_cut.next_pass());
    by_cut.bite(1, {0}, Side::inner, Side::outer, by_cut.next_pass());
    EXPECT_EQ(committed(by_cut.judge()), "partial-thickness stitch");

    Operation outside;
    outside.stitches(1);
    outside.begin();
    Bite shallow;
    shallow.state = BiteState::open, shallow.on_needle = false, shallow.pass = outside.next_pass();
    shallow.entry = outside.pierce(0, {0}, Side::outer), shallow.exit = outside.pierce(0, {0, 0.4 * mm}, Side::outer);
    outside.bites[0].push_back(shallow);
    outside.led.back() = {{0, shallow.entry.hole}, {0, shallow.exit.hole}};
    outside.bite(1, {0}, Side::inner, Side::outer, outside.next_pass());
    const Join join = outside.judge();
    EXPECT_EQ(committed(join), "partial-thickness stitch");
    EXPECT_EQ(lapses(join)[4].value, 1);
    EXPECT_EQ(join.stitches.size(), 8u);
    EXPECT_EQ(committed(join, {.partial_bites = 1}), "");
}

TEST(Lapses, UnequalSpacing) {
    Operation operation;
    operation.stitches(1);
    operation.stitch({22}, {22});
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "unequal spacing");
    EXPECT_NEAR(lapses(join)[5].value, 23.0 / 45, 0.01);
    EXPECT_EQ(committed(join, {.least_spacing = 0.5, .most_spacing = 1.5, .spacing_variation = 0.25}), "");
}

// The wall about a stitch is drawn out along the ring; or it gave way to the edge.
TEST(Lapses, Tear) {
    Operation drawn;
    drawn.stitches();
    drawn.move([](int, const Vec3& p) { return Vec3(p.x(), 1.8 * p.y(), 1.8 * p.z()); });
    EXPECT_EQ(committed(drawn.judge()), "tear");
    EXPECT_NEAR(lapses(drawn.judge())[6].value, 1.8 * 2 * hole / diameter, 1e-9);

    Operation torn;
    torn.stitches();
    torn.torn[1] = {false, false, true};
    EXPECT_EQ(committed(torn.judge()), "tear");
    EXPECT_EQ(lapses(torn.judge())[6].value, 1);
}

// The edges are pressed together along the axis; or the loop is too short for what it holds.
TEST(Lapses, Strangulation) {
    Operation pressed;
    pressed.stitches();
    pressed.move([](int, const Vec3& p) { return Vec3(0.65 * p.x(), p.y(), p.z()); });
    EXPECT_EQ(committed(pressed.judge()), "strangulation");
    EXPECT_NEAR(lapses(pressed.judge())[7].value, 0.35, 1e-9);
    EXPECT_EQ(committed(pressed.judge(), {.edge_strain = 0.4, .least_loop = 0.7}), "");

    const LapseLimits loop_alone{.edge_strain = 0.4};
    EXPECT_EQ(committed(pressed.judge(), loop_alone), "strangulation");
    EXPECT_NEAR(lapses(pressed.judge(), loop_alone)[7].value, (1 + 0.65 * 2) / 3, 0.01);
}

TEST(Lapses, ThreadInLumen) {
    Operation operation;
    operation.stitches();
    auto& way = operation.led[3];                          // a slack loop half a millimetre high over the join
    const Vec3 in = -operation.outwards(45.0 * 3), over = 1.5 * mm * operation.outwards(45.0 * 3) + 0.5 * mm * in;
    way.insert(way.begin() + 2, {{0, -1, over - 0.5 * mm * Vec3::UnitX()}, {0, -1, over + 0.5 * mm * Vec3::UnitX()}});
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "thread in lumen");
    EXPECT_NEAR(join.deepest_thread, 0.5 * mm, 0.02 * mm);
    const double slanted = std::sqrt(0.5) * mm * (0.5 - 0.085) / 0.5;
    EXPECT_NEAR(join.thread_in_lumen, 1 * mm + 2 * slanted, 0.1 * mm);
    EXPECT_EQ(committed(join, {.depth_diameters = 7}), "");
}

// One end is in the other by six tenths of a millimetre, as slender as that takes; the threads lie along both.
TEST(Lapses, Overlap) {
    Operation operation;
    operation.stitches();
    for (int k = 0; k < 8; ++k) {
        auto& way = operation.led[static_cast<std::size_t>(k)];
        const Vec3 out = operation.outwards(45.0 * k);
        way.insert(way.begin() + 2, {{0, -1, 1.48 * mm * out - 0.63 * mm * Vec3::UnitX()}, {0, -1, 1.08 * mm * out - 0.62 * mm * Vec3::UnitX()}});
    }
    operation.move([](int vessel, const Vec3& p) { return vessel == 0 ? p : Vec3(p.x() - 0.6 * mm, 0.73 * p.y(), 0.73 * p.z()); });
    const Join join = operation.judge();
    EXPECT_EQ(committed(join), "overlap");
    EXPECT_NEAR(lapses(join)[9].value, 0.6 * mm / join.wall, 0.01);  // next to holes, which keep their width, skin is not quite where the wall is
    EXPECT_NEAR(join.lumen_ratio, 0.73 * 0.73, 1e-6);
    EXPECT_EQ(committed(join, {.overlap_walls = 1.5}), "");
}

// All ten have names and numbers when nothing was sewn at all, or nothing but one stitch.
TEST(Lapses, NeedNoStitch) {
    Operation none;
    none.move([](int vessel, const Vec3& p) { return Vec3(p + vessel * 1 * mm * Vec3::UnitX()); });
    EXPECT_EQ(committed(none.judge()), "disruption of suture line");
    Operation one;
    one.stitch({0}, {0});
    for (const Lapse& lapse : lapses(one.judge())) EXPECT_TRUE(std::isfinite(lapse.value)) << lapse.name;
    EXPECT_EQ(committed(one.judge()), "");
}

TEST(Join, NeedsACut) {
    const Mesh box = make_box({2, 2, 2}, mm), tube = make_tube({});
    const Skin of_box(box), of_tube(tube);
    EXPECT_THROW(judge({tube, of_tube, {}}, {box, of_box, {}}, {}, diameter), std::invalid_argument);
}

}  // namespace
