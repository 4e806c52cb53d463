#include "scenarios/recording/recording.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

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
