#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "scenarios/world/judge.hpp"
#include "scenarios/world/locate.hpp"
#include "sim/thread/thread.hpp"
#include "tests/scenarios/world/scene.hpp"

namespace cutting {

using namespace scene;
using scenarios::world::Event;
using scenarios::world::EventKind;

constexpr double thickness = 0.085e-3, length = 30e-3;

// Needle holders hold a thread along x near its ends, from above; scissors stand open above its middle.
struct Held : Scene {
    explicit Held(const std::string& model) {
        add("left", Kind::needle_holder, {from_above(-12 * mm), 1});
        add("right", Kind::needle_holder, {from_above(12 * mm), 1});
        add("blades", Kind::scissors, {from_above(1.1 * mm), 1});
        def.thread.model = model;
        lay({Vec3(-length / 2, 0, 0), Vec3(length / 2, 0, 0)}, 100);
    }

    static Quat up() {
        Eigen::Matrix3d axes;
        axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        return Quat(axes);
    }

    // An overhand at x (Shastri's polynomial, its ends bent to the axis), the rest of the thread straight.
    void tie(double x, double scale, double half) {
        std::vector<Vec3> path{Vec3(-half, 0, 0)};
        for (int i = 0; i <= 60; ++i) {
            constexpr double end = 2.4;
            const double t = end * (i / 30.0 - 1), tt = t * t, ending = (1 - tt / (end * end)) * (1 - tt / (end * end));
            path.push_back(Vec3(x, 0, 0) + scale * Vec3(0.1 * t * (tt * tt - 10), 0.8 * ending * t * (tt - 3),
                                                        0.5 * ending * tt * (tt - 4)));
        }
        path.emplace_back(half, 0, 0);
        lay(path, def.thread.links);
    }
};

struct Play {
    explicit Play(Held of) : scene(std::move(of)), world(scene.world()) {}

    void tick() {
        const std::vector<Vec3> before(world.thread().begin(), world.thread().end());
        world.tick(scene.tools);
        if (before.size() != world.thread().size()) return;
        for (std::size_t i = 0; i < before.size(); ++i)
            fastest = std::max(fastest, (world.thread()[i] - before[i]).norm() / scene.def.tick_s);
    }
    void close(std::initializer_list<std::size_t> which, int ticks = 100) {
        for (int i = 1; i <= ticks; ++i) {
            for (const std::size_t tool : which) scene.tools[tool].jaw = 1 - static_cast<double>(i) / ticks;
            tick();
        }
    }
    void move(std::size_t tool, const Vec3& by, int ticks) {
        for (int i = 0; i < ticks; ++i) scene.tools[tool].pose.position += by / ticks, tick();
    }
    std::vector<Event> events(EventKind kind) const {
        std::vector<Event> found;
        std::copy_if(world.events().begin(), world.events().end(), std::back_inserter(found),
                     [&](const Event& event) { return event.kind == kind; });
        return found;
    }
    bool is_finite() const {
        return std::all_of(world.thread().begin(), world.thread().end(), [](const Vec3& p) { return p.allFinite(); });
    }
    double rest() const {
        const auto rest = world.thread_state().rest_lengths();
        return std::accumulate(rest.begin(), rest.end(), 0.0);
    }

