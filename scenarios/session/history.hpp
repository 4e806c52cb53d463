#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scenarios/drill/history_key.hpp"
#include "scenarios/drill/result.hpp"

// What a resident did before, read from her recordings themselves: there is no other place where scores are kept.
namespace scenarios::session {

/// One session at a drill.
struct Attempt {
    std::filesystem::path file;  ///< Its recording.
    std::string key;          ///< What drill::history_key() says of its drill; empty: the drill in it cannot be read.
    std::string drill_title;  ///< As the drill in it has it.
    std::int64_t recorded_at = 0;         ///< When it ended [s since 1970, UTC].
    double duration_s = 0;                ///< Simulated time [s].
    bool finished = false;                ///< It ended by itself, not by a kill.
    bool passed = false;                  ///< It ended, and every item that is judged passed.
    bool exam = false;                    ///< Played as an exam.
    bool assisted = false;                ///< An assist was on for a time.
    bool comparable = true;               ///< It was played as fast as the drill is meant to be.
    std::vector<drill::ScoreItem> items;  ///< In the order in which they were scored.

    /// How many items were missed.
    std::size_t missed() const;
};

/// Reads one attempt. Throws recording::RecordingError, one line, when that cannot be done.
Attempt read_attempt(const std::filesystem::path& file);

/// All attempts among the files of a folder that end in ".carrel", in order of time; none where there is no such
/// folder. What cannot be read is left out, and `unreadable`, where given, gets its line. Cost: a thousand recordings
/// in 1 to 2 s from a disk that nobody has looked at for long, half of that again; read on four threads.
std::vector<Attempt> attempts_in(const std::filesystem::path& folder, std::vector<std::string>* unreadable = nullptr);

/// Those at the drill of this key, in the same order.
std::vector<Attempt> attempts_at(std::span<const Attempt> attempts, const std::string& key);

/// What attempts of one sort came to. One that was broken off counts only where it was an exam.
struct Tally {
    std::size_t tries = 0, passes = 0;  ///< How many.
    std::size_t passes_in_a_row = 0;    ///< The last so many tries were all passed.
    std::optional<std::size_t> best;    ///< Index of the try with the fewest misses, of those the shortest.
};

/// What a menu says of a drill. Scores with and without help, and those of slow computers, are never mixed.
struct Summary {
    Tally unassisted;              ///< Without any assist, fast enough to be compared.
    Tally assisted;                ///< With assists, fast enough to be compared.
    std::size_t incomparable = 0;  ///< Slower than the drill is meant to be: kept and shown, never a best.
    std::int64_t last_at = 0;      ///< When the last attempt of any sort ended [s since 1970, UTC]; 0: there is none.
};

/// Sums up attempts at one drill, in order of time.
Summary summary(std::span<const Attempt> attempts);

/// The last values of one item, oldest first, at most `most`: what a plot shows. Attempts in which it is no number are
/// left out.
std::vector<double> last_values(std::span<const Attempt> attempts, const std::string& item, std::size_t most = 10);

}  // namespace scenarios::session
