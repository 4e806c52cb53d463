#include <charconv>
#include <functional>

#include "scenarios/recording/database.hpp"
#include "scenarios/recording/format.hpp"
#include "scenarios/recording/recording.hpp"
#include "scenarios/recording/small_tables.hpp"

namespace scenarios::recording {

namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
    throw RecordingError(file.string() + ": error: " + what);
}

// Checked before SQLite sees the file: an empty file is an empty database to it, and its words for junk help nobody.
void check_kind(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) fail(file, "no such file");
    if (std::filesystem::is_directory(status)) fail(file, "is a directory, expected a recording");
    if (!std::filesystem::is_regular_file(status)) fail(file, "is not a regular file");
    if (std::filesystem::file_size(file, error) == 0) fail(file, "is empty, expected a recording");
    if (!is_recording(file)) fail(file, "is not a recording");
}

class Loader {
  public:
    explicit Loader(const std::filesystem::path& file) : file_(file), database_(file, Database::read) {}

    Recording load() {
        check_version();
        read_head();
        if (const auto missing = missing_bytes(file_); missing > 0)
            recording_.damage.push_back("the file lacks its last " + std::to_string(missing) + " bytes");
        each("asset", "SELECT name, sha256 FROM asset", [&](Statement& row) {
            recording_.head.assets.push_back({row.text(0), row.text(1)});
        });
        std::optional<std::int64_t> ticks_at_finish;
        each("finished", "SELECT ticks FROM finished", [&](Statement& row) {
            if (ticks_at_finish) recording_.damage.push_back("it is marked as finished more than once");
            ticks_at_finish = row.integer(0);
        });
        each("chunk", "SELECT first_tick, ticks, inputs FROM chunk ORDER BY first_tick",
             [&](Statement& row) { add_chunk(row); });
        each("state_hash", "SELECT tick, hash FROM state_hash ORDER BY tick", [&](Statement& row) { add_hash(row); });
        each("event", "SELECT t_s, kind, what, value FROM event ORDER BY rowid",
             [&](Statement& row) { add_event(row); });
        whole("score", [&] { read_scores(database_, recording_.scores); });
        if (recording_.version >= 2) read_second_version();
        recording_.finished = ticks_at_finish.has_value();
        if (ticks_at_finish && !gap_ && *ticks_at_finish != static_cast<std::int64_t>(recording_.ticks()))
            recording_.damage.push_back("inputs end at tick " + std::to_string(recording_.ticks()) + " of " +
                                        std::to_string(*ticks_at_finish));
        return std::move(recording_);
    }

  private:
    void check_version() {
        Statement row(database_, "PRAGMA user_version");
        const std::int64_t version = row.step() ? row.integer(0) : 0;
        if (version < oldest_version || version > format_version)
            fail(file_, "is a recording of version " + std::to_string(version) + ", this program reads versions " +
                            std::to_string(oldest_version) + " to " + std::to_string(format_version));
        recording_.version = static_cast<int>(version);
    }

    void read_head() {
        Statement row(database_, "SELECT drill_text, drill_name, program_version, tick_s FROM head");
        if (!row.step()) fail(file_, "holds no drill");
        recording_.head = {row.text(0), row.text(1), row.text(2), row.real(3), {}, {}};
        if (row.step()) fail(file_, "holds more than one drill");
        Statement names(database_, "SELECT name FROM instrument ORDER BY place");
        while (names.step()) recording_.head.instruments.push_back(names.text(0));
        const std::size_t tools = recording_.head.instruments.size();
        if (tools < 1 || tools > most_tools)
            fail(file_, "names " + std::to_string(tools) + " instruments, expected 1 to 16");
        if (!(recording_.head.tick_s > 0 && recording_.head.tick_s <= 1)) fail(file_, "has no valid length of a tick");
    }

    void read_second_version() {
        whole("engine", [&] { read_engine(database_, recording_.head.engine); });
        whole("session", [&] { read_session(database_, recording_.head.session); });
        whole("pace", [&] { read_pace(database_, recording_.pace); });
        whole("mark", [&] { read_marks(database_, recording_.marks); });
        whole("measure",
              [&] { recording_.stray_numbers = read_numbers(database_, recording_.head.tick_s, recording_.scores); });
        look_at_unused();
    }

    // What is not used yet is looked at, so that its damage is told.
    void look_at_unused() {
        each("chain", "SELECT 1 FROM chain LIMIT 1", [](Statement&) {});
        each("view", "SELECT 1 FROM view LIMIT 1", [](Statement&) {});
    }

    void whole(const char* table, const std::function<void()>& read) try {
        read();
    } catch (const DatabaseError& error) {
        recording_.damage.push_back(std::string("table ") + table + " breaks off (" + error.what() + ")");
    }

    /// Calls `take` with each row; a table that breaks off is noted and what came before is kept.
    void each(const char* table, const char* sql, const std::function<void(Statement&)>& take) {
        whole(table, [&] {
            Statement row(database_, sql);
            while (row.step()) take(row);
        });
    }

    // A replay needs every tick from the first, so inputs end at the first gap; what lies behind it is told, not used.
    void add_chunk(Statement& row) {
        const std::int64_t first = row.integer(0), ticks = row.integer(1);
        if (gap_) return;
        const auto expected = static_cast<std::int64_t>(recording_.ticks());
        const std::size_t tools = recording_.head.instruments.size();
        if (first != expected)
            return end_inputs("inputs of ticks " + std::to_string(expected) + " to " + std::to_string(first - 1) +
                              " are missing");
        std::vector<instruments::ToolInput> inputs;
        if (ticks > 0 && ticks <= static_cast<std::int64_t>(most_ticks))
            inputs = unpack(row.blob(2), static_cast<std::size_t>(ticks), tools);
        if (inputs.empty()) return end_inputs("inputs from tick " + std::to_string(first) + " on are damaged");
        recording_.inputs.insert(recording_.inputs.end(), inputs.begin(), inputs.end());
    }

    void end_inputs(const std::string& why) {
        gap_ = true;
        recording_.damage.push_back(why);
    }

    void add_hash(Statement& row) {
        const std::string hex = row.text(1);
        TickHash entry{static_cast<std::uint64_t>(row.integer(0)), 0};
        const auto [end, error] = std::from_chars(hex.data(), hex.data() + hex.size(), entry.hash, 16);
        if (error == std::errc() && end == hex.data() + hex.size() && hex.size() == 16)
            recording_.hashes.push_back(entry);
        else
            recording_.damage.push_back("the hash of tick " + std::to_string(entry.tick) + " is damaged");
    }

    void add_event(Statement& row) {
        const std::string name = row.text(1);
        if (const auto kind = world::event_kind(name))
            recording_.events.push_back({row.real(0), *kind, row.text(2), row.real(3)});
        else
            recording_.damage.push_back("there is no event \"" + name + "\"");
    }

    std::filesystem::path file_;
    Database database_;
    Recording recording_;
    bool gap_ = false;
};

}  // namespace

std::optional<std::string> Recording::fault(const std::string& file) const {
    if (damage.empty()) return {};
    std::string line =
        file + ": error: damaged recording, the first " + std::to_string(ticks()) + " ticks are readable: ";
    for (std::size_t i = 0; i < damage.size(); ++i) line += (i == 0 ? "" : "; ") + damage[i];
    return line;
}

Recording load_recording(const std::filesystem::path& file) {
    check_kind(file);
    try {
        return Loader(file).load();
    } catch (const DatabaseError& error) {
        fail(file, std::string("is damaged, not even its drill can be read (") + error.what() + ")");
    }
}

}  // namespace scenarios::recording
