#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/knot/namer.hpp"
#include "sim/thread/thread.hpp"
#include "tests/bench/lab/bends.hpp"
#include "tests/bench/lab/crossing.hpp"
#include "tests/bench/lab/incline.hpp"
#include "tests/bench/lab/shape.hpp"

namespace elastic_thread {

using namespace sim::thread;

constexpr double radius = ThreadDef{}.radius, thickness = 2 * radius, tick = 1e-3;

ThreadDef elastic(double friction) {
    ThreadDef def{.friction = friction, .friction_tool = friction};
    def.elastic = {.axial_over_bending = 0};
    return def;
}

// Two hands, each at the last two nodes of an end, that take them apart along x.
struct Pulled {
    explicit Pulled(const ThreadDef& def, const std::vector<Vec3>& start)
        : thread(def, start), last(static_cast<int>(start.size()) - 1) {}

    TickReport by(double way) {
        const std::span<const Vec3> x = thread.nodes();
        const Vec3 step = way * Vec3::UnitX();
        const auto n = static_cast<std::size_t>(last);
        const Hold holds[] = {{0, x[0] - step}, {1, x[1] - step}, {last - 1, x[n - 1] + step}, {last, x[n] + step}};
        constexpr int owners[] = {0, 0, 1, 1};
        return thread.tick({holds, owners, {}, nullptr, tick});
    }

