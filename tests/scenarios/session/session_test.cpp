// What a session tells of what was played: its samples, its pictures' captions, and every figure of its result against
// the world that it played.
#include "scenarios/session/session.hpp"

#include <gtest/gtest.h>

#include "scenarios/drill/motion.hpp"

namespace sessions {

using instruments::ToolInput;
using scenarios::drill::Result;
using scenarios::session::Session;
using sim::geometry::Vec3;

// The beginning of the square drill, in which its left tool grasps the thread; then that tool lets go, and the other
// goes 4 mm in 0.1 s and then into the vessel, whose wall it stays behind. A tick costs as many microseconds as there
// were ticks before it.
struct Played {
    static constexpr int grasp = 400, after = 100, into = 20, ticks = grasp + after + into;
    double clock = 0, cost = 0;
    bool is_running = false;
    std::vector<ToolInput> inputs = std::vector<ToolInput>(2);
    std::vector<std::vector<double>> lag_mm;  // at every tenth tick
    Session session;

    Played() : session(make()) {
        const auto motion = motion_of(session.drill());
        for (int tick = 0; tick < grasp; ++tick) {
            motion.at(1e-3 * tick, inputs);
            go();
        }
        inputs[0].jaw = 1;
        for (int tick = 0; tick < after; ++tick) {
            inputs[1].pose.position.y() += 0.04e-3;
            go();
        }
        const Vec3 way = inputs[1].pose.position / into;
        for (int tick = 0; tick < into; ++tick) {
            inputs[1].pose.position -= way;
            go();
        }
    }

  private:
    static scenarios::drill::Motion motion_of(const scenarios::drill::Drill& drill) {
        return scenarios::drill::load_motion(drill.motion, std::vector<std::string>{"left", "right"});
    }
    Session make() {
        auto drill = scenarios::drill::load_drill(CARREL_SOURCE "/scenarios/drills/square-knot.json");
        motion_of(drill).at(0, inputs);
        return {std::move(drill), inputs, [this] {
                    if (is_running) clock += cost++;
                    is_running = !is_running;
                    return clock;
                }};
    }
    void go() {
        session.tick(inputs);
        if (session.world().ticks() % 10 != 0) return;
        auto& now = lag_mm.emplace_back();
        for (const auto& tool : session.world().tools())
            now.push_back(1e3 * instruments::distance_between(tool.now.pose, tool.asked.pose, tool.shape.jaw_length));
    }
};

// Every 10 ms, what hands asked for in millimetres a second, and what tools held.
TEST(Session, SamplesEveryHundredthOfASecond) {
    Played played;
    const Result result = played.session.finish();
    ASSERT_EQ(result.samples.size(), 52u);
    EXPECT_GT(played.lag_mm.back()[1], 1) << "it cannot follow its hand into the wall";
    for (std::size_t k = 0; k < 52; ++k) {
        const auto& sample = result.samples[k];
        EXPECT_NEAR(sample.t_s, 0.01 * static_cast<double>(k + 1), 1e-12);
        EXPECT_EQ(sample.tool_lag_mm, played.lag_mm[k]) << k;
        EXPECT_EQ(sample.knot, "0_1");
        EXPECT_EQ(sample.held[1], "");
        if (k >= 41 && k < 50) {
            EXPECT_NEAR(sample.tool_speed_mm_s[1], 40, 1e-6) << k;
            EXPECT_NEAR(sample.tool_speed_mm_s[0], 0, 1e-6) << k;
        }
    }
    EXPECT_EQ(result.samples[10].held[0], "");
    EXPECT_EQ(result.samples[38].held[0], "thread");
    EXPECT_EQ(result.samples[49].held[0], "");
}

// A picture of what happened, in the order in which it did, and of the end.
TEST(Session, ShowsWhatHappened) {
    Played played;
    played.session.finish();
    std::vector<std::string> captions;
    for (const auto& moment : played.session.key_moments()) captions.push_back(moment.caption);
    EXPECT_EQ(captions, (std::vector<std::string>{"left tool grasps the thread", "left tool lets go", "the end"}));
    EXPECT_NEAR(played.session.key_moments()[0].t_s, 0.175, 0.05) << "while its jaws close";
    EXPECT_NEAR(played.session.key_moments()[1].t_s, 0.401, 1e-9);
    EXPECT_NEAR(played.session.key_moments()[2].t_s, 0.52, 1e-12);
}

TEST(Session, TellsEveryFigureOfItsWorld) {
    Played played;
    const auto& world = played.session.world();
    const Result result = played.session.finish();
    EXPECT_EQ(result.drill_title, "Square knot around a 4 mm vessel");
    EXPECT_EQ(result.instruments, (std::vector<std::string>{"left", "right"}));
    EXPECT_EQ(result.ticks, 520u);
    EXPECT_NEAR(result.duration_s, 0.52, 1e-12);
    EXPECT_EQ(result.links, static_cast<int>(world.thread().size()) - 1);
    EXPECT_EQ(result.substeps, world.substeps());
    EXPECT_NE(result.substeps, result.ticks);
    EXPECT_EQ(result.stretch_max, world.worst().stretch);
    EXPECT_EQ(result.stretch_settled, world.stretch_now());
    EXPECT_LT(result.stretch_settled, result.stretch_max);
    EXPECT_EQ(result.separation_min, world.worst().separation);
    EXPECT_EQ(result.node_step_max_over_bound, world.worst().step_over_bound);
    EXPECT_EQ(result.contacts_max, world.worst().contacts);
    EXPECT_EQ(result.pass_throughs, 0u);
    EXPECT_EQ(result.knot, "0_1");
    EXPECT_EQ(std::stoull(result.state_hash, nullptr, 16), world.hash());
    EXPECT_EQ(result.state_hash.size(), 16u);
    EXPECT_EQ(result.events.size(), world.events().size());
    EXPECT_TRUE(result.finished);
    EXPECT_FALSE(result.passed) << "nothing is tied, though its other items are as asked";
    EXPECT_TRUE(std::any_of(result.items.begin(), result.items.end(), [](auto& item) { return item.passed; }));
}

// Ticks of 0 to 519 microseconds.
TEST(Session, TimesItsTicks) {
    Played played;
    const auto tick = played.session.finish().tick_us;
    EXPECT_EQ(tick.p50, 260);
    EXPECT_EQ(tick.p99, 514);
    EXPECT_EQ(tick.max, 519);
}

}  // namespace sessions
