#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>
#include <functional>
#include <sstream>

#include "tests/scenarios/recording/session.hpp"

using namespace scenarios::recording;
using session::Folder;

namespace {

std::string contents(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

void write(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

void sql(const std::filesystem::path& file, const std::string& statements) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
    char* error = nullptr;
    EXPECT_EQ(sqlite3_exec(database, statements.c_str(), nullptr, nullptr, &error), SQLITE_OK) << error;
    sqlite3_close(database);
}

std::string refusal(const std::filesystem::path& file) {
    try {
        load_recording(file);
        return "";
    } catch (const RecordingError& error) {
        const std::string line = error.what(), name = file.string() + ": error: ";
        return line.starts_with(name) ? line.substr(name.size()) : line;
    }
}

// A good prefix of the session: what a damaged file gives must still be what was played.
void expect_prefix(const Recording& r) {
    for (std::uint64_t t = 0; t < r.ticks(); ++t)
        ASSERT_EQ(session::bits(r.tick(t)), session::bits(session::tools_at(t))) << t;
    for (const TickHash& h : r.hashes) ASSERT_EQ(h.hash, session::hash_at(h.tick));
}

}  // namespace

// Nothing can be saved: one line says why, and none is taken for a recording.
TEST(DamagedRecording, WhatCannotBeReadAtAll) {
    const Folder folder;
    const auto file = folder / "a";
    EXPECT_EQ(refusal(file), "no such file");
    EXPECT_EQ(refusal(folder / "."), "is a directory, expected a recording");
    write(file, "");
    EXPECT_EQ(refusal(file), "is empty, expected a recording");
    write(file, "{\"carrel_drill\": 1}");
    EXPECT_EQ(refusal(file), "is not a recording");
    write(file, std::string(100000, '\x5a'));
    EXPECT_EQ(refusal(file), "is not a recording");
    std::filesystem::remove(file);
    sql(file, "CREATE TABLE chunk(a)");
    EXPECT_EQ(refusal(file), "is not a recording");  // another program's database
    session::record(folder / "b", 1000);
    write(file, contents(folder / "b").substr(0, 90));
    EXPECT_TRUE(refusal(file).starts_with("is damaged, not even its drill can be read")) << refusal(file);
    sql(folder / "b", "PRAGMA user_version=7");
    EXPECT_EQ(refusal(folder / "b"), "is a recording of version 7, this program reads versions 1 to 2");
}

struct Wound {
    std::string sql;
    std::uint64_t ticks;
    std::string damage;
};

// Each wound names what is gone and keeps what is before it; read on behind a gap, a replay would show another session.
TEST(DamagedRecording, KeepsWhatIsReadableAndSaysWhatIsNot) {
    const Wound wounds[] = {
        {"DELETE FROM chunk WHERE first_tick = 1000", 1000, "inputs of ticks 1000 to 1499 are missing"},
        {"DELETE FROM chunk WHERE first_tick = 2500", 2500, "inputs end at tick 2500 of 3000"},
        {"UPDATE finished SET ticks = -1", 3000, "inputs end at tick 3000 of -1"},
        {"DELETE FROM chunk", 0, "inputs end at tick 0 of 3000"},
        {"UPDATE chunk SET inputs = x'00112233' WHERE first_tick = 500", 500, "inputs from tick 500 on are damaged"},
        {"UPDATE chunk SET inputs = x'' WHERE first_tick = 500", 500, "inputs from tick 500 on are damaged"},
        {"UPDATE chunk SET inputs = substr(inputs, 1, length(inputs) - 1) WHERE first_tick = 500", 500,
         "inputs from tick 500 on are damaged"},
        {"UPDATE chunk SET inputs = 'text' WHERE first_tick = 0", 0, "inputs from tick 0 on are damaged"},
        {"UPDATE chunk SET ticks = 1000000000000 WHERE first_tick = 500", 500, "inputs from tick 500 on are damaged"},
        {"UPDATE chunk SET ticks = -5 WHERE first_tick = 500", 500, "inputs from tick 500 on are damaged"},
        {"UPDATE state_hash SET hash = 'zz' WHERE tick = 199", 3000, "the hash of tick 199 is damaged"},
        {"UPDATE state_hash SET hash = substr(hash, 1, 15) WHERE tick = 199", 3000, "the hash of tick 199 is damaged"},
        {"DROP TABLE event", 3000, "table event breaks off (no such table: event)"},
    };
    const Folder folder;
    session::record(folder / "good", 3000);
    const std::string good = contents(folder / "good");
    for (const Wound& wound : wounds) {
        SCOPED_TRACE(wound.sql);
        write(folder / "a", good);
        sql(folder / "a", wound.sql);
        const Recording r = load_recording(folder / "a");
        EXPECT_EQ(r.ticks(), wound.ticks);
        EXPECT_EQ(r.damage, std::vector<std::string>{wound.damage});
        EXPECT_EQ(r.fault("a"), "a: error: damaged recording, the first " + std::to_string(wound.ticks) +
                                    " ticks are readable: " + wound.damage);
        expect_prefix(r);
    }
}

// One flipped bit inside compressed inputs decompresses to plausible numbers unless the checksum is looked at.
TEST(DamagedRecording, FlippedBitsInInputsAreFound) {
    const Folder folder;
    session::record(folder / "good", 1000);
    const std::string good = contents(folder / "good");
    const std::size_t frame = good.find("\x28\xb5\x2f\xfd");  // zstd's magic number
    ASSERT_NE(frame, std::string::npos);
    for (std::size_t at = frame; at < frame + 2000; at += 97) {
        SCOPED_TRACE(at);
        std::string bad = good;
        bad[at] ^= 0x10;
        write(folder / "a", bad);
        const Recording r = load_recording(folder / "a");
        EXPECT_FALSE(r.damage.empty());
        expect_prefix(r);
    }
}

// A disk that filled up or a copy that stopped: cut at every eighth of the file, and with junk in every page.
TEST(DamagedRecording, CutOrOverwrittenFilesGiveAPrefixOrARefusal) {
    const Folder folder;
    session::record(folder / "good", 4000);
    const std::string good = contents(folder / "good");
    const auto judge = [&](const std::string& bytes) {
        write(folder / "a", bytes);
        try {
            const Recording r = load_recording(folder / "a");
            expect_prefix(r);
            return r.fault("a").has_value();
        } catch (const RecordingError& error) {
            return std::string(error.what()).find('\n') == std::string::npos;
        }
    };
    for (std::size_t eighth = 1; eighth < 8; ++eighth)
        EXPECT_TRUE(judge(good.substr(0, eighth * good.size() / 8))) << eighth;
    int noticed = 0, pages = 0;
    for (std::size_t page = 0; page + 4096 <= good.size(); page += 4096, ++pages) {
        std::string bad = good;
        std::mt19937 random(static_cast<unsigned>(page));
        for (std::size_t i = page; i < page + 4096; ++i) bad[i] = static_cast<char>(random());
        noticed += judge(bad);
    }
    EXPECT_EQ(noticed, pages);
}

// A copy that stopped early (a full stick, a broken download) lost its end and nothing else. Cut anywhere behind the
// drill, or padded with zeros to its length, the ticks before are read, and what is missing is said.
TEST(DamagedRecording, ACutOffFileKeepsWhatIsBefore) {
    const Folder folder;
    session::record(folder / "good", 8000);
    const std::string good = contents(folder / "good");
    constexpr std::size_t page = 4096;
    const std::size_t pages = good.size() / page;
    ASSERT_GT(pages, 20u);
    std::uint64_t most = 0;
    for (const std::size_t lost : {1ul, 100ul, page, page + 1, 2 * page, 5 * page, pages / 2 * page}) {
        SCOPED_TRACE(lost);
        std::uint64_t ticks[2];
        for (const bool padded : {false, true}) {
            std::string cut = good.substr(0, good.size() - lost);
            if (padded) cut.resize(good.size(), '\0');
            write(folder / "a", cut);
            const Recording r = load_recording(folder / "a");
            expect_prefix(r);
            ticks[padded] = r.ticks();
            ASSERT_TRUE(r.fault("a"));
            EXPECT_EQ(
                r.fault("a")->find("the file lacks its last " + std::to_string(lost) + " bytes") != std::string::npos,
                !padded)
                << *r.fault("a");
            EXPECT_EQ(contents(folder / "a"), cut) << "it was only to be read";
        }
        EXPECT_EQ(ticks[0], ticks[1]);
        most = std::max(most, ticks[0]);
        // Inputs come in order, so that a share of the file holds about as great a share of them, a chunk or two less.
        EXPECT_GE(ticks[0] + 1500, 8000 * (good.size() - lost) / good.size());
    }
    EXPECT_GE(most, 7000u);
}

// Whoever looks at a recording must leave it as it is: its sum may have been noted, its disk may be read-only. After a
// kill in the middle of a commit it is read as it was before that, and its journal stays.
TEST(DamagedRecording, ReadingWritesNothing) {
    const Folder folder;
    const auto file = folder / "a", journal = folder / "a-journal";
    session::record(file, 2000, false);
    const std::string before = contents(file);
    std::filesystem::create_directory(folder / "kept");
    {
        sqlite3* database = nullptr;
        ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
        // A cache of one page brings the change to the file before it is committed, as a large one does by itself.
        ASSERT_EQ(sqlite3_exec(database,
                               "PRAGMA cache_size = 1; PRAGMA cache_spill = 1; BEGIN; UPDATE chunk SET inputs = "
                               "zeroblob(9000); DELETE FROM state_hash;",
                               nullptr, nullptr, nullptr),
                  SQLITE_OK);
        for (const char* ending : {"a", "a-journal"})
            std::filesystem::copy_file(folder / ending, folder / ("kept/" + std::string(ending)));
        sqlite3_close(database);
    }
    const auto killed = folder / "kept/a";
    const std::string half_written = contents(killed), killed_journal = contents(folder / "kept/a-journal");
    ASSERT_NE(half_written, before) << "nothing was spilled";
    const Recording r = load_recording(killed);
    EXPECT_EQ(r.ticks(), 2000u);
    EXPECT_EQ(r.damage, std::vector<std::string>());
    EXPECT_EQ(r.hashes.size(), 20u);
    EXPECT_EQ(contents(killed), half_written);
    EXPECT_EQ(contents(folder / "kept/a-journal"), killed_journal);
    EXPECT_FALSE(std::filesystem::exists(journal));
    const auto written = std::filesystem::last_write_time(file);
    load_recording(file);
    EXPECT_EQ(contents(file), before);
    EXPECT_EQ(std::filesystem::last_write_time(file), written);
    int entries = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder / "kept")) ++entries;
    EXPECT_EQ(entries, 2);
}