    Thread thread;
    int last;
};

std::vector<Vec3> loose_overhand(double scale = 1, double mirror = 1) {
    std::vector<Vec3> nodes = bench::lab::overhand(120, 120 * thickness);
    for (Vec3& p : nodes) p = scale * Vec3(p.x(), p.y(), mirror * p.z());
    return nodes;
}

// An overhand pulled until it is tight: never through itself, by no more than strands give, still an overhand.
TEST(Elastic, OverhandTightensAndStaysOne) {
    for (const double friction : {0.0, 0.2}) {
        SCOPED_TRACE(friction);
        Pulled rope(elastic(friction), loose_overhand());
        const std::string knot = sim::knot::name_knot({rope.thread.nodes().begin(), rope.thread.nodes().end()}).knot;
        double pulled_hardest = 0;
        for (int t = 0; t < 3000 && pulled_hardest < 1; ++t) {
            const TickReport report = rope.by(0.02 * thickness);
            ASSERT_EQ(report.pass_throughs, 0) << t;
            ASSERT_LE(report.step_over_bound, 1) << t;
            if (t >= 200) {  // it springs into its shape first
                ASSERT_GT(report.separation_min, 0.95) << t;
            }
            pulled_hardest = *std::max_element(rope.thread.tension().begin(), rope.thread.tension().end());
        }
        EXPECT_GE(pulled_hardest, 1) << "N";
        EXPECT_EQ(sim::knot::name_knot({rope.thread.nodes().begin(), rope.thread.nodes().end()}).knot, knot);
    }
}

// The same bits twice; the mirror image of the scene gives the mirror image of the answer, another scale the same
// shape.
TEST(Elastic, TheSameAgainMirroredAndLarger) {
    const auto play = [](double scale, double mirror) {
        ThreadDef def = elastic(0.2);
        def.radius *= scale;
        def.elastic->density = 0;  // inertia has a scale of its own
        Pulled rope(def, loose_overhand(scale, mirror));
        for (int t = 0; t < 100; ++t) rope.by(0.02 * scale * thickness);
        std::vector<Vec3> found;
        for (const Vec3& p : rope.thread.nodes()) found.push_back(Vec3(p.x(), p.y(), mirror * p.z()) / scale);
        return std::pair(found, rope.thread.hash());
    };
    const auto plain = play(1, 1);
    EXPECT_EQ(play(1, 1).second, plain.second);
    const auto apart = [&](const std::vector<Vec3>& other) {
        double most = 0;
        for (std::size_t i = 0; i < other.size(); ++i) most = std::max(most, (other[i] - plain.first[i]).norm());
        return most / thickness;
    };
    EXPECT_EQ(apart(play(1, -1).first), 0);
    EXPECT_EQ(apart(play(1024, 1).first), 0);
}

// What hangs from a hold pulls with its weight, to what one step of Newton's method a tick has left after a second.
TEST(Elastic, HoldCarriesWhatHangs) {
    ThreadDef def = elastic(0);
    def.elastic->gravity = {0, 0, -9.81};
    std::vector<Vec3> nodes;
    for (int i = 0; i <= 60; ++i) nodes.emplace_back(0, 0, -5e-4 * i);
    Thread thread(def, nodes);
    for (int t = 0; t < 1000; ++t) {
        const Hold hold[] = {{0, nodes[0]}};
        constexpr int owner[] = {0};
        thread.tick({hold, owner, {}, nullptr, tick});
    }
    const double weight = 9.81 * def.elastic->mass_per_length() * (60 - 0.5) *
                          5e-4;  // half of the first link hangs on the held node itself
    EXPECT_NEAR(thread.tension().front(), weight, 1e-3 * weight);
}

// What keeps a step of Newton's method solvable where nothing holds a thread must not slow its fall.
TEST(Elastic, FallsAsStonesDo) {
    constexpr double g = 9.81;
    for (const double link : {1.0, 4.0})
        for (const double seconds : {1e-3, 2e-3}) {
            ThreadDef def = elastic(0);
            def.elastic->gravity = {0, 0, -g};
            std::vector<Vec3> nodes;
            for (int i = 0; i <= 10; ++i) nodes.emplace_back(link * thickness * i, 0, 0);
            Thread thread(def, nodes);
            constexpr int ticks = 5;  // to 2.3 D a tick: no thread is let go faster than 3 D a tick
            for (int t = 0; t < ticks; ++t) thread.tick({{}, {}, {}, nullptr, seconds});
            const double fallen = g * seconds * seconds * ticks * (ticks + 1) / 2;  // of implicit Euler
            for (const Vec3& p : thread.nodes()) EXPECT_NEAR(-p.z(), fallen, 1e-4 * fallen) << link << ' ' << seconds;
        }
}

// Air takes the same share of a loose thread's speed in every tick: implicit Euler's of exp(-t / halting time).
TEST(Elastic, AirHaltsItInItsTime) {
    constexpr double speed = 0.02;
    for (const double halting : {0.1, 0.01}) {
        ThreadDef def = elastic(0);
        def.elastic->halting_time = halting;
        std::vector<Vec3> nodes;
        for (int i = 0; i <= 10; ++i) nodes.emplace_back(thickness * i, 0, 0);
        Thread thread(def, nodes);
        std::vector<Vec3> loads(nodes.size(), Vec3::Zero());
        for (std::size_t i = 0; i < nodes.size(); ++i)
            loads[i].z() = def.elastic->mass_per_length() * thickness * (i == 0 || i + 1 == nodes.size() ? 0.5 : 1) *
                           speed / tick * (1 + tick / halting);
        thread.tick({{}, {}, {}, nullptr, tick, loads});
        const double begun = thread.nodes()[5].z();
        EXPECT_NEAR(begun, speed * tick,
                    1e-6 * speed * tick);  // what keeps a free thread solvable is a billionth of its stiffness
        constexpr int ticks = 50;
        for (int t = 0; t < ticks; ++t) thread.tick({{}, {}, {}, nullptr, tick});
        const double kept = 1 / (1 + tick / halting),
                     way = speed * tick * kept * (1 - std::pow(kept, ticks)) / (1 - kept);
        EXPECT_NEAR(thread.nodes()[5].z() - begun, way, 1e-4 * way) << halting;
    }
}

// A tight knot far away, of a piece of its own, is of no concern to one that is drawn tight then: not in one bit.
TEST(Elastic, PiecesThatDoNotTouchAreSolvedApart) {
    const auto play = [](bool with_other) {
        ThreadDef def = elastic(0.2);
        def.elastic->keeps_shape = true;
        std::vector<Vec3> nodes = loose_overhand();
        const int last = static_cast<int>(nodes.size()) - 1;
        std::vector<int> cuts;
        if (with_other) {
            cuts.push_back(last);
            for (const Vec3& p : loose_overhand()) nodes.push_back(p + Vec3(0, 0, 1));
        }
        Thread thread(def, nodes, cuts);
        const int end = static_cast<int>(nodes.size()) - 1;
        constexpr int each = 1000;
        for (int t = 1; t <= 2 * each; ++t) {
            std::vector<Hold> holds;
            std::vector<int> owners;
            const auto pull = [&](int first_node, int last_node, int ticks) {
                const Vec3 way = 0.02 * thickness * ticks * Vec3::UnitX();
                for (const int behind : {0, 1}) {
                    holds.push_back({first_node + behind, nodes[static_cast<std::size_t>(first_node + behind)] - way});
                    holds.push_back({last_node - behind, nodes[static_cast<std::size_t>(last_node - behind)] + way});
                    owners.insert(owners.end(), {0, 1});
                }
            };
            pull(0, last, std::max(0, t - each));
            if (with_other) pull(last + 1, end, std::min(t, each));
            thread.tick({holds, owners, {}, nullptr, tick});
        }
        return std::vector<Vec3>(thread.nodes().begin(), thread.nodes().begin() + last + 1);
    };
    const auto alone = play(false), beside = play(true);
    double most = 0;
    for (std::size_t i = 0; i < alone.size(); ++i) most = std::max(most, (alone[i] - beside[i]).norm());
    EXPECT_EQ(most / thickness, 0);
}

// Coulomb's law for a thread of which every link touches a wall: a fiftieth above what slides it is on its way, a
// fiftieth below it stays.
TEST(Elastic, SlidesDownAnInclineOnlyWhereItMust) {
    for (const double friction : {0.1, 0.3})
        for (const double seconds : {1e-3, 4e-3}) {
            SCOPED_TRACE(testing::Message() << friction << ' ' << seconds);
            EXPECT_LT(std::abs(bench::lab::incline_acceleration(
                                   {.friction = friction, .share = 1.02, .link = 1, .tick = seconds})
                                   .error()),
                      0.01);
            EXPECT_LT(bench::lab::incline_drift({.friction = friction, .share = 0.98, .link = 1, .tick = seconds}, 2),
                      0.1);
        }
}

// Two arms that lie across each other share a load as two beams do, wherever along their links they touch.
TEST(Elastic, LiftsWhatLiesAcrossItAsBeamsDo) {
    for (const bool at_nodes : {true, false}) {
        SCOPED_TRACE(at_nodes);
        const bench::lab::Crossed found = bench::lab::cross({20, at_nodes}, 0.1);
        EXPECT_LT(std::abs(found.lift.error()), 0.01);
        EXPECT_LT(std::abs(found.force.error()), 0.01);
        EXPECT_LT(found.drift, 0.001);
    }
}

// What they are is what they are called, and the tails of a reef may be let go of farther than those of a grief knot.
TEST(Elastic, ReefHoldsWhereGriefSlips) {
    using bench::lab::Bend;
    const Bend reef{"reef", true, false}, thief{"thief", true, true}, granny{"granny", false, false},
        grief{"grief", false, true};
    for (const Bend& bend : {reef, thief})
        EXPECT_EQ(bench::lab::BendThread(bend, thickness, radius).name(), "3_1#m3_1") << bend.words;
    for (const Bend& bend : {granny, grief})
        EXPECT_EQ(bench::lab::BendThread(bend, thickness, radius).name(), "3_1#3_1") << bend.words;
    const bench::lab::BendPull pull{.friction = 0.2, .bending_share = 0.02, .tails = 15};
    EXPECT_GT(bench::lab::let_go(grief, pull).needed, bench::lab::let_go(reef, pull).needed);
}

// Past taut the hands wait: no link is stretched by more than a tenth.
TEST(Elastic, HandsWaitWhenItIsTaut) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= 40; ++i) nodes.emplace_back(thickness * i, 0, 0);
    Pulled rope(elastic(0), nodes);
    TickReport report;
    for (int t = 0; t < 200; ++t) report = rope.by(0.05 * thickness);
    EXPECT_LT(report.fraction, 0.01);
    EXPECT_LT(report.stretch_max, 0.1 * (1 + 1e-9));
    EXPECT_GT(report.stretch_max, 0.09);
}

