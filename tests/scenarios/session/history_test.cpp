#include "scenarios/session/history.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <chrono>
#include <fstream>
#include <set>
#include <thread>

#include "scenarios/recording/recording.hpp"
#include "scenarios/session/recordings_folder.hpp"
#include "tests/scenarios/drill/sample.hpp"
#include "tests/scenarios/recording/session.hpp"

namespace histories {

namespace fs = std::filesystem;
using scenarios::drill::ScoreItem;
using scenarios::session::Attempt;
using scenarios::session::attempts_in;
using session::Folder;

ScoreItem path(const std::string& value, bool passed) {
    return {"path_left", "Path length, left tool", value, "mm", "at most 900", passed, 3, passed ? "" : "Too far."};
}

// A recording that was written so many seconds after another; without items: killed before its end.
void record(const fs::path& file, int at_s, const std::vector<ScoreItem>& items,
            const std::string& drill = sample::drill, std::uint64_t ticks = 3000) {
    {
        auto head = session::head();
        head.drill_text = drill;
        scenarios::recording::Recorder recorder(file, head, {.clock = [] { return 0.0; }});
        for (std::uint64_t t = 0; t < ticks; ++t) recorder.add_tick(session::tools_at(t));
        if (!items.empty()) recorder.set_scores(items), recorder.finish();
    }
    fs::last_write_time(file, fs::file_time_type() + std::chrono::seconds(at_s));
}

std::string key_of(const std::string& drill) {
    return history_key(scenarios::drill::parse_drill(drill, "a.json", ""));
}

TEST(History, AnAttemptIsReadFromItsRecordingAlone) {
    const Folder folder;
    record(folder / "a.carrel", 100, {path("812.4", true), path("950.0", false)});
    const Attempt attempt = scenarios::session::read_attempt(folder / "a.carrel");
    EXPECT_EQ(attempt.file, folder / "a.carrel");
    EXPECT_EQ(attempt.key, key_of(sample::drill));
    EXPECT_EQ(attempt.drill_title, "Square knot");
    EXPECT_DOUBLE_EQ(attempt.duration_s, 3);
    EXPECT_TRUE(attempt.finished);
    EXPECT_FALSE(attempt.passed);
    EXPECT_EQ(attempt.missed(), 1u);
    EXPECT_EQ(attempt.items, (std::vector{path("812.4", true), path("950.0", false)}));
    record(folder / "b.carrel", 100, {path("812.4", true)});
    EXPECT_TRUE(scenarios::session::read_attempt(folder / "b.carrel").passed);
}

// A second's recording of a session at this pace and with these marks.
Attempt played(const fs::path& file, const scenarios::recording::Circumstances& session, double rate,
               const std::vector<scenarios::recording::Mark>& marks = {}) {
    auto head = session::head();
    head.session = session;
    scenarios::recording::Recorder recorder(file, head, {.clock = [] { return 0.0; }});
    for (std::uint64_t t = 0; t < 1000; ++t) recorder.add_tick(session::tools_at(t));
    recorder.add_pace({.tick = 1000, .wall_s = 1 / rate, .rate = rate});
    for (const auto& mark : marks) recorder.add_mark(mark);
    recorder.set_scores({path("812.4", true)});
    recorder.finish();
    return scenarios::session::read_attempt(file);
}

// What is kept apart later is read right: exams, help of any sort, and computers that were too slow.
TEST(History, KnowsExamsHelpAndSlowComputers) {
    const Folder folder;
    const auto file = folder / "a.carrel";
    const Attempt plain = played(file, {}, 0.99);
    EXPECT_FALSE(plain.exam || plain.assisted);
    EXPECT_TRUE(plain.comparable && plain.passed);
    EXPECT_TRUE(played(file, {.exam = true}, 1).exam);
    EXPECT_TRUE(played(file, {.assists = "wrist"}, 1).assisted);
    EXPECT_TRUE(played(file, {}, 1, {{500, "assist", "snap on"}, {600, "assist", "snap off"}}).assisted);
    EXPECT_FALSE(played(file, {}, 1, {{0, "assist", "snap off"}, {500, "note", "here on"}}).assisted);
    EXPECT_TRUE(played(file, {}, 1, {{500, "pace", "0.250000"}}).assisted) << "slow motion is help";
    EXPECT_FALSE(played(file, {.pace = 0.35}, 0.34, {{0, "pace", "0.350000"}}).assisted) << "the drill is that slow";
    EXPECT_TRUE(played(file, {.pace = 0.35}, 0.34).comparable);
    EXPECT_FALSE(played(file, {}, 0.9).comparable);
}

TEST(History, RecordingsOfTheFirstVersionAreUnassistedPractice) {
    const Folder folder;
    played(folder / "a.carrel", {.assists = "wrist", .exam = true}, 0.5);
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((folder / "a.carrel").c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, "PRAGMA user_version=1; DROP TABLE session; DROP TABLE mark; DROP TABLE pace",
                           nullptr, nullptr, nullptr),
              SQLITE_OK);
    sqlite3_close(database);
    const Attempt attempt = scenarios::session::read_attempt(folder / "a.carrel");
    EXPECT_FALSE(attempt.exam || attempt.assisted);
    EXPECT_TRUE(attempt.comparable && attempt.passed);
}

