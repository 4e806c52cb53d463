#include <gtest/gtest.h>
#include <sqlite3.h>

#include <set>

#include "tests/app/commands/still.hpp"
#include "tests/program.hpp"

// Recordings that were changed, added to, cut off or only looked at.
namespace recordings {

// The beginning of the square drill's motion, in which its left tool grasps the thread.
std::string grasp() {
    constexpr double until = 0.3;  // [s]
    std::ifstream whole(CARREL_SOURCE "/scenarios/drills/square-knot.csv");
    std::string text, line;
    std::getline(whole, text);
    text += "\n";
    while (std::getline(whole, line) && std::stod(line) <= until) text += line + "\n";
    return text;
}

class Recordings : public ::testing::Test {
  protected:
    // Recorded once, for all tests.
    static void SetUpTestSuite() {
        folder_ = new program::Folder;
        const std::string motion = folder_->write("m.csv", grasp());
        ASSERT_EQ(program::run({"run", still::drill, "--input", motion, "--record", good()}).exit, 0);
    }
    static void TearDownTestSuite() { delete folder_; }

    static std::string good() { return folder_->path("good.carrel"); }
    static std::string bad() { return folder_->path("bad.carrel"); }

    static program::Ending verify_changed(const std::string& sql) {
        std::filesystem::copy_file(good(), bad(), std::filesystem::copy_options::overwrite_existing);
        sqlite3* db = nullptr;
        EXPECT_EQ(sqlite3_open(bad().c_str(), &db), SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(db);
        EXPECT_GE(sqlite3_total_changes(db), 1) << "nothing was changed";
        sqlite3_close(db);
        return program::run({"replay", "--verify", bad()});
    }

    static program::Folder* folder_;
};

program::Folder* Recordings::folder_ = nullptr;

// Changes of one row each, with what is said of them.
std::vector<std::pair<std::string, std::string>> changes() {
    const std::string last_hash = "tick = (SELECT max(tick) FROM state_hash)",
                      last_chunk = "first_tick = (SELECT max(first_tick) FROM chunk)";
    return {
        {"INSERT INTO head SELECT * FROM head", "holds more than one drill"},
        {"DELETE FROM head", "holds no drill"},
        {"UPDATE head SET drill_text = replace(drill_text, '141', '142')", "the state differs"},
        {"UPDATE head SET drill_text = replace(drill_text, '\"around\"', '\"aroundd\"')", "the drill in it is damaged"},
        {"UPDATE head SET tick_s = 0.002", "its ticks are not as long"},
        {"INSERT INTO instrument VALUES(2, 'third')", "damaged recording"},
        {"DELETE FROM instrument WHERE place = 1", "damaged recording"},
        {"UPDATE instrument SET name = 'other' WHERE place = 0", "its inputs are of other instruments"},
        {"INSERT INTO asset VALUES('mesh.obj', 'aa')", "notes more meshes than the drill in it names"},
        {"INSERT INTO chunk SELECT 100000, ticks, inputs FROM chunk WHERE " + last_chunk, "are missing"},
        {"INSERT INTO chunk SELECT first_tick + ticks, ticks, inputs FROM chunk WHERE " + last_chunk, "inputs end at"},
        {"DELETE FROM chunk WHERE " + last_chunk, "inputs end at tick"},
        {"DELETE FROM chunk WHERE first_tick = 0", "inputs of ticks 0 to"},
        {"UPDATE chunk SET inputs = zeroblob(99) WHERE " + last_chunk, "are damaged"},
        {"UPDATE chunk SET first_tick = first_tick + 1 WHERE " + last_chunk, "are missing"},
        {"UPDATE chunk SET ticks = ticks - 1 WHERE " + last_chunk, "are damaged"},
        {"INSERT INTO state_hash SELECT 150, hash FROM state_hash WHERE tick = 100", "tick 150: the state differs"},
        {"INSERT INTO state_hash SELECT 999999, hash FROM state_hash WHERE tick = 100", "of its state hashes belong"},
        {"DELETE FROM state_hash WHERE " + last_hash, "of its state hashes belong"},
        {"DELETE FROM state_hash WHERE tick = 100", "of its state hashes belong"},
        {"UPDATE state_hash SET hash = '0123456789abcdef' WHERE " + last_hash, "the state differs"},
        {"UPDATE state_hash SET tick = tick - 1 WHERE " + last_hash, "the state differs"},
        {"INSERT INTO event SELECT * FROM event LIMIT 1", "replayed nothing"},
        {"INSERT INTO event VALUES(0.5, 'grasp', 'left', 1)", "replayed nothing"},
        {"DELETE FROM event WHERE rowid = 1", "the events differ"},
        {"DELETE FROM event", "recorded nothing"},
        {"UPDATE event SET t_s = t_s + 0.001 WHERE rowid = 1", "the events differ"},
        {"UPDATE event SET kind = 'release' WHERE rowid = 1", "the events differ"},
        {"UPDATE event SET what = 'nobody' WHERE rowid = 1", "the events differ"},
        {"UPDATE event SET value = value + 1e-9 WHERE rowid = 1", "the events differ"},
        {"INSERT INTO score SELECT * FROM score LIMIT 1", "replayed nothing"},
        {"DELETE FROM score WHERE rowid = 1", "the scores differ"},
        {"DELETE FROM score", "recorded nothing"},
        {"UPDATE score SET name = 'bow' WHERE name = 'knot'", "the scores differ"},
        {"UPDATE score SET title = 'Bow' WHERE name = 'knot'", "the scores differ"},
        {"UPDATE score SET value = 'square' WHERE name = 'knot'", "the scores differ"},
        {"UPDATE score SET unit = 'N' WHERE name = 'time'", "the scores differ"},
        {"UPDATE score SET band = '' WHERE name = 'knot'", "the scores differ"},
        {"UPDATE score SET passed = 1 - passed WHERE name = 'time'", "the scores differ"},
        {"UPDATE score SET at_s = at_s + 1e-9 WHERE name = 'tension'", "the scores differ"},
        {"UPDATE score SET why = 'well done' WHERE name = 'knot'", "the scores differ"},
        {"UPDATE measure SET number = number + 1e-9 WHERE name = 'tension'", "the scores differ"},
        {"DELETE FROM measure WHERE name = 'tension'", "the scores differ"},
        {"UPDATE measure SET name = 'lag' WHERE name = 'tension'", "the scores differ"},
        {"UPDATE measure SET unit = 'mm' WHERE name = 'tension'", "the scores differ"},
        {"UPDATE measure SET at_s = at_s + 1e-9 WHERE name = 'tension'", "the scores differ"},
        {"UPDATE measure SET at_tick = at_tick + 1 WHERE name = 'tension'", "the scores differ"},
        {"INSERT INTO measure SELECT 1000, name, number, unit, at_s, at_tick FROM measure WHERE name = 'tension'",
         "the measure \"tension\" belongs to no score"},
        {"INSERT INTO finished SELECT * FROM finished", "marked as finished more than once"},
        {"UPDATE finished SET ticks = ticks - 1", "inputs end at tick"}};
}

// A row of every table added, removed and changed, each field of it: what is verified is what was played, and all of
// it.
TEST_F(Recordings, EveryChangeOfARowIsNoticed) {
    ASSERT_EQ(program::run({"replay", "--verify", good()}).exit, 0);
    for (const auto& [sql, said] : changes()) {
        const auto ending = verify_changed(sql);
        SCOPED_TRACE(sql + "\n" + ending.said);
        EXPECT_TRUE(ending.exit == 2 || ending.exit == 3) << ending.exit;
        EXPECT_NE(ending.said.find(said), std::string::npos);
        EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1);
    }
    const auto unfinished = verify_changed("DELETE FROM finished");
    EXPECT_EQ(unfinished.exit, 0);
    EXPECT_NE(unfinished.said.find("it was broken off there, so that no score counts"), std::string::npos);
    for (const char* sql : {"DELETE FROM finished; INSERT INTO event SELECT * FROM event LIMIT 1",
                            "DELETE FROM finished; UPDATE event SET what = 'nobody' WHERE rowid = 1"})
        EXPECT_EQ(verify_changed(sql).exit, 3) << sql;
}

// Recordings of version 1, which have neither numbers nor anything that came with them, verify as they did.
TEST_F(Recordings, OneOfTheFirstVersionVerifies) {
    const auto ending = verify_changed(
        "DROP TABLE engine; DROP TABLE session; DROP TABLE pace; DROP TABLE mark; DROP TABLE measure; DROP TABLE chain;"
        "DROP TABLE view; PRAGMA user_version = 1; UPDATE finished SET ticks = ticks");
    EXPECT_EQ(ending.exit, 0) << ending.said;
    EXPECT_NE(ending.said.find("stored hashes equal, and all scores and events"), std::string::npos) << ending.said;
}

// A page short, as a full stick leaves it, or padded with zeros: the readable part is played, and what is missing said.
TEST_F(Recordings, OneThatWasCutOffIsReadAsFarAsItGoes) {
    const std::string bytes = program::read(good());
    for (const std::size_t lost : {std::size_t{4096}, std::size_t{1000}})
        for (const bool padded : {false, true}) {
            std::string cut = bytes.substr(0, bytes.size() - lost);
            if (padded) cut.resize(bytes.size(), '\0');
            folder_->write("bad.carrel", cut);
            for (const auto& call : {std::vector<std::string>{"replay", bad()}, {"replay", "--verify", bad()}}) {
                const auto ending = program::run(call);
                SCOPED_TRACE(ending.said);
                program::expect_one_line_naming(bad() + ": error: damaged recording, the first ", ending);
                EXPECT_EQ(
                    ending.said.find("the file lacks its last " + std::to_string(lost) + " bytes") != std::string::npos,
                    !padded);
            }
            EXPECT_EQ(program::read(bad()), cut);
        }
}

// Whoever replays, verifies or draws a recording leaves it and its folder as they are.
TEST_F(Recordings, ReadingOneWritesNothing) {
    const program::Folder folder, elsewhere;
    const std::string file = folder.path("a.carrel");
    std::filesystem::copy_file(good(), file);
    const auto written = std::filesystem::last_write_time(file);
    for (const auto& call : {std::vector<std::string>{"replay", file},
                             {"replay", "--verify", file},
                             {"render", file, "--at", "0.1", "--out", elsewhere.path("a.png")}})
        EXPECT_EQ(program::run(call).exit, 0) << call[0];
    EXPECT_EQ(program::read(file), program::read(good()));
    EXPECT_EQ(std::filesystem::last_write_time(file), written);
    int entries = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path(""))) ++entries;
    EXPECT_EQ(entries, 1);
}

}  // namespace recordings