// Two tools pull a thread as hard as any may and ask for more: they wait, but the free end beyond them gives way when
// it is pushed. A thread that stopped as a whole would be a rod of glass until they let go.
TEST(Elastic, WhatIsBesideATautStrandGivesWay) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= 80; ++i) nodes.emplace_back(thickness * i, 0, 0);
    Thread thread(elastic(0.15), nodes);
    std::vector<Vec3> loads(nodes.size(), Vec3::Zero());
    TickReport report;
    double before = 0;
    for (int t = 1; t <= 300; ++t) {
        const Hold holds[] = {{0, Vec3(-0.05 * thickness * t, 0, 0)},
                              {40, nodes[40] + 0.05 * thickness * t * Vec3::UnitX()}};
        constexpr int owners[] = {0, 1};
        if (t == 200) before = thread.nodes()[80].y(), loads[80].y() = 5e-5;  // [N]
        report = thread.tick({holds, owners, {}, nullptr, tick, loads});
    }
    EXPECT_LT(report.fraction, 0.05) << "the tools must have come to wait";
    EXPECT_LT(report.stretch_max, 0.1 * (1 + 1e-9));
    EXPECT_GT(thread.nodes()[80].y() - before,
              0.5 * thickness);  // a clamped end would by F L^3 / 3 B, one thickness; this one turns too
}

// A thread that keeps its shape is at rest in it, one that does not springs straight.
TEST(Elastic, KeepsTheShapeItWasMadeIn) {
    for (const bool keeps : {true, false}) {
        std::vector<Vec3> arc;
        for (int i = 0; i <= 30; ++i) arc.emplace_back(1e-3 * std::cos(0.1 * i), 1e-3 * std::sin(0.1 * i), 0);
        ThreadDef def = elastic(0);
        def.elastic->keeps_shape = keeps;
        Thread thread(def, arc);
        for (int t = 0; t < 50; ++t) {
            const Hold holds[] = {{0, arc[0]}, {1, arc[1]}};
            constexpr int owners[] = {0, 0};
            thread.tick({holds, owners, {}, nullptr, tick});
        }
        const double moved = (thread.nodes()[30] - arc[30]).norm() / thickness;
        EXPECT_EQ(moved < 1e-6, keeps) << moved;
        EXPECT_EQ(moved > 10, !keeps) << moved;
    }
}

