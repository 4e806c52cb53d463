// A drill played live by a false clock: looking on, pauses and slow ticks change nothing that is computed.
#include "scenarios/session/live.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "scenarios/drill/motion.hpp"

namespace lives {

using instruments::ToolInput;
using scenarios::drill::Drill;
using scenarios::drill::Result;
using scenarios::session::Live;
using scenarios::session::LiveOptions;
using scenarios::session::Session;
using scenarios::session::Time;
using scenarios::world::World;

constexpr std::uint64_t most_ticks = 1234;  // the left tool grasps the thread within them, and lets go

const Drill& square() {
    static const Drill drill = scenarios::drill::load_drill(CARREL_SOURCE "/scenarios/drills/square-knot.json");
    return drill;
}

// The reference motion's inputs; the left tool opens its jaws for a while.
void inputs_at(std::uint64_t tick, std::span<ToolInput> tools) {
    static const auto motion =
        scenarios::drill::load_motion(square().motion, std::vector<std::string>{"left", "right"});
    motion.at(1e-3 * static_cast<double>(tick), tools);
    if (tick > 500 && tick < 700) tools[0].jaw = 1;
}

std::vector<ToolInput> start() {
    std::vector<ToolInput> tools(2);
    inputs_at(0, tools);
    return tools;
}

// What was played without a clock, once.
const Result& headless() {
    static const Result result = [] {
        Session session(square(), start());
        std::vector<ToolInput> inputs = start();
        for (std::uint64_t tick = 0; tick < most_ticks; ++tick) {
            inputs_at(tick, inputs);
            session.tick(inputs);
        }
        return session.finish();
    }();
    return result;
}

struct Player {
    std::atomic<double> clock = 0;
    std::mt19937 random;
    Live* live = nullptr;
    std::uint64_t pauses = 0;
    bool is_slow = false;

    Time time() {
        return {[this] { return clock.load(); }, [this](double seconds) { clock = clock + seconds; }};
    }
    // On the tick thread. Ticks take no time but that which is added here.
    std::optional<double> play(const World& world, std::span<ToolInput> tools) {
        inputs_at(world.ticks(), tools);
        if (is_slow && random() % 20 == 0) clock = clock + 1e-4 * static_cast<double>(random() % 1000);
        const bool pauses_now = pauses > 0 && random() % 100 == 0;
        if (pauses_now || world.ticks() + 1 == most_ticks) live->pause();
        return clock - 0.004;
    }
    scenarios::session::Hand hand() {
        return [this](const World& world, std::span<ToolInput> tools) { return play(world, tools); };
    }
    // Until the last tick.
    void watch(bool looks) {
        live->resume();
        for (;;) {
            if (looks) live->view();
            if (live->has_ended() || (live->is_paused() && live->ticks() == most_ticks)) return;
            if (live->is_paused()) live->resume();
            std::this_thread::yield();
        }
    }
};

void expect_same(const Result& found, const Result& asked) {
    EXPECT_EQ(found.state_hash, asked.state_hash);
    EXPECT_EQ(found.events, asked.events);
    EXPECT_EQ(found.items, asked.items);
}

// Whatever the clock does, and whoever looks on.
TEST(Live, GivesTheSameBitsAsWithoutAClock) {
    ASSERT_GT(headless().events.size(), 1u) << "nothing happened that could differ";
    for (unsigned seed = 0; seed < 3; ++seed) {
        SCOPED_TRACE(seed);
        Player player{.random = std::mt19937(seed), .pauses = seed, .is_slow = seed > 0};
        Live live(square(), start(), player.hand(), player.time());
        player.live = &live;
        player.watch(seed != 1);
        expect_same(live.finish(), headless());
    }
}

}  // namespace lives
