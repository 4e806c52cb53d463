#include "scenarios/session/guide.hpp"

#include <gtest/gtest.h>

#include "tests/scenarios/world/scene.hpp"

namespace guiding {

using scenarios::drill::Done;
using scenarios::drill::Drill;
using scenarios::drill::Held;
using scenarios::session::Guide;
using scenarios::world::EventKind;
using namespace scene;

Drill drill_of(const std::vector<Done>& steps) {
    Drill drill;
    for (const Done& done : steps) drill.steps.push_back({"Do it.", done, {}});
    return drill;
}

Done held(std::size_t instrument, Held what) {
    return {.held = {{instrument, what}}};
}

// Two needle holders stand open above a thread along x.
struct TwoHolders : Scene {
    TwoHolders() {
        add("left", Kind::needle_holder, {from_above(-12 * mm), 1});
        add("right", Kind::needle_holder, {from_above(12 * mm), 1});
        lay({Vec3(-15 * mm, 0, 0), Vec3(15 * mm, 0, 0)}, 100);
    }
};

struct Play {
    TwoHolders scene{};
    World world = scene.world();
    Guide guide;

    explicit Play(const std::vector<Done>& steps) : guide(drill_of(steps)) {}
    void go(int ticks = 1) {
        for (int i = 0; i < ticks; ++i) {
            world.tick(scene.tools);
            guide.after_tick(world);
        }
    }
    void set_jaw(std::size_t tool, double jaw) {
        scene.tools[tool].jaw = jaw;
        go(2);
    }
};

TEST(Guide, HasNothingToSayOfADrillWithoutSteps) {
    Play play({});
    play.go();
    EXPECT_EQ(play.guide.step(), 0u);
    EXPECT_EQ(play.guide.now(), nullptr);
}

TEST(Guide, TicksStepsOffAsHandsTakeAndLetGo) {
    Play play({held(0, Held::thread), held(1, Held::thread), held(0, Held::nothing)});
    play.go(10);
    EXPECT_EQ(play.guide.step(), 0u);
    play.set_jaw(1, 0);
    EXPECT_EQ(play.guide.step(), 0u) << "the other hand is asked for";
    play.set_jaw(0, 0);
    EXPECT_EQ(play.guide.step(), 2u) << "the second was done already";
    EXPECT_DOUBLE_EQ(play.guide.marks()[0].at_s, 0.013);
    EXPECT_DOUBLE_EQ(play.guide.marks()[1].at_s, 0.014);
    play.set_jaw(0, 1);
    EXPECT_EQ(play.guide.step(), 3u);
    EXPECT_EQ(play.guide.now(), nullptr);
    for (const auto& mark : play.guide.marks()) EXPECT_FALSE(mark.passed_over);
    play.set_jaw(0, 0);
    EXPECT_EQ(play.guide.step(), 3u) << "what is done stays done";
}

TEST(Guide, AsksForAllConditionsAtOnce) {
    const Vec3 place = from_above(-12 * mm).position + Vec3(0, 0, 5 * mm);
    Play play({{.held = {{0, Held::thread}}, .near = {{0, place, 1 * mm}}}});
    play.scene.tools[0].pose.position = place;
    play.go(60);
    EXPECT_EQ(play.guide.step(), 0u) << "it is there, with empty jaws";
    play.scene.tools[0].pose.position -= Vec3(0, 0, 5 * mm);
    play.go(60);
    play.set_jaw(0, 0);
    EXPECT_EQ(play.guide.step(), 0u) << "it holds the thread, somewhere else";
    play.scene.tools[0].pose.position += Vec3(0, 0, 3.9 * mm);
    play.go(60);
    EXPECT_EQ(play.guide.step(), 0u);
    play.scene.tools[0].pose.position += Vec3(0, 0, 0.2 * mm);
    play.go(60);
    EXPECT_EQ(play.guide.step(), 1u);
}

// What happened before a step began is not what it asks for.
TEST(Guide, AnEventCountsFromTheStepsBeginningOn) {
    const Done grasped{.event = {{EventKind::grasp, "left"}}};
    Play play({held(1, Held::thread), grasped, grasped});
    play.set_jaw(0, 0);
    play.set_jaw(1, 0);
    play.go(5);
    EXPECT_EQ(play.guide.step(), 1u);
    play.set_jaw(1, 1);
    play.set_jaw(1, 0);
    EXPECT_EQ(play.guide.step(), 1u) << "the other hand grasped";
    play.set_jaw(0, 1);
    play.set_jaw(0, 0);
    EXPECT_EQ(play.guide.step(), 2u) << "the third asks for another grasp";
    play.set_jaw(0, 1);
    play.set_jaw(0, 0);
    EXPECT_EQ(play.guide.step(), 3u);
}

// Events name more than who did it: "left by the thread".
TEST(Guide, AnEventIsOfWhoItNamesFirst) {
    for (const auto& [asked, is_done] : {std::pair("left", true), {"lef", false}, {"right", false}, {"", true}}) {
        Play play({{.event = {{EventKind::held_up, asked}}}});
        play.set_jaw(0, 0);
        play.set_jaw(1, 0);
        for (int tick = 0; tick < 300; ++tick) {
            play.scene.tools[0].pose.position.x() -= 0.02 * mm;
            play.go();
        }
        EXPECT_EQ(count(play.world, EventKind::held_up), 1u);
        EXPECT_EQ(play.guide.step(), is_done ? 1u : 0u) << asked;
    }
}

// An overhand (Shastri's polynomial, its ends bent to the axis) that nobody touches.
struct Tied : Scene {
    Tied() {
        std::vector<Vec3> path{Vec3(-20 * mm, 0, 0)};
        for (int i = 0; i <= 60; ++i) {
            constexpr double end = 2.4;
            const double t = end * (i / 30.0 - 1), tt = t * t, ending = (1 - tt / (end * end)) * (1 - tt / (end * end));
            path.push_back(mm *
                           Vec3(0.1 * t * (tt * tt - 10), 0.8 * ending * t * (tt - 3), 0.5 * ending * tt * (tt - 4)));
        }
        path.emplace_back(20 * mm, 0, 0);
        lay(path, 200);
        add("left", Kind::needle_holder, {from_above(-60 * mm), 1});
    }
};

std::size_t steps_done(const std::vector<Done>& steps, Guide* after = nullptr) {
    const Tied scene;
    World world = scene.world();
    Guide guide(drill_of(steps));
    for (int i = 0; i < 150; ++i) {
        world.tick(scene.tools);
        guide.after_tick(world);
    }
    if (after) *after = guide;
    return guide.step();
}

TEST(Guide, KnowsAKnotByNameThrowsAndNumber) {
    for (const Done& done : {Done{.knot = "overhand"}, Done{.notation = "1"}, Done{.throws = 1}})
        EXPECT_EQ(steps_done({done}), 1u) << done.knot << done.notation << done.throws;
    for (const Done& done :
         {Done{.knot = "square"}, Done{.notation = "1=1"}, Done{.throws = 2}, Done{.knot = "overhand", .throws = 2}})
        EXPECT_EQ(steps_done({done}), 0u) << done.knot << done.notation << done.throws;
}

// Who ties in another way than the guide says is not asked to carry the strand round once more.
TEST(Guide, PassesOverWhatLedToAKnotThatIsTied) {
    Guide after{Drill{}};
    EXPECT_EQ(steps_done({held(0, Held::thread), held(0, Held::thread), {.throws = 1}, held(0, Held::thread)}, &after),
              3u);
    EXPECT_TRUE(after.marks()[0].passed_over);
    EXPECT_TRUE(after.marks()[1].passed_over);
    EXPECT_FALSE(after.marks()[2].passed_over);
    EXPECT_EQ(steps_done({held(0, Held::thread), held(0, Held::nothing)}), 0u)
        << "what hands hold comes and goes: it is no reason to pass over a step";
}

// A window that goes back in time goes on with a copy.
TEST(Guide, ACopyGoesOnByItself) {
    Play play({held(0, Held::thread), held(1, Held::thread)});
    play.set_jaw(0, 0);
    const Guide then = play.guide;
    play.set_jaw(1, 0);
    EXPECT_EQ(play.guide.step(), 2u);
    EXPECT_EQ(then.step(), 1u);
}

}  // namespace guiding
