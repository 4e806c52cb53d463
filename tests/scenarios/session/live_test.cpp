// A drill played live by a false clock: looking on, pauses and slow ticks change nothing that is computed.
#include "scenarios/session/live.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>

#include "scenarios/session/script.hpp"

namespace lives {

using instruments::ToolInput;
using scenarios::drill::Drill;
using scenarios::drill::Result;
using scenarios::session::Live;
using scenarios::session::Script;
using scenarios::session::Session;
using scenarios::session::Time;
using scenarios::world::World;

constexpr std::uint64_t most_ticks = 1234;  // the left tool grasps the thread within them, and lets go

const Script& script() {
    static const Script script(CARREL_SOURCE "/scenarios/drills/square-knot.json");
    return script;
}
const Drill& square() {
    return script().drill;
}

// The reference motion's inputs; the left tool opens its jaws for a while.
void inputs_at(std::uint64_t tick, std::span<ToolInput> tools) {
    script().motion.at(1e-3 * static_cast<double>(tick), tools);
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
    std::mt19937 random{};
    Live* live = nullptr;
    std::uint64_t pauses = 0;
    bool is_slow = false;
    std::atomic<bool> is_last = false;  // the last tick is being made

    Time time() {
        return {[this] { return clock.load(); }, [this](double seconds) { clock = clock + seconds; }};
    }
    // On the tick thread. Ticks take no time but that which is added here.
    std::optional<double> play(const World& world, std::span<ToolInput> tools) {
        inputs_at(world.ticks(), tools);
        if (is_slow && random() % 20 == 0) clock = clock + 1e-4 * static_cast<double>(random() % 1000);
        const bool pauses_now = pauses > 0 && random() % 100 == 0;
        if (world.ticks() + 1 == most_ticks) is_last = true;
        if (pauses_now || is_last) live->pause();
        return clock - 0.004;
    }
    scenarios::session::Hand hand() {
        return [this](const World& world, std::span<ToolInput> tools) { return play(world, tools); };
    }
    // Until the last tick: the pause before that is not ended.
    void watch(bool looks) {
        live->resume();
        for (;;) {
            if (looks) live->view();
            if (live->has_ended() || (live->is_paused() && live->ticks() == most_ticks)) return;
            if (live->is_paused() && !is_last) live->resume();
            std::this_thread::yield();
        }
    }
};

void expect_same(const Result& found, const Result& asked) {
    EXPECT_EQ(found.state_hash, asked.state_hash);
    EXPECT_EQ(found.events, asked.events);
    EXPECT_EQ(found.items, asked.items);
}

// A recording of a live session, and what it says of it.
class Recorded : public ::testing::Test {
  protected:
    Recorded() {
        std::string name = (std::filesystem::temp_directory_path() / "carrel-live-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~Recorded() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path file() const { return folder_ / "a.carrel"; }
    scenarios::recording::Recorder recorder() const {
        return {file(), {square().text, "square-knot.json", "", 1e-3, {"left", "right"}, {}}, {.may_wait = false}};
    }

  private:
    std::filesystem::path folder_;
};

// What is recorded of it proves itself: the same inputs give the hashes, events and scores that are stored.
TEST_F(Recorded, IsReplayed) {
    Player player{.random = std::mt19937(7), .pauses = 1, .is_slow = true};
    Live live(square(), start(), player.hand(), player.time(), {}, recorder());
    player.live = &live;
    live.mark("note", "a needle fell");
    player.watch(true);
    expect_same(live.finish(), headless());
    EXPECT_EQ(live.trouble(), std::nullopt);

    const auto recording = scenarios::recording::load_recording(file());
    EXPECT_EQ(recording.damage, std::vector<std::string>());
    EXPECT_TRUE(recording.finished);
    ASSERT_EQ(recording.ticks(), most_ticks);
    ASSERT_EQ(recording.hashes.size(), most_ticks / 100 + 1);
    Session session(square(), recording.tick(0));
    for (std::uint64_t tick = 0, next = 0; tick < most_ticks; ++tick) {
        session.tick(recording.tick(tick));
        if (recording.hashes[next].tick != tick + 1) continue;
        EXPECT_EQ(recording.hashes[next++].hash, session.world().hash());
    }
    const Result replayed = session.finish();
    EXPECT_EQ(recording.events, replayed.events);
    EXPECT_EQ(recording.scores, replayed.items);
}

// Pace, delays and what was noted beside the ticks, as they were measured.
TEST_F(Recorded, SaysHowItWent) {
    Player player{.random = std::mt19937(3), .pauses = 1, .is_slow = true};
    Live live(square(), start(), player.hand(), player.time(), {}, recorder());
    player.live = &live;
    live.set_pace(0.25);
    EXPECT_EQ(live.pace(), 0.25);
    live.set_pace(0.001);
    EXPECT_EQ(live.pace(), 0.125);
    live.set_pace(7);
    EXPECT_EQ(live.pace(), 1) << "no faster than the drill declares";
    live.set_pace(0.5);
    live.note_shown(0.033);
    player.watch(false);
    live.finish();
    EXPECT_FALSE(live.is_comparable());

    const auto recording = scenarios::recording::load_recording(file());
    EXPECT_EQ(recording.pace, live.pace_rows());
    ASSERT_GE(recording.pace.size(), 2u);
    for (const auto& row : recording.pace) {
        EXPECT_LT(row.rate, 0.51);
        EXPECT_GT(row.rate, 0.1);
        ASSERT_TRUE(row.used);
        EXPECT_NEAR(row.used->p50_ms, 4, 1e-6);
        EXPECT_NEAR(row.used->p99_ms, 4, 1e-6);
    }
    EXPECT_GT(recording.pace.back().tick + 250, most_ticks) << "half a second at half the pace may be left";
    ASSERT_TRUE(recording.pace[0].shown);
    EXPECT_NEAR(recording.pace[0].shown->p50_ms, 33, 1e-9);
    std::map<std::string, int> kinds;
    for (const auto& mark : recording.marks) ++kinds[mark.kind];
    EXPECT_EQ(kinds["pace"], 4);
    EXPECT_GE(kinds["pause"], 2);
    EXPECT_EQ(kinds["resume"], kinds["pause"]) << "it begins paused and ends paused";
    EXPECT_EQ(recording.marks[0].text, "0.25");
}

// Without finish(), as by closing the window, what was played is kept and not scored.
TEST_F(Recorded, IsKeptWhereItIsBrokenOff) {
    {
        Player player;
        Live live(square(), start(), player.hand(), player.time(), {}, recorder());
        player.live = &live;
        player.watch(false);
    }
    const auto recording = scenarios::recording::load_recording(file());
    EXPECT_EQ(recording.damage, std::vector<std::string>());
    EXPECT_FALSE(recording.finished);
    EXPECT_EQ(recording.ticks(), most_ticks);
    EXPECT_TRUE(recording.scores.empty());
}

// Each event is in one view and no other, however seldom they are taken, and the last one shows the end.
TEST(Live, ViewsShowTheWorldAndEachEventOnce) {
    for (const unsigned period : {1u, 7u, 1000u}) {
        SCOPED_TRACE(period);
        Player player{.is_slow = true};
        Live live(square(), start(), player.hand(), player.time());
        player.live = &live;
        EXPECT_EQ(live.view().tick, 0u) << "there is one before the first tick";
        std::vector<scenarios::world::Event> events;
        const auto look = [&] {
            const auto& seen = live.view().events;
            events.insert(events.end(), seen.begin(), seen.end());
        };
        live.resume();
        for (unsigned i = 0; !live.is_paused(); ++i)
            if (i % period == 0) look();
        live.finish();
        look();
        const auto& view = live.view();
        const World& world = live.session().world();
        EXPECT_EQ(events, std::vector(world.events().begin(), world.events().end()));
        EXPECT_TRUE(view.events.empty()) << "they were in the call before";
        EXPECT_EQ(view.tick, most_ticks);
        EXPECT_EQ(view.scene.thread, world.curves());
        EXPECT_EQ(view.tension_max_N, world.measures().tension_max_N.value);
        EXPECT_EQ(view.tools[0].held, scenarios::session::held_by(world, 0));
        EXPECT_EQ(view.tools[1].name, "right");
        EXPECT_NEAR(*view.device_s, view.used_s - 0.004, 1e-9);
    }
}

// An exam goes on: its clock is not to be stopped by who sits it.
TEST(Live, AnExamCannotBePausedNorSlowedDown) {
    Player player;
    Live live(square(), start(), player.hand(), player.time(), {.exam = true});
    player.live = &live;
    live.set_pace(0.5);
    EXPECT_EQ(live.pace(), 1);
    live.resume();
    while (live.ticks() < 50) live.pause();
    EXPECT_FALSE(live.is_paused());
}

// What goes wrong in a hand ends the ticks and is told whoever finishes, not nobody.
TEST(Live, AHandThatFailsIsTold) {
    Player player;
    Live live(
        square(), start(), [](auto&, auto) -> std::optional<double> { throw std::runtime_error("no hand"); },
        player.time());
    live.resume();
    while (!live.has_ended()) std::this_thread::yield();
    EXPECT_THROW(live.finish(), std::runtime_error);
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