TEST(History, AFolderIsReadInOrderOfTimeAndNeverWrittenTo) {
    const Folder folder;
    EXPECT_TRUE(attempts_in(folder / "none").empty());
    record(folder / "a.carrel", 300, {path("1", true)});
    record(folder / "b.carrel", 100, {path("2", true)});
    record(folder / "c.carrel", 200, {});
    std::ofstream(folder / "begun.carrel");  // about to be recorded into
    std::ofstream(folder / "notes.txt") << "not a recording";
    std::ofstream(folder / "bad.carrel") << "not a recording";
    std::vector<std::string> unreadable;
    const auto attempts = attempts_in((folder / "a").parent_path(), &unreadable);
    ASSERT_EQ(attempts.size(), 3u);
    EXPECT_EQ(attempts[0].items[0].value, "2");
    EXPECT_FALSE(attempts[1].finished) << "killed: there, without a score";
    EXPECT_EQ(attempts[2].items[0].value, "1");
    EXPECT_EQ(attempts[2].recorded_at - attempts[0].recorded_at, 200);
    ASSERT_EQ(unreadable.size(), 1u);
    EXPECT_NE(unreadable[0].find("bad.carrel: error: cannot be read (it is not a recording)"), std::string::npos);
    EXPECT_EQ(std::distance(fs::directory_iterator((folder / "a").parent_path()), {}), 6);
}

TEST(History, DrillsAreToldApartByWhatIsJudgedNotByWords) {
    const Folder folder;
    record(folder / "a.carrel", 1, {path("1", true)});
    record(folder / "b.carrel", 2, {path("2", true)}, sample::with("Square knot", "Flat knot"));
    record(folder / "c.carrel", 3, {path("3", true)}, sample::with("\"max\": 900", "\"max\": 800"));
    record(folder / "d.carrel", 4, {path("4", true)}, "{\"carrel_drill\": 99}");
    const auto attempts = attempts_in((folder / "a").parent_path());
    ASSERT_EQ(attempts.size(), 4u);
    EXPECT_EQ(attempts_at(attempts, key_of(sample::drill)).size(), 2u);
    EXPECT_EQ(attempts[3].key, "") << "a drill of another version keeps its scores";
    EXPECT_EQ(attempts[3].items.size(), 1u);
}

Attempt attempt(bool passed, double duration_s, std::size_t missed = 0) {
    Attempt made;
    made.finished = true;
    made.passed = passed;
    made.duration_s = duration_s;
    made.items.assign(missed, path("950", false));
    return made;
}

TEST(History, SumsUpTriesPassesAndTheBest) {
    std::vector<Attempt> all{attempt(false, 20, 2), attempt(true, 40), attempt(false, 10, 1), attempt(true, 30),
                             attempt(true, 35)};
    auto sum = scenarios::session::summary(all).unassisted;
    EXPECT_EQ(sum.tries, 5u);
    EXPECT_EQ(sum.passes, 3u);
    EXPECT_EQ(sum.passes_in_a_row, 2u);
    EXPECT_EQ(sum.best, 3u) << "none missed, in the least time";
    all.push_back(attempt(false, 5));
    all.back().finished = false;
    sum = scenarios::session::summary(all).unassisted;
    EXPECT_EQ(sum.tries, 5u) << "broken off in practice: no try";
    all.back().exam = true;
    sum = scenarios::session::summary(all).unassisted;
    EXPECT_EQ(sum.tries, 6u);
    EXPECT_EQ(sum.passes_in_a_row, 0u);
    EXPECT_EQ(sum.best, 3u);
    EXPECT_FALSE(scenarios::session::summary({}).unassisted.best);
}