    Held scene;
    World world;
    double fastest = 0;  // node [m/s]
};

Held scene_that_breaks_at_1_N(const char* model) {
    Held scene(model);
    scene.def.thread.break_force = 1;
    return scene;
}

// A pull past what the thread bears: it parts in one place, at that pull and not before, and nothing pulls or whips
// after it. By geometry alone a pull is an estimate, and must stand for a tenth of a second.
TEST(Break, OnceAtTheForceThatTheThreadBears) {
    for (const char* model : {"ftl", "elastic"}) {
        SCOPED_TRACE(model);
        Play play(scene_that_breaks_at_1_N(model));
        play.close({0, 1});
        double rise = 0;
        int too_hard = 0;  // ticks
        for (int i = 0; i < 2000 && play.events(EventKind::broken).empty(); ++i) {
            const double before = play.world.tension_now();
            play.move(1, Vec3(2e-6, 0, 0), 1);
            rise = std::max(rise, play.world.tension_now() - before);
            too_hard += play.world.tension_now() > 1;
        }
        ASSERT_EQ(play.events(EventKind::broken).size(), 1u);
        EXPECT_NEAR(too_hard, model == std::string("ftl") ? 100.5 : 1, 0.5);
        EXPECT_GT(play.world.measures().tension_max_N.value, 1);
        EXPECT_LE(play.world.measures().tension_max_N.value, 1 + too_hard * rise);
        EXPECT_LT(rise, 0.01) << "N: too fast to tell";
        EXPECT_EQ(play.world.thread_state().pieces().size(), 2u);
        EXPECT_TRUE(play.is_finite());
        EXPECT_GT(play.events(EventKind::broken)[0].value, 3.0);  // mm: between the jaws
        EXPECT_LT(play.events(EventKind::broken)[0].value, 27.0);
        EXPECT_EQ(play.events(EventKind::broken)[0].what.substr(0, 12), "thread at 1.");
        play.fastest = 0;
        play.move(1, Vec3(5e-3, 0, 0), 200);
        EXPECT_EQ(play.events(EventKind::broken).size(), 1u);
        EXPECT_LT(play.world.tension_now(), 0.05);
        EXPECT_LT(play.fastest, 1) << "m/s";
        EXPECT_TRUE(play.is_finite());
        EXPECT_NEAR(play.rest(), length, 2 * thickness);
        EXPECT_EQ(play.world.measures().pass_throughs, 0u);
        EXPECT_EQ(play.world.tools()[0].grasps.size(), 1u);
        EXPECT_EQ(play.world.tools()[1].grasps.size(), 1u);
        RecordProperty(std::string("fastest_") + model, std::to_string(play.fastest));
        RecordProperty(std::string("at_") + model, play.events(EventKind::broken)[0].what);
    }
}

// A 6-0 stretches by an eighth before it breaks, more than steps of an elastic thread may otherwise.
TEST(Break, AtTheForceOfItsSize) {
    Play play{Held("elastic")};
    play.close({0, 1});
    for (int i = 0; i < 2000 && play.events(EventKind::broken).empty(); ++i) play.move(1, Vec3(5e-6, 0, 0), 1);
    ASSERT_EQ(play.events(EventKind::broken).size(), 1u);
    EXPECT_NEAR(play.world.measures().tension_max_N.value, 1.96, 0.02);
}

// Below that it holds, however long.
TEST(Break, NotBelowThatForce) {
    for (const char* model : {"ftl", "elastic"}) {
        SCOPED_TRACE(model);
        Play play(scene_that_breaks_at_1_N(model));
        play.close({0, 1});
        for (int i = 0; i < 2000 && play.world.tension_now() < 0.95; ++i) play.move(1, Vec3(2e-6, 0, 0), 1);
        for (int i = 0; i < 1000; ++i) play.tick();
        EXPECT_GT(play.world.tension_now(), 0.9);
        EXPECT_TRUE(play.events(EventKind::broken).empty());
        EXPECT_EQ(play.world.thread_state().pieces().size(), 1u);
    }
}

// A tracker that loses the hand for a frame says that it is far away, and the thread, taut, cannot follow.
TEST(Break, NotByATrackerThatLosesTheHand) {
    Play play{Held("ftl")};
    play.close({0, 1});
    const Vec3 there = play.scene.tools[1].pose.position;
    play.scene.tools[1].pose.position.x() += 50e-3;
    for (int i = 0; i < 33; ++i) play.tick();
    EXPECT_GT(play.world.tension_now(), play.scene.def.thread.break_force);
    play.scene.tools[1].pose.position = there;
    for (int i = 0; i < 300; ++i) play.tick();
    EXPECT_TRUE(play.events(EventKind::broken).empty());
}

// Where the thread is bent it bears less: a knotted one parts where it enters its knot.
TEST(Break, AtTheKnot) {
    Held scene("elastic");
    scene.def.thread.links = 300;
    scene.def.thread.break_force = 1;
    scene.def.thread.shortest_link = thickness;
    scene.tie(0, 3e-3, 35e-3);
    for (const std::size_t side : {0u, 1u}) scene.tools[side].pose.position.x() = side == 0 ? -32e-3 : 32e-3;
    Play play(scene);
    play.world.name_knot_now();
    ASSERT_EQ(play.world.measures().knot.factors.size(), 1u) << play.world.measures().knot.knot;
    play.close({0, 1});
    std::vector<double> tails;
    for (int i = 0; i < 6000 && play.events(EventKind::broken).empty(); ++i) {
        if (i % 50 == 0) {
            play.world.name_knot_now();
            tails = locate_knot(play.world).tail_mm;
        }
        play.move(1, Vec3(5e-6, 0, 0), 1);
    }
    ASSERT_EQ(play.events(EventKind::broken).size(), 1u);
    const double place = play.events(EventKind::broken)[0].value, whole = 1e3 * play.rest();
    EXPECT_GT(place, tails[0] - 0.5);
    EXPECT_LT(place, whole - tails[1] + 0.5);
    for (int i = 0; i < 300; ++i) play.move(1, Vec3(5e-6, 0, 0), 1);
    EXPECT_EQ(play.world.measures().pass_throughs, 0u);
    EXPECT_TRUE(play.is_finite());
    RecordProperty("place", std::to_string(place) + " knot from " + std::to_string(tails[0]) + " to " +
                                std::to_string(whole - tails[1]));
}

// Blades close on a thread that two others hold: two pieces, each half a thickness short of where the blades met it.
TEST(Scissors, CutWhatTheyCloseOnAndHoldNothing) {
    for (const char* model : {"ftl", "elastic"}) {
        SCOPED_TRACE(model);
        Play play{Held(model)};
        play.close({0, 1});
        play.close({2});
        ASSERT_EQ(play.events(EventKind::cut).size(), 1u);
        EXPECT_EQ(play.events(EventKind::cut)[0].what, "blades");
        EXPECT_NEAR(play.events(EventKind::cut)[0].value, 15 + 1.1, 0.05);
        const auto pieces = play.world.thread_state().pieces();
        ASSERT_EQ(pieces.size(), 2u);
        EXPECT_NEAR(play.rest(), length - 1.05 * thickness, thickness);
        EXPECT_TRUE(play.world.tools()[2].grasps.empty());
        EXPECT_EQ(play.world.measures().pass_throughs, 0u);
        play.move(1, Vec3(3e-3, 0, 0), 100);
        EXPECT_LT(play.world.tension_now(), 0.05);
        EXPECT_LT(play.world.measures().lag_max_mm[1].value, 0.5);
        EXPECT_EQ(play.events(EventKind::cut).size(), 1u);
        EXPECT_TRUE(play.is_finite());
    }
}

// Closed beside the jaws, on a link of which they hold both ends: what is left of it stays in them.
TEST(Scissors, BesideJawsThatGoOnHolding) {
    for (const char* model : {"ftl", "elastic"}) {
        SCOPED_TRACE(model);
        Held scene(model);
        scene.def.thread.links = 25;
        scene.def.thread.shortest_link = 0;
        scene.tools[2].pose = {Vec3(12e-3 - 0.6e-3, 0, 2e-3), Held::up()};
        Play play(scene);
        play.close({0, 1});
        const int held = play.world.tools()[1].grasps.at(0).count();
        play.close({2});
        ASSERT_EQ(play.events(EventKind::cut).size(), 1u);
        ASSERT_EQ(play.world.thread_state().pieces().size(), 2u);
        ASSERT_FALSE(play.world.tools()[1].grasps.empty());
        const auto& grasps = play.world.tools()[1].grasps;
        int now = 0;
        for (const auto& grasp : grasps) {
            now += grasp.count();
            for (int k = grasp.first; k + 1 < grasp.first + grasp.count(); ++k)
                EXPECT_FALSE(play.world.thread_state().is_cut(k));
        }
        EXPECT_GE(now, held);
        const double x = play.world.thread().back().x();
        play.move(1, Vec3(3e-3, 0, 0), 100);
        EXPECT_GT(play.world.thread().back().x(), x + 2.9e-3) << "the piece in the jaws goes with them";
        EXPECT_EQ(play.world.measures().pass_throughs, 0u);
        RecordProperty(std::string("grasps_") + model, static_cast<int>(grasps.size()));
    }
}

// A thread with a knot loses one end: the knot is that of the piece it is in, its tails end where that ends.
TEST(Scissors, TheKnotIsThatOfThePieceThatIsTied) {
    Held scene("ftl");
    scene.tie(-6e-3, 1e-3, 15e-3);
    Play play(scene);
    play.world.name_knot_now();
    const auto before = judge(play.world);
    ASSERT_EQ(before.knot.factors.size(), 1u);
    play.close({2});
    ASSERT_EQ(play.events(EventKind::cut).size(), 1u);
    play.world.name_knot_now();
    const auto after = judge(play.world);
    EXPECT_EQ(after.knot.knot, before.knot.knot);
    EXPECT_EQ(after.piece, 0);
    EXPECT_NEAR(after.tail_mm[0], before.tail_mm[0], 0.4);
    const double cut_off = 1e3 * scene.def.thread.length - play.events(EventKind::cut)[0].value;
    EXPECT_NEAR(after.tail_mm[1], before.tail_mm[1] - cut_off, 0.5);
    EXPECT_GT(cut_off, 5);
    EXPECT_EQ(play.world.tied_piece().last, play.world.thread_state().pieces()[0].last);
    ASSERT_EQ(after.ties.size(), 1u) << "the piece that was cut off is not tied";
    EXPECT_EQ(after.ties[0].knot.knot, after.knot.knot);
    EXPECT_EQ(after.ties[0].tail_mm, after.tail_mm);
}

// The same tool in the same way cuts the same thread to the same bits.
TEST(Scissors, TheSameBitsAgain) {
    for (const char* model : {"ftl", "elastic"}) {
        const auto played = [&] {
            Held scene(model);
            scene.def.thread.break_force = 1;
            Play play(scene);
            play.close({0, 1});
            play.move(1, Vec3(3e-3, 0, 0), 300);
            play.close({2});
            play.move(2, Vec3(0, 2e-3, 0), 50);
            EXPECT_GE(play.world.thread_state().pieces().size(), 2u);
            return play.world.hash();
        };
        EXPECT_EQ(played(), played()) << model;
    }
}

}  // namespace cutting
