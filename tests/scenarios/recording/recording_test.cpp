#include "scenarios/recording/recording.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <sstream>

#include "tests/scenarios/recording/session.hpp"

using namespace scenarios;
using namespace scenarios::recording;
using session::bits;
using session::Folder;

// One wrong bit in an input and the replay drifts away from the session it should prove.
TEST(Recording, InputsComeBackBitForBit) {
    const Folder folder;
    for (const std::uint64_t ticks : {0, 1, 499, 500, 501, 3217}) {
        SCOPED_TRACE(ticks);
        session::record(folder / "a.carrel", ticks);
        const Recording r = load_recording(folder / "a.carrel");
        ASSERT_EQ(r.damage, std::vector<std::string>());
        EXPECT_TRUE(r.finished);
        ASSERT_EQ(r.ticks(), ticks);
        for (std::uint64_t t = 0; t < ticks; ++t) ASSERT_EQ(bits(r.tick(t)), bits(session::tools_at(t))) << t;
        ASSERT_EQ(r.hashes.size(), ticks / 100);
        for (const TickHash& h : r.hashes) ASSERT_EQ(h.hash, session::hash_at(h.tick));
    }
}

// Devices send what no pose is, and the world drops it; the recording must hold it all the same.
TEST(Recording, KeepsEveryKindOfDouble) {
    const Folder folder;
    using Limits = std::numeric_limits<double>;
    const double odd[] = {-0.0,
                          Limits::quiet_NaN(),
                          -Limits::quiet_NaN(),
                          std::bit_cast<double>(0x7ff0000000000123u),
                          Limits::infinity(),
                          -Limits::infinity(),
                          Limits::denorm_min(),
                          Limits::max()};
    Recorder recorder(folder / "a.carrel", session::head());
    std::vector<std::uint64_t> sent;
    for (std::size_t turn = 0; turn < 8; ++turn) {  // each in each place
        const auto n = [&](std::size_t i) { return odd[(i + turn) % 8]; };
        std::vector<instruments::ToolInput> tools = session::tools_at(turn);
        tools[1] = {{{n(0), n(1), n(2)}, instruments::Quat(n(3), n(4), n(5), n(6))}, n(7)};
        recorder.add_tick(tools);
        for (const std::uint64_t number : bits(tools)) sent.push_back(number);
    }
    recorder.finish();
    EXPECT_EQ(bits(load_recording(folder / "a.carrel").inputs), sent);
}

// A report made from a recording shows its head, events and scores; each field must be the one that was written.
TEST(Recording, HeadEventsAndScoresComeBack) {
    const Folder folder;
    const world::Event slip{1.25, world::EventKind::slip, "right", 0.75};
    const drill::ScoreItem item{"knot", "Knot", "granny", "", "square", false, 2.5, "It's wrong; \"reverse\" it."};
    {
        Recorder recorder(folder / "a.carrel", session::head());
        recorder.add_event(slip);
        recorder.add_tick(session::tools_at(0));
        recorder.set_scores({item, item});
        recorder.set_scores({item});  // the last word counts
        recorder.finish();
    }
    const Recording r = load_recording(folder / "a.carrel");
    EXPECT_EQ(r.head.drill_text, session::head().drill_text);
    EXPECT_EQ(r.head.drill_name, "a.json");
    EXPECT_EQ(r.head.program_version, "0.1.0");
    EXPECT_EQ(r.head.tick_s, 1e-3);
    EXPECT_EQ(r.head.instruments, session::head().instruments);
    ASSERT_EQ(r.head.assets.size(), 1u);
    EXPECT_EQ(r.head.assets[0].name, "m.csv");
    EXPECT_EQ(r.head.assets[0].sha256, std::string(64, 'a'));
    ASSERT_EQ(r.events.size(), 1u);
    EXPECT_EQ(r.events[0].t_s, 1.25);
    EXPECT_EQ(r.events[0].kind, world::EventKind::slip);
    EXPECT_EQ(r.events[0].what, "right");
    EXPECT_EQ(r.events[0].value, 0.75);
    ASSERT_EQ(r.scores.size(), 1u);
    EXPECT_EQ(r.scores[0].why, item.why);
    EXPECT_EQ(r.scores[0].band, "square");
    EXPECT_EQ(r.scores[0].at_s, 2.5);
    EXPECT_FALSE(r.scores[0].passed);
}

// Who played, how fast, with which program, and what was noted: what an assessor asks of a session years later.
TEST(Recording, TheSecondVersionsTablesComeBack) {
    const Folder folder;
    Head head = session::head();
    head.engine = {"5080f11", "GCC 12.2.0", "-O2", "SQLite 3.40.1"};
    head.session = Circumstances{"resident7", "mouse and keys", "wrist snap", true, 0.35, "a machine", "ab12", 4711};
    const PaceRow moved{1000, 1.01, 0.99, 12.5, Delays{4, 9.5}, {}}, still{2000, 2, 1, 0, {}, Delays{40, 81}};
    const Mark mark{1500, "assist", "snap off"};
    {
        Recorder recorder(folder / "a.carrel", head);
        recorder.add_pace(moved);
        recorder.add_mark(mark);
        recorder.add_pace(still);
        recorder.finish();
    }
    const Recording r = load_recording(folder / "a.carrel");
    EXPECT_EQ(r.damage, std::vector<std::string>());
    EXPECT_EQ(r.version, 2);
    EXPECT_EQ(r.head.engine, head.engine);
    EXPECT_EQ(r.head.session, head.session);
    EXPECT_EQ(r.pace, (std::vector{moved, still}));
    EXPECT_EQ(r.marks, std::vector{mark});
}

