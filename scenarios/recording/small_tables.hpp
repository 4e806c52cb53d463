#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scenarios/recording/database.hpp"
#include "scenarios/recording/recording.hpp"

// Readers of a recording's small tables; all but the scores came with version 2. What was read before one breaks off is
// kept. Each throws DatabaseError.
namespace scenarios::recording {

/// The scores, without their numbers.
void read_scores(Database& database, std::vector<drill::ScoreItem>& scores);
/// The program that simulated the session.
void read_engine(Database& database, Engine& engine);
/// Who played it, and how.
void read_session(Database& database, std::optional<Circumstances>& session);
/// How fast it went.
void read_pace(Database& database, std::vector<PaceRow>& rows);
/// What was noted beside the ticks.
void read_marks(Database& database, std::vector<Mark>& marks);
/// The numbers of scores, which go to those; the names of numbers that belong to none of them. `tick_s`: length of a
/// tick [s].
std::vector<std::string> read_numbers(Database& database, double tick_s, std::vector<drill::ScoreItem>& scores);

}  // namespace scenarios::recording
