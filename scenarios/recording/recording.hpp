#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "instruments/tool.hpp"
#include "scenarios/drill/result.hpp"

// A session in one SQLite file: what came in at every tick, bit for bit, and the state hashes that prove a replay.
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

/// What a session is played with.
struct Head {
    std::string drill_text;                ///< The drill file itself, byte for byte.
    std::string drill_name;                ///< What it was called, for messages.
    std::string program_version;           ///< Version of the program that recorded it.
    double tick_s = 1e-3;                  ///< Length of a tick [s].
    std::vector<std::string> instruments;  ///< Names, in the drill's order.
    std::vector<Asset> assets;             ///< Meshes that it names.
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

/// Seconds of a clock that never goes back. Decides only when a recorder writes, never what.
using Clock = double (*)();

/// The machine's own clock, which never goes back [s].
double wall_clock();

/// Writes a recording while a session runs. Whatever was added is in the file after at most 0.5 s of simulated time and
/// at most 0.5 s of wall clock between two add_tick calls; a kill at any moment loses no more. After a kill in the
/// middle of a write "FILE-journal" lies beside it: whoever reads the file reads it without that write.
class Recorder {
  public:
    /// Opens `file`. An earlier recording there is replaced; anything else is left alone.
    /// Throws RecordingError if it is something else, std::runtime_error if it cannot be written.
    Recorder(const std::filesystem::path& file, const Head& head, Clock clock = wall_clock);
    ~Recorder();  ///< Without finish() the recording stays readable, and says that it was cut off.
    Recorder(Recorder&&) noexcept;
    Recorder& operator=(Recorder&&) noexcept;

    // Each throws std::runtime_error, which says how much is safe, when the file cannot be written (disk full).
    /// Adds the inputs of the next tick, one per instrument.
    void add_tick(std::span<const instruments::ToolInput> tools);
    /// Adds the state's hash after so many ticks; one of the same tick is replaced.
    void add_hash(std::uint64_t tick, std::uint64_t hash);
    /// Adds what happened; events are added in order.
    void add_event(const world::Event& event);
    /// Sets the score so far; it replaces the one before, and is on disk when this returns.
    void set_scores(const std::vector<drill::ScoreItem>& items);
    /// Writes the rest and marks the session complete.
    void finish();

  private:
    struct Impl;
    Impl* impl_;
};

/// What a recording holds, or what could be saved of it.
struct Recording {
    Head head;                                   ///< What the session was played with.
    std::vector<instruments::ToolInput> inputs;  ///< Whole ticks from the first without a gap, one per instrument each.
    std::vector<TickHash> hashes;                ///< In order of ticks.
    std::vector<world::Event> events;            ///< In the order in which they happened.
    std::vector<drill::ScoreItem> scores;        ///< The last that were set.
    bool finished = false;            ///< The session ended by itself; false after a kill, which is no damage.
    std::vector<std::string> damage;  ///< What is missing or damaged, a phrase each; empty for a good file.

    /// How many ticks there are inputs of.
    std::uint64_t ticks() const { return head.instruments.empty() ? 0 : inputs.size() / head.instruments.size(); }
    /// The inputs of tick `t`, from 0, one per instrument.
    std::span<const instruments::ToolInput> tick(std::uint64_t t) const {
        return std::span(inputs).subspan(t * head.instruments.size(), head.instruments.size());
    }
    /// The one line for a person, or nothing if all is there.
    std::optional<std::string> fault(const std::string& file) const;
};

/// Reads a recording, also a damaged one (see `damage`), and writes neither to it nor beside it. Throws RecordingError
/// when not even its drill can be read: missing, a directory, not a recording, another version.
Recording load_recording(const std::filesystem::path& file);

}  // namespace scenarios::recording
