#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "instruments/tool.hpp"
#include "scenarios/drill/result.hpp"
#include "scenarios/recording/pace.hpp"

// A session in one SQLite file: what came in at every tick, bit for bit, the state hashes that prove a replay, and who
// played it, how and with which program.
// Tables and how chunks are packed: scenarios/recording/format.hpp.
namespace scenarios::recording {

/// Why a recording cannot be read, in one line: "file: error: what is wrong, what would be right".
struct RecordingError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A file that the session depends on, and what was in it.
struct Asset {
    std::string name;    ///< Path, as the drill has it.
    std::string sha256;  ///< 64 hex digits.
};

/// Ticks from one stored state hash to the next; the last tick of a session has one too.
constexpr std::uint64_t hash_period = 100;

/// The program that simulated a session: what makes its bits.
struct Engine {
    std::string source;     ///< Commit of its sources, such as "5080f11", with "+" where they were changed since.
    std::string compiler;   ///< "GCC 12.2.0".
    std::string flags;      ///< As given to the compiler.
    std::string libraries;  ///< "Eigen 3.4.0, SQLite 3.40.1": names and versions.

    bool operator==(const Engine&) const = default;
};

using drill::Circumstances;

/// What a session is played with.
struct Head {
    std::string drill_text;                     ///< The drill file itself, byte for byte.
    std::string drill_name;                     ///< What it was called, for messages.
    std::string program_version;                ///< Version of the program that recorded it.
    double tick_s = 1e-3;                       ///< Length of a tick [s].
    std::vector<std::string> instruments;       ///< Names, in the drill's order.
    std::vector<Asset> assets;                  ///< Meshes that it names.
    Engine engine = {};                         ///< The program; empty in recordings of version 1.
    std::optional<Circumstances> session = {};  ///< None in recordings of version 1.
};

/// State of the world after a tick.
struct TickHash {
    std::uint64_t tick;  ///< From 1: after so many ticks.
    std::uint64_t hash;  ///< World::hash() then.
};

/// Something beside the ticks that explains a session: a pause, an assist switched on, a note.
struct Mark {
    std::uint64_t tick = 0;  ///< After so many ticks.
    std::string kind;        ///< "pause", "resume", "pace", "assist", "note" ...
    std::string text;        ///< What of it: "snap on", "0.25" ...

    bool operator==(const Mark&) const = default;
};

/// The libraries that a recording's file depends on, with their versions: "SQLite 3.40.1, zstd 1.5.4".
std::string library_versions();

/// Seconds of a clock that never goes back, for any thread. Decides only when a recorder writes, never what.
using Clock = double (*)();

/// The machine's own clock, which never goes back [s].
double wall_clock();

/// How a recorder goes about it.
struct RecorderOptions {
    Clock clock = wall_clock;  ///< Tells it when to write.
    /// add_tick() waits for the disk where more than a second of simulated time would be lost otherwise: right for
    /// ticks that are made as fast as can be, wrong for those that hands wait for.
    bool may_wait = true;
};

/// Writes a recording while a session runs, on a thread of its own. Whatever was added is handed to the disk after at
/// most 0.5 s of simulated time and at most 0.6 s of wall clock, also if nothing more is added; with the time that the
/// disk takes, a kill at any moment loses no more than a second. After a kill in the middle of a write "FILE-journal"
/// lies beside it: whoever reads the file reads it without that write. What a full disk refuses is kept in memory, some
/// 130 bytes a tick of two tools, and tried again twice a second. Methods may be called from any thread.
class Recorder {
  public:
    /// Opens `file`. An earlier recording there is replaced; anything else is left alone.
    /// Throws RecordingError if it is something else or cannot be written.
    Recorder(const std::filesystem::path& file, const Head& head, RecorderOptions options = {});
    ~Recorder();  ///< Without finish() the recording stays readable, and says that it was cut off.
    Recorder(Recorder&&) noexcept;
    Recorder& operator=(Recorder&&) noexcept;

    /// Adds the inputs of the next tick, one per instrument; before that tick, so that one that crashes or hangs leaves
    /// its cause.
    void add_tick(std::span<const instruments::ToolInput> tools);
    /// Adds the state's hash after so many ticks; one of the same tick is replaced.
    void add_hash(std::uint64_t tick, std::uint64_t hash);
    /// Adds what happened; events are added in order.
    void add_event(const world::Event& event);
    /// Adds something beside the ticks.
    void add_mark(const Mark& mark);
    /// Adds how fast a second went.
    void add_pace(const PaceRow& row);
    /// Why what was added last is not on disk, in one line that says how much is safe; none: all is well so far.
    std::optional<std::string> trouble() const;

    /// Sets the score so far; it replaces the one before.
    void set_scores(const std::vector<drill::ScoreItem>& items);
    /// Marks the session complete; on disk with all that was added when this returns. Throws std::runtime_error with
    /// the line of trouble() when the file cannot be written (disk full).
    void finish();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// What a recording holds, or what could be saved of it.
struct Recording {
    Head head;                                   ///< What the session was played with.
    std::vector<instruments::ToolInput> inputs;  ///< Whole ticks from the first without a gap, one per instrument each.
    std::vector<TickHash> hashes;                ///< In order of ticks.
    std::vector<world::Event> events;            ///< In the order in which they happened.
    std::vector<drill::ScoreItem> scores;        ///< The last that were set; in version 1 without their numbers.
    std::vector<std::string> stray_numbers;      ///< Names of numbers that belong to none of them; none in a true file.
    std::vector<PaceRow> pace;                   ///< In order of ticks; none of a session that was not live.
    std::vector<Mark> marks;                     ///< In the order in which they were made.
    int version = 0;                             ///< Of its format.
    bool finished = false;            ///< The session ended by itself; false after a kill, which is no damage.
    std::vector<std::string> damage;  ///< What is missing or damaged, a phrase each; empty for a good file.

    /// How many ticks there are inputs of.
    std::uint64_t ticks() const { return head.instruments.empty() ? 0 : inputs.size() / head.instruments.size(); }
    /// The inputs of tick `t`, from 0, one per instrument.
    std::span<const instruments::ToolInput> tick(std::uint64_t t) const {
        return std::span(inputs).subspan(t * head.instruments.size(), head.instruments.size());
    }
    /// Whether it went as fast as its drill declares, so that its scores may be held against others'.
    bool is_comparable() const { return !head.session || recording::is_comparable(pace, head.session->pace); }
    /// The one line for a person, or nothing if all is there.
    std::optional<std::string> fault(const std::string& file) const;
};

/// Reads a recording, also a damaged one (see `damage`), and writes neither to it nor beside it. Throws RecordingError
/// when not even its drill can be read: missing, a directory, not a recording, another version.
Recording load_recording(const std::filesystem::path& file);

}  // namespace scenarios::recording
