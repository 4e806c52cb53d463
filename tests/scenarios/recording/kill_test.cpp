#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "tests/scenarios/recording/session.hpp"

using namespace scenarios::recording;

namespace {

/// What the child says it has recorded, in memory that outlives it.
struct Progress {
    std::atomic<std::uint64_t> ticks{0};
};

Progress* shared_progress() {
    void* memory = mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return new (memory) Progress;
}

/// Records for ever: `per_pause` ticks, then a pause of a millisecond.
[[noreturn]] void record_until_killed(const std::filesystem::path& file, int per_pause, Progress& progress) {
    Recorder recorder(file, session::head());
    for (std::uint64_t t = 0;; ++t) {
        recorder.add_tick(session::tools_at(t));
        if (t % 100 == 99) recorder.add_hash(t, session::hash_at(t));
        progress.ticks = t + 1;
        if ((t + 1) % static_cast<std::uint64_t>(per_pause) == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

}  // namespace

// A resident's session ends with a power button or a crash as often as with a click. Killed at 20 moments, at the pace
// of a person (1 tick a millisecond) and of a batch run (50), each file opens, is a true prefix and lacks at most one
// second of simulated time of what had been recorded.
TEST(KilledRecorder, LosesAtMostOneSecond) {
    struct Victim {
        std::chrono::microseconds moment;
        std::filesystem::path file;
        Progress* progress;
        pid_t child;
    };
    const session::Folder folder;
    std::vector<Victim> victims;
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        victims.push_back(
            {std::chrono::microseconds(random() % 1500000), folder / std::to_string(seed), shared_progress(), 0});
        Victim& victim = victims.back();
        victim.child = fork();
        ASSERT_GE(victim.child, 0);
        if (victim.child == 0) record_until_killed(victim.file, seed % 2 ? 50 : 1, *victim.progress);
    }
    for (const Victim& victim : victims)
        while (victim.progress->ticks == 0) std::this_thread::yield();  // the file is open
    std::sort(victims.begin(), victims.end(), [](auto& a, auto& b) { return a.moment < b.moment; });
    const auto start = std::chrono::steady_clock::now();
    for (const Victim& victim : victims) {
        std::this_thread::sleep_until(start + victim.moment);
        ASSERT_EQ(kill(victim.child, SIGKILL), 0);
        int status = 0;
        ASSERT_EQ(waitpid(victim.child, &status, 0), victim.child);
        ASSERT_TRUE(WIFSIGNALED(status));
    }
    for (const Victim& victim : victims) {
        SCOPED_TRACE(victim.file);
        const std::uint64_t recorded = victim.progress->ticks;
        munmap(victim.progress, sizeof(Progress));
        const Recording r = load_recording(victim.file);
        EXPECT_EQ(r.damage, std::vector<std::string>());
        EXPECT_FALSE(r.finished);
        EXPECT_LE(recorded, r.ticks() + 1000) << "recorded " << recorded << ", on disk " << r.ticks();
        for (std::uint64_t t = 0; t < r.ticks(); ++t)
            ASSERT_EQ(session::bits(r.tick(t)), session::bits(session::tools_at(t))) << t;
        for (const TickHash& h : r.hashes) {
            EXPECT_EQ(h.hash, session::hash_at(h.tick));
            EXPECT_LT(h.tick, r.ticks());
        }
    }
}

namespace {
std::atomic<double> now_s = 0;  // set by the tests below

// How many ticks are on disk, as if killed now; waits some seconds for so many.
std::uint64_t ticks_on_disk(const std::filesystem::path& file, std::uint64_t expected) {
    for (int i = 0; i < 1000 && load_recording(file).ticks() < expected; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return load_recording(file).ticks();
}
}  // namespace

// Ticks that come slowly (a heavy scene, a window in the background) never fill half a simulated second: after half a
// second of wall clock they must be on disk all the same. Ticks 0.2 s apart: that at 0.6 s brings all four to disk.
TEST(KilledRecorder, SlowTicksAreSavedByTheClock) {
    const session::Folder folder;
    now_s = 0;
    Recorder recorder(folder / "slow", session::head(), {.clock = [] { return now_s.load(); }});
    for (std::uint64_t t = 0; t < 5; ++t) {
        now_s = 0.2 * static_cast<double>(t);
        recorder.add_tick(session::tools_at(t));
    }
    EXPECT_EQ(ticks_on_disk(folder / "slow", 4), 4u);
}

// A tick that hangs or crashes is looked into by its inputs: they come to disk although nothing more is added.
TEST(KilledRecorder, TheInputsOfATickThatHangsAreSaved) {
    const session::Folder folder;
    now_s = 0;
    Recorder recorder(folder / "hangs", session::head(), {.clock = [] { return now_s.load(); }});
    recorder.add_tick(session::tools_at(0));
    EXPECT_EQ(load_recording(folder / "hangs").ticks(), 0u);
    now_s = 0.6;
    EXPECT_EQ(ticks_on_disk(folder / "hangs", 1), 1u);
}