// A score with help, or at half speed, must never stand as somebody's best.
TEST(History, NeverMixesHelpAndSlowComputersWithTheRest) {
    std::vector<Attempt> all{attempt(true, 50), attempt(true, 10), attempt(true, 5)};
    all[1].assisted = true;
    all[2].comparable = false;
    all[2].recorded_at = 77;
    const auto sum = scenarios::session::summary(all);
    EXPECT_EQ(sum.unassisted.best, 0u);
    EXPECT_EQ(sum.unassisted.tries, 1u);
    EXPECT_EQ(sum.assisted.best, 1u);
    EXPECT_EQ(sum.assisted.tries, 1u);
    EXPECT_EQ(sum.incomparable, 1u);
    EXPECT_EQ(sum.last_at, 77);
}

TEST(History, PlotsTheLastValuesOfAnItem) {
    std::vector<Attempt> all(12);
    for (int i = 0; i < 12; ++i) all[static_cast<std::size_t>(i)].items = {path(std::to_string(i) + ".5", true)};
    all[11].items[0].value = "none";
    const auto values = scenarios::session::last_values(all, "path_left");
    ASSERT_EQ(values.size(), 10u);
    EXPECT_EQ(values.front(), 1.5);
    EXPECT_EQ(values.back(), 10.5);
    EXPECT_TRUE(scenarios::session::last_values(all, "time").empty());
}

TEST(Recordings, NextFileNeverTouchesOneThatIsThere) {
    const Folder folder;
    const auto next = [&] {
        return scenarios::session::make_next_recording(folder / "who", "square-knot").filename().string();
    };
    EXPECT_EQ(next(), "square-knot-0001.carrel");
    EXPECT_EQ(next(), "square-knot-0002.carrel");
    std::ofstream(folder / "who/square-knot-0041.carrel") << "kept";
    std::ofstream(folder / "who/square-knot-x.carrel");
    std::ofstream(folder / "who/square-knot-two-0099.carrel");
    EXPECT_EQ(next(), "square-knot-0042.carrel");
    EXPECT_EQ(fs::file_size(folder / "who/square-knot-0041.carrel"), 4u);
    std::ofstream(folder / "file") << "no folder";
    EXPECT_THROW(scenarios::session::make_next_recording(folder / "file", "a"), std::runtime_error);
}

// Two windows begin at once: neither may record into the other's file.
TEST(Recordings, NobodyGetsTheSameFileTwice) {
    const Folder folder;
    std::vector<std::set<fs::path>> made(4);
    std::vector<std::thread> windows;
    for (auto& files : made)
        windows.emplace_back([&] {
            for (int i = 0; i < 50; ++i) files.insert(scenarios::session::make_next_recording(folder / "who", "a"));
        });
    for (auto& window : windows) window.join();
    std::set<fs::path> all;
    for (const auto& files : made) all.insert(files.begin(), files.end());
    EXPECT_EQ(all.size(), 200u);
}

TEST(Recordings, LieWhereTheDesktopStandardSays) {
    setenv("XDG_DATA_HOME", "/data", 1);
    EXPECT_EQ(scenarios::session::recordings_folder("R-7"), "/data/carrel/recordings/R-7");
    unsetenv("XDG_DATA_HOME");
    setenv("HOME", "/home/a", 1);
    EXPECT_EQ(scenarios::session::recordings_folder("R-7"), "/home/a/.local/share/carrel/recordings/R-7");
    for (const char* good : {"R-7", "anna_2"}) EXPECT_FALSE(scenarios::session::problem_with_player(good)) << good;
    for (const char* bad : {"", "..", "a/b", "é", "a b"})
        EXPECT_TRUE(scenarios::session::problem_with_player(bad)) << bad;
}

TEST(Recordings, LowSpaceIsSaidBeforePlay) {
    const Folder folder;
    EXPECT_FALSE(scenarios::session::low_space(folder / "not/there/yet", 1));
    const auto said = scenarios::session::low_space(folder / "not/there/yet", std::uintmax_t(1) << 62);
    ASSERT_TRUE(said);
    EXPECT_TRUE(said->starts_with("Only ")) << *said;
    EXPECT_NE(said->find(" MB are free for recordings in "), std::string::npos) << *said;
}

}  // namespace histories