// What a score shows is rounded; its number is not.
TEST(Recording, NumbersOfScoresComeBackBitForBit) {
    const Folder folder;
    std::vector<drill::ScoreItem> items;
    for (const double number : {0.1 + 0.2, 1e-310, 1.7976931348623157e308, 5.0, std::nextafter(5.0, 6.0)})
        items.push_back({"item", "Item", "0.3", "mm", "", true, 1.2345678901234567, "", number});
    items.insert(items.begin() + 2, drill::ScoreItem{"knot", "Knot", "square", "", "square", true, 2, "", {}});
    {
        Recorder recorder(folder / "a.carrel", session::head());
        recorder.set_scores(items);
        recorder.finish();
    }
    const Recording r = load_recording(folder / "a.carrel");
    EXPECT_EQ(r.damage, std::vector<std::string>());
    EXPECT_EQ(r.scores, items);
}

namespace {

// A file that may not grow beyond so many bytes, as on a disk that fills up.
class FullDisk {
  public:
    FullDisk() {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
    }
    ~FullDisk() { free_up(); }
    void fill_at(rlim_t bytes) {
        const rlimit small{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    void free_up() { setrlimit(RLIMIT_FSIZE, &before_); }

  private:
    rlimit before_{};
};

}  // namespace

// A disk that fills up must not end a session: it goes on, says how much is safe, keeps the rest in memory, and writes
// it once there is room again. What is on disk until then is a true beginning.
TEST(Recording, AFullDiskIsToldAndPlayGoesOn) {
    const Folder folder;
    const auto file = folder / "a.carrel";
    FullDisk disk;
    Recorder recorder(file, session::head(), {.may_wait = false});
    std::uint64_t ticks = 0;
    const auto play = [&](std::uint64_t until) {
        for (; ticks < until; ++ticks) recorder.add_tick(session::tools_at(ticks));
    };
    const auto wait_until = [&](bool is_in_trouble) {
        for (int i = 0; i < 1000 && recorder.trouble().has_value() != is_in_trouble; ++i) usleep(5000);
        return recorder.trouble();
    };
    disk.fill_at(200'000);
    for (int i = 0; i < 100 && !recorder.trouble(); ++i) play(ticks + 500), usleep(20000);
    const auto trouble = wait_until(true);
    ASSERT_TRUE(trouble);
    const Recording half = load_recording(file);
    EXPECT_EQ(half.damage, std::vector<std::string>());
    ASSERT_GT(half.ticks(), 500u);
    std::ostringstream safe;
    safe << file.string() << ": cannot be written (disk I/O error); the first " << std::fixed
         << 1e-3 * static_cast<double>(half.ticks()) << " s are safe on disk";
    EXPECT_EQ(trouble, safe.str());
    play(ticks + 1000);
    EXPECT_THROW(recorder.finish(), std::runtime_error);
    disk.free_up();
    recorder.finish();
    EXPECT_EQ(recorder.trouble(), std::nullopt);
    const Recording whole = load_recording(file);
    EXPECT_EQ(whole.damage, std::vector<std::string>());
    ASSERT_EQ(whole.ticks(), ticks);
    for (std::uint64_t t = 0; t < ticks; ++t) ASSERT_EQ(bits(whole.tick(t)), bits(session::tools_at(t))) << t;
}

// Recordings of earlier programs stay readable. The file is made as they made it: version 1 ends with `finished`.
TEST(Recording, TheFirstVersionIsReadStill) {
    const Folder folder;
    const auto file = folder / "a.carrel";
    session::record(file, 1234);
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
    EXPECT_EQ(
        sqlite3_exec(database,
                     "DROP TABLE engine; DROP TABLE session; DROP TABLE pace; DROP TABLE mark; DROP TABLE measure;"
                     "DROP TABLE chain; DROP TABLE view; PRAGMA user_version=1;"
                     "INSERT INTO score VALUES('knot', 'Knot', 'granny', '', 'square', 0, 2.5, 'Reverse it.');",
                     nullptr, nullptr, nullptr),
        SQLITE_OK);
    sqlite3_close(database);
    const Recording r = load_recording(file);
    EXPECT_EQ(r.damage, std::vector<std::string>());
    EXPECT_EQ(r.version, 1);
    EXPECT_EQ(r.ticks(), 1234u);
    EXPECT_EQ(r.head.session, std::nullopt);
    EXPECT_EQ(r.scores,
              (std::vector<drill::ScoreItem>{{"knot", "Knot", "granny", "", "square", false, 2.5, "Reverse it.", {}}}));
}

// Leaving without finish() is what an exception does: all is kept, and the file says that the session was cut off.
TEST(Recording, UnfinishedSessionIsWholeButSaysSo) {
    const Folder folder;
    session::record(folder / "a.carrel", 777, false);
    const Recording r = load_recording(folder / "a.carrel");
    EXPECT_EQ(r.ticks(), 777u);
    EXPECT_FALSE(r.finished);
    EXPECT_EQ(r.fault("a"), std::nullopt);
}

// A mistyped --record must not cost somebody a drill, nor a database of another program.
TEST(Recording, ReplacesRecordingsButNothingElse) {
    const Folder folder;
    session::record(folder / "a.carrel", 10);
    session::record(folder / "a.carrel", 20);
    EXPECT_EQ(load_recording(folder / "a.carrel").ticks(), 20u);
    std::ofstream(folder / "drill.json") << "{\"carrel_drill\": 1}";
    EXPECT_THROW(Recorder(folder / "drill.json", session::head()), RecordingError);
    EXPECT_EQ(std::filesystem::file_size(folder / "drill.json"), 19u);
    EXPECT_THROW(Recorder(folder / ".", session::head()), RecordingError);
    EXPECT_THROW(Recorder(folder / "no" / "where", session::head()), RecordingError);
}