// Links halved where it bends leave it as it is, and its ends where they are held.
TEST(Elastic, HalvesLinksWhereItBends) {
    ThreadDef def = elastic(0.2);
    def.shortest_link = thickness;
    std::vector<Vec3> arc;
    for (int i = 0; i <= 30; ++i) arc.emplace_back(2e-3 * std::cos(0.2 * i), 2e-3 * std::sin(0.2 * i), 1e-4 * i);
    Thread thread(def, arc);
    for (int t = 0; t < 20; ++t) {
        std::array<int, 2> held{0, static_cast<int>(thread.nodes().size()) - 1};
        thread.fit_links(held);
        ASSERT_EQ(thread.nodes()[static_cast<std::size_t>(held[1])], arc.back());
        const Hold holds[] = {{held[0], arc.front()}, {held[1], arc.back()}};
        constexpr int owners[] = {0, 1};
        const TickReport report = thread.tick({holds, owners, {}, nullptr, tick});
        ASSERT_LT(report.stretch_max, 0.01) << t;
    }
    EXPECT_GT(thread.nodes().size(), arc.size());
}

// A bar led into a slack thread faster than the thread is thick a tick pushes it on and never comes out behind it.
TEST(Elastic, AToolPushesItOn) {
    std::vector<Vec3> arc;
    for (int i = 0; i <= 60; ++i)
        arc.emplace_back(2e-4 * (i - 30), 0, 1e-3 * std::cos(std::numbers::pi * (i - 30) / 60));
    Thread thread(elastic(0.2), arc);
    constexpr double step = 3e-4, bar = 0.5e-3;
    Vec3 at(0, -2e-3, 1e-3);
    for (int t = 0; t < 15; ++t) {
        const Vec3 half(0, 0, 5e-3), next = at + step * Vec3::UnitY();
        const MovingCapsule tool[] = {{{at - half, at + half, bar}, {next - half, next + half, bar}, 2}};
        const Hold holds[] = {{0, arc.front()}, {60, arc.back()}};
        constexpr int owners[] = {0, 1};
        const TickReport report = thread.tick({holds, owners, tool, nullptr, tick});
        ASSERT_EQ(report.pass_throughs, 0) << t;
        at += thread.progress(2) * (next - at);
    }
    double foremost = 0;
    for (const Vec3& p : thread.nodes()) foremost = std::max(foremost, p.y());
    EXPECT_GT(at.y(), 0) << "the bar came through the place where the thread lay";
    EXPECT_GT(foremost, at.y() + bar);
}

// An end of a straight thread starts at once, across it and on a circle about the other end, which is held: on the way
// the thread is slack by the sagitta between the circle and the chord, and its tension is that of inertia and bending.
// Ticks of 0.1 ms find 0.005 N, twice that is allowed. A step that asks bends for length that so straight a piece does
// not have leaps aside and stretches links by a tenth, 17 N.
TEST(Elastic, EndLedAsideAtOnceDoesNotPullASlackThread) {
    constexpr double length = 60e-3, seconds = 0.05;
    for (const double thick : {0.1e-3, 0.3e-3})
        for (const int links : {75, 300, 600})
            for (const double dt : {1e-3, 2e-3, 5e-3, 10e-3})
                for (const int aside : {1, 2}) {
                    SCOPED_TRACE(testing::Message() << thick << " m, " << links << " links, ticks of " << dt << " s");
                    ThreadDef def{.radius = thick / 2};
                    def.elastic = {.axial_over_bending = 0};
                    std::vector<Vec3> nodes;
                    for (int i = 0; i <= links; ++i) nodes.emplace_back(i * length / links, 0, 0);
                    Thread thread(def, nodes);
                    const double turn = 25e-3 * seconds / length;
                    Vec3 to(length * std::cos(turn), 0, 0);
                    to[aside] = -length * std::sin(turn);
                    double pulled = 0;
                    const int ticks = static_cast<int>(std::lround(seconds / dt));
                    for (int t = 1; t < ticks; ++t) {
                        const Vec3 now = nodes.back() + t * dt / seconds * (to - nodes.back());
                        const Hold holds[] = {{0, nodes.front()}, {links, now}};
                        constexpr int owners[] = {-1, -1};
                        thread.tick({holds, owners, {}, nullptr, dt});
                        pulled = std::max(pulled, *std::max_element(thread.tension().begin(), thread.tension().end()));
                    }
                    EXPECT_LT(pulled, 0.01);
                }
}

}  // namespace elastic_thread
