#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "sim/geometry/closest_points.hpp"
#include "tests/sim/thread/scene.hpp"

namespace cutting {

using namespace scene;
using sim::thread::Piece;

constexpr double thickness = 2 * radius;

ThreadDef ftl() {
    return {};
}

ThreadDef elastic() {
    ThreadDef def;
    def.elastic = {.axial_over_bending = 0};
    return def;
}

ThreadDef fitted(ThreadDef def) {
    def.shortest_link = thickness;
    return def;
}

double length(const Thread& thread, const Piece& piece) {
    const auto from = thread.rest_lengths().begin();
    return std::accumulate(from + piece.first, from + piece.last, 0.0);
}

double length(const Thread& thread) {
    return std::accumulate(thread.rest_lengths().begin(), thread.rest_lengths().end(), 0.0);
}

Vec3 at(const Thread& thread, int node) {
    return thread.nodes()[static_cast<std::size_t>(node)];
}

// A hand at the tip of each end, taken `step` farther each tick, and what the worst of all ticks was.
struct Hands {
    explicit Hands(const Thread& thread) : nodes{0, static_cast<int>(thread.nodes().size()) - 1} {}

    bool cut(Thread& thread, int link, double share) { return thread.cut(link, share, nodes); }

    void take(Thread& thread, const Vec3& first, const Vec3& last, int ticks) {
        for (int i = 0; i < ticks; ++i) {
            thread.fit_links(nodes);
            const Hold holds[] = {{nodes[0], at(thread, nodes[0]) + first}, {nodes[1], at(thread, nodes[1]) + last}};
            constexpr int owners[] = {0, 1};
            const TickReport report = thread.tick({holds, owners, {}, nullptr, tick});
            worst.add(report);
            least_apart = std::min(least_apart, report.separation_min);
        }
    }

    void apart(Thread& thread, double step, int ticks) {
        take(thread, -step * Vec3::UnitX(), step * Vec3::UnitX(), ticks);
    }

