#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/drill/result.hpp"

namespace scenarios::recording {

/// What a recording says of its session without its inputs: little to read of a large file.
struct Outline {
    std::string drill_text, drill_name;    ///< As in Head.
    double duration_s = 0;                 ///< Simulated time that was recorded [s].
    std::int64_t recorded_at = 0;          ///< When the file was last written [s since 1970, UTC].
    bool finished = false;                 ///< The session ended by itself.
    bool exam = false;                     ///< It was an exam.
    bool assisted = false;                 ///< An assist was on for a time, or it was played slower than its pace.
    bool comparable = true;                ///< As is_comparable() says of its pace.
    std::vector<drill::ScoreItem> scores;  ///< The last that were set.
};

/// Reads a recording's outline, of format 1 or later, and writes neither to it nor beside it. Throws RecordingError
/// when that cannot be done. Cost: a fifth of a millisecond where the disk is not waited for.
Outline read_outline(const std::filesystem::path& file);

}  // namespace scenarios::recording