    std::array<int, 2> nodes;
    Worst worst;
    double least_apart = 1e300;
};

double distance_to(const Vec3& p, std::span<const Vec3> nodes) {
    double least2 = 1e300;
    for (std::size_t i = 1; i < nodes.size(); ++i)
        least2 = std::min(least2, sim::geometry::closest_points(p, p, nodes[i - 1], nodes[i]).distance_squared);
    return std::sqrt(least2);
}

bool is_finite(const Thread& thread) {
    return std::all_of(thread.nodes().begin(), thread.nodes().end(), [](const Vec3& p) { return p.allFinite(); });
}

void expect_sound(const Hands& hands, const Thread& thread) {
    EXPECT_TRUE(is_finite(thread));
    EXPECT_EQ(hands.worst.pass_throughs, 0);
    EXPECT_LE(hands.worst.step_over_bound, 1 + 1e-12);  // rounding of a norm
}

// Wherever a blade comes down, by links longer and shorter than the thread is thick: each piece ends half a thickness
// from it, to within what is too short to be a link, and lies where it lay.
TEST(Cut, EndsTheOnePieceAndBeginsTheNextAtThatPlace) {
    for (const double link : {0.5, 1.0, 6.0})  // thicknesses
        for (const double share : {0.0, 0.1, 0.5, 0.97, 1.0}) {
            SCOPED_TRACE(testing::Message() << link << " thicknesses, at " << share);
            std::vector<Vec3> start = straight(40);
            for (Vec3& p : start) p *= link;
            for (std::size_t i = 21; i < start.size(); ++i)
                start[i] = start[20] + Vec3(0, start[i].x() - start[20].x(), 0);  // a corner next to it
            Thread thread({}, start);
            const double whole = length(thread), place = (19 + share) * link * thickness,
                         crumb = std::min(radius, 0.25 * link * thickness);
            ASSERT_TRUE(thread.cut(19, share, {}));
            const std::vector<Piece> pieces = thread.pieces();
            ASSERT_EQ(pieces.size(), 2u);
            EXPECT_TRUE(thread.is_cut(pieces[0].last));
            EXPECT_EQ(pieces[0].last + 1, pieces[1].first);
            EXPECT_NEAR(length(thread, pieces[0]), place - 0.52 * thickness - 0.5 * crumb,
                        0.5 * crumb + 0.01 * thickness);
            EXPECT_NEAR(length(thread, pieces[1]), whole - place - 0.52 * thickness - 0.5 * crumb,
                        0.5 * crumb + 0.01 * thickness);
            for (const Vec3& p : thread.nodes()) EXPECT_LE(distance_to(p, start), 1e-12 * whole);
            for (std::size_t k = 0; k < thread.rest_lengths().size(); ++k) {
                if (thread.is_cut(static_cast<int>(k))) continue;
                const double now = (thread.nodes()[k + 1] - thread.nodes()[k]).norm();
                EXPECT_NEAR(thread.rest_lengths()[k], now, 1e-12 * whole) << k;
                EXPECT_GE(now, 0.99 * crumb) << k;
            }
        }
}

// Neither an end nor what is cut already has a link to spare.
TEST(Cut, LeavesALinkOnEitherSideOrTheThreadWhole) {
    Thread thread(ftl(), straight(20));
    const std::uint64_t before = thread.hash();
    EXPECT_FALSE(thread.cut(0, 0.4, {}));
    EXPECT_FALSE(thread.cut(19, 0.6, {}));
    EXPECT_EQ(thread.hash(), before);
    ASSERT_TRUE(thread.cut(10, 0.5, {}));
    const Piece first = thread.pieces().front();
    EXPECT_FALSE(thread.cut(first.last, 0.5, {}));
    EXPECT_FALSE(thread.cut(first.last - 1, 0.9, {}));
    EXPECT_EQ(thread.pieces().size(), 2u);
}

// Who holds a node goes on holding it, by its new number, unless the blades took it.
TEST(Cut, HeldNodesKeepTheirPlacesAndTellWhatIsGone) {
    Thread thread(ftl(), straight(40));
    std::array<int, 5> held{3, 19, 20, 21, 38};
    std::array<Vec3, 5> places;
    std::transform(held.begin(), held.end(), places.begin(), [&](int node) { return at(thread, node); });
    ASSERT_TRUE(thread.cut(20, 0.0, held));  // at node 20
    EXPECT_EQ(held[2], -1);
    for (const std::size_t h : {0u, 1u, 3u, 4u}) EXPECT_EQ(at(thread, held[h]), places[h]) << h;
}

// What hands hold by the ends of one piece, and what lies cut off, has nothing to do with what is pulled: no piece
// follows another.
TEST(Cut, PiecesGoTheirOwnWays) {
    for (const ThreadDef& def : {ftl(), elastic(), fitted(ftl()), fitted(elastic())}) {
        SCOPED_TRACE(testing::Message() << (def.elastic ? "elastic " : "ftl ") << def.shortest_link);
        Thread thread(def, straight(60));
        Hands hands(thread);
        ASSERT_TRUE(hands.cut(thread, 39, 0.5));  // twice in one tick
        ASSERT_TRUE(hands.cut(thread, 19, 0.5));
        ASSERT_EQ(thread.pieces().size(), 3u);
        const Piece middle = thread.pieces()[1];
        const Vec3 from = at(thread, middle.first), to = at(thread, middle.last);
        const double whole = length(thread);
        hands.take(thread, Vec3(0, 0.1e-3, 0), Vec3(0, -0.1e-3, 0), 100);
        expect_sound(hands, thread);
        EXPECT_LE(hands.worst.stretch, 0.01);
        EXPECT_EQ(hands.worst.fraction, 1);
        ASSERT_EQ(thread.pieces().size(), 3u);
        EXPECT_NEAR(length(thread), whole, 1e-12 * whole);
        EXPECT_LE((at(thread, thread.pieces()[1].first) - from).norm(), 0.1 * thickness);
        EXPECT_LE((at(thread, thread.pieces()[1].last) - to).norm(), 0.1 * thickness);
        EXPECT_GT((at(thread, thread.pieces()[0].first) - from).norm(), 9e-3);
    }
}

// One piece goes as it would if it were all there is: straight tails between two hands that go the same way must not be
// carried along as if they were one taut thread.
TEST(Cut, APieceGoesAsAThreadOfItsOwnDoes) {
    for (const ThreadDef& def : {ftl(), elastic()}) {
        SCOPED_TRACE(def.elastic ? "elastic" : "ftl");
        Thread both(def, straight(60));
        Hands hands(both);
        ASSERT_TRUE(hands.cut(both, 29, 0.5));
        const auto last = both.pieces().front().last;
        Thread alone(def, {both.nodes().begin(), both.nodes().begin() + last + 1});
        Hands hand(alone);
        const Vec3 up(0, 0.02e-3, 0);
        for (int i = 0; i < 100; ++i) {
            hands.take(both, up, up, 1);
            const Hold hold[] = {{0, at(alone, 0) + up}};
            constexpr int owner[] = {0};
            alone.tick({hold, owner, {}, nullptr, tick});
        }
        EXPECT_LT(at(alone, last).y(), 0.9 * at(alone, 0).y()) << "nothing to tell apart";
        for (int i = 0; i <= last; ++i) EXPECT_LE((at(both, i) - at(alone, i)).norm(), 0.1 * thickness) << i;
    }
}

// A bend that no thread can make is none across a cut: an end laid beside the other piece must not push it away.
TEST(Cut, AnEndLiesBesideTheOtherPiece) {
    std::vector<Vec3> start = straight(20);
    for (Vec3& p : start) p *= 6;
    Thread thread(ftl(), start);
    std::array<int, 1> held{20};
    ASSERT_TRUE(thread.cut(9, 0.5, held));
    const Piece first = thread.pieces()[0], second = thread.pieces()[1];
    const Vec3 before = at(thread, first.last - 1),
               to = at(thread, first.last) + Vec3(-4 * thickness, 1.5 * thickness, 0);
    const Vec3 from = at(thread, second.first);
    for (int i = 1; i <= 200; ++i) {
        const double up = std::min(1.0, i / 100.0), along = std::max(0.0, i / 100.0 - 1);
        const Hold hold[] = {{second.first, from + Vec3(along * (to - from).x(), up * (to - from).y(), 0)}};
        constexpr int owner[] = {0};
        EXPECT_EQ(thread.tick({hold, owner, {}, nullptr, tick}).fraction, 1) << i;
    }
    EXPECT_LE((at(thread, second.first) - to).norm(), 1e-9);
    EXPECT_LE((at(thread, first.last - 1) - before).norm(), 0.05 * thickness);
}

// What was jammed for long is tried ever more seldom; once cut it must not wait for the next try.
TEST(Cut, WhatWasJammedIsFree) {
    Thread thread(ftl(), straight(60));
    Hands hands(thread);
    hands.apart(thread, 0.1e-3, 600);
    EXPECT_LT(hands.worst.fraction, 1);
    ASSERT_TRUE(hands.cut(thread, 29, 0.5));
    hands.apart(thread, 0.1e-3, 1);  // the one way to answer, then the other
    hands.worst = {};
    hands.apart(thread, 0.1e-3, 10);
    EXPECT_EQ(hands.worst.fraction, 1);
}

// A thread in balance in every tick has no mass; a piece that nobody holds then falls as stones do, or tools would wait
// for its fall.
TEST(Cut, APieceThatNobodyHoldsFalls) {
    constexpr double g = 9.81;
    ThreadDef def = elastic();
    def.elastic->quasi_static = true;
    def.elastic->gravity = {0, 0, -g};
    std::vector<Vec3> hanging = straight(60);
    for (Vec3& p : hanging) p = Vec3(0, 0, -p.x());
    Thread thread(def, hanging);
    std::array<int, 1> held{0};
    ASSERT_TRUE(thread.cut(29, 0.5, held));
    const Piece cut_off = thread.pieces()[1];
    const double from = at(thread, cut_off.last).z();
    constexpr int ticks = 20;  // to 2.3 D a tick: no thread is let go faster than 3 D a tick
    Worst worst;
    for (int i = 0; i < ticks; ++i) {
        const Hold hold[] = {{0, at(thread, 0) + Vec3(0, 0, 0.05e-3)}};
        constexpr int owner[] = {0};
        worst.add(thread.tick({hold, owner, {}, nullptr, tick}));
    }
    EXPECT_EQ(worst.fraction, 1);
    EXPECT_EQ(worst.pass_throughs, 0);
    const double fallen = g * tick * tick * ticks * (ticks + 1) / 2;  // of implicit Euler
    EXPECT_NEAR(from - at(thread, cut_off.last).z(), fallen, 0.01 * fallen);
}

// What strands do to each other does not end where one of them was cut: pushed together end to end, or side by side,
// they keep apart.
TEST(Cut, PiecesMeetAsStrandsDo) {
    for (const ThreadDef& def : {ftl(), elastic()}) {
        SCOPED_TRACE(def.elastic ? "elastic" : "ftl");
        Thread thread(def, straight(40));
        Hands hands(thread);
        ASSERT_TRUE(hands.cut(thread, 19, 0.5));
        hands.take(thread, Vec3(0.01e-3, 0.002e-3, 0), Vec3(-0.01e-3, 0, 0.002e-3), 200);
        expect_sound(hands, thread);
        EXPECT_GT(hands.least_apart, 0.95);
    }
}

// A knot pulled tight and cut through: no strand may leap through another as the rest of it comes loose, and then the
// hands draw the pieces out of each other.
TEST(Cut, AKnotCutInItsMiddleComesApart) {
    for (const ThreadDef& def : {ftl(), elastic()}) {
        SCOPED_TRACE(def.elastic ? "elastic" : "ftl");
        Thread thread(def, overhand(120));
        Hands hands(thread);
        hands.apart(thread, 0.02 * thickness, 1500);
        const int middle = static_cast<int>(thread.rest_lengths().size()) / 2;
        EXPECT_LT(end_distance(thread), 0.95 * length(thread));  // still knotted
        hands.worst = {}, hands.least_apart = 1e300;
        ASSERT_TRUE(hands.cut(thread, middle, 0.3));
        const double whole = length(thread);
        hands.apart(thread, 0, 1);
        EXPECT_TRUE(is_finite(thread));
        hands.apart(thread, 0.1 * thickness, 1000);
        expect_sound(hands, thread);
        EXPECT_GT(hands.least_apart, 0.9);
        EXPECT_GT(end_distance(thread), 1.2 * whole) << "they hang on to each other";
        EXPECT_NEAR(length(thread), whole, 1e-12 * whole);
    }
}

// The mirror image of the scene gives the mirror image of the answer.
TEST(Cut, TheSameBitsAgainAndMirrored) {
    for (const ThreadDef& def : {ftl(), elastic(), fitted(elastic())}) {
        SCOPED_TRACE(testing::Message() << (def.elastic ? "elastic " : "ftl ") << def.shortest_link);
        const auto play = [&](double mirror) {
            std::vector<Vec3> start = overhand(100);
            for (Vec3& p : start) p.z() *= mirror;
            Thread thread(def, start);
            Hands hands(thread);
            hands.apart(thread, 0.05 * thickness, 200);
            hands.cut(thread, 60, 0.25);
            hands.cut(thread, 40, 0.5);
            hands.apart(thread, 0.05 * thickness, 200);
            std::vector<Vec3> found(thread.nodes().begin(), thread.nodes().end());
            for (Vec3& p : found) p.z() *= mirror;
            return std::pair(found, thread.hash());
        };
        const auto plain = play(1), mirrored = play(-1);
        EXPECT_EQ(play(1).second, plain.second);
        ASSERT_EQ(mirrored.first.size(), plain.first.size());
        for (std::size_t i = 0; i < plain.first.size(); ++i) EXPECT_EQ(mirrored.first[i], plain.first[i]) << i;
    }
}

// Hands may pull on faster than pieces recoil; that must not break them to bits. What is an estimate must stand.
TEST(Cut, AThreadGivesWayOnceToOnePull) {
    sim::thread::Strength elastic{1}, ftl{1};
    const auto ticks_until = [](sim::thread::Strength& strength, bool is_elastic) {
        int ticks = 1;
        while (ticks < 500 && !strength.gives_way(1.5, tick, is_elastic)) ++ticks;
        return ticks;
    };
    EXPECT_EQ(ticks_until(elastic, true), 1);
    EXPECT_EQ(ticks_until(elastic, true), 500);
    EXPECT_FALSE(elastic.gives_way(1, tick, true));
    EXPECT_EQ(ticks_until(elastic, true), 1);
    EXPECT_NEAR(ticks_until(ftl, false), 100.5, 0.5);
    EXPECT_EQ(ticks_until(ftl, false), 500);
}

// A thread that is pulled hard and cut: nothing pulls any more, and its ends do not whip.
TEST(Cut, WhatWasTautIsSlack) {
    for (const ThreadDef& def : {ftl(), elastic()}) {
        SCOPED_TRACE(def.elastic ? "elastic" : "ftl");
        Thread thread(def, straight(60));
        Hands hands(thread);
        for (int i = 0; i < 400 && *std::max_element(thread.tension().begin(), thread.tension().end()) < 1; ++i) {
            const Hold holds[] = {{0, at(thread, 0) - Vec3(2e-5, 0, 0), Vec3(-1e-3, 0, 0)},
                                  {60, at(thread, 60) + Vec3(2e-5, 0, 0), straight(60).back() + Vec3(1e-3, 0, 0)}};
            constexpr int owners[] = {0, 1};
            thread.tick({holds, owners, {}, nullptr, tick});
        }
        ASSERT_GE(*std::max_element(thread.tension().begin(), thread.tension().end()), 1);
        ASSERT_TRUE(hands.cut(thread, 30, 0.5));
        double fastest = 0;
        for (int i = 0; i < 200; ++i) {
            const std::vector<Vec3> before(thread.nodes().begin(), thread.nodes().end());
            hands.apart(thread, 0, 1);
            for (std::size_t k = 0; k < before.size(); ++k)
                fastest = std::max(fastest, (thread.nodes()[k] - before[k]).norm() / tick);
        }
        expect_sound(hands, thread);
        EXPECT_LT(*std::max_element(thread.tension().begin(), thread.tension().end()), 0.01);
        EXPECT_LT(fastest, 1) << "m/s";
        RecordProperty("fastest", std::to_string(fastest));
    }
}

// A caller that breaks its promise is told which, where assertions are on.
#ifndef NDEBUG
TEST(CutDeathTest, NamesThePromiseThatWasBroken) {
    Thread thread(ftl(), straight(4));
    const Hold beyond[] = {{5, Vec3::Zero()}};
    constexpr int owners[] = {0};
    EXPECT_DEATH(thread.cut(4, 0.5, {}), "a link of the thread");
    EXPECT_DEATH(thread.tick({beyond, owners, {}}), "a node of the thread");
    EXPECT_DEATH(thread.tick({beyond, {}, {}}), "an owner for each hold");
    EXPECT_DEATH(Thread(ftl(), {Vec3::Zero(), Vec3::Zero()}), "links of some length");
}
#endif

}  // namespace cutting
