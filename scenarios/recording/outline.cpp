#include "scenarios/recording/outline.hpp"

#include <sys/stat.h>

#include "scenarios/recording/database.hpp"
#include "scenarios/recording/pace.hpp"
#include "scenarios/recording/recording.hpp"
#include "scenarios/recording/small_tables.hpp"

namespace scenarios::recording {

static std::int64_t written_at(const std::filesystem::path& file) {
    struct stat status {};
    return stat(file.c_str(), &status) == 0 ? status.st_mtim.tv_sec : 0;
}

static void read_head(Database& database, Outline& outline) {
    // Of the inputs the last chunk's place alone is looked at: they are nearly all of the file.
    Statement row(database,
                  "SELECT drill_text, drill_name, tick_s, (SELECT count(*) FROM finished), "
                  "(SELECT first_tick + ticks FROM chunk ORDER BY first_tick DESC LIMIT 1) FROM head");
    if (!row.step()) throw DatabaseError("it holds no drill");
    outline.drill_text = row.text(0);
    outline.drill_name = row.text(1);
    outline.duration_s = row.real(2) * static_cast<double>(row.integer(4));
    outline.finished = row.integer(3) > 0;
}

static bool is_of_version_1(Database& database) {
    Statement row(database, "PRAGMA user_version");
    return row.step() && row.integer(0) == 1;
}

static void read_session(Database& database, Outline& outline) {
    Statement session(database,
                      "SELECT exam, pace, assists <> '' OR EXISTS (SELECT 1 FROM mark WHERE (kind = 'assist' AND text "
                      "LIKE '% on') OR (kind = 'pace' AND CAST(text AS REAL) < session.pace)) FROM session");
    if (!session.step()) return;
    outline.exam = session.integer(0) != 0;
    outline.assisted = session.integer(2) != 0;
    std::vector<PaceRow> rows;
    for (Statement row(database, "SELECT rate FROM pace"); row.step();) rows.push_back({.rate = row.real(0)});
    outline.comparable = is_comparable(rows, session.real(1));
}

Outline read_outline(const std::filesystem::path& file) try {
    if (!is_recording(file)) throw DatabaseError("it is not a recording");
    Outline outline;
    outline.recorded_at = written_at(file);
    Database database(file, Database::read);
    read_head(database, outline);
    read_scores(database, outline.scores);
    if (!is_of_version_1(database)) read_session(database, outline);
    return outline;
} catch (const DatabaseError& error) {
    throw RecordingError(file.string() + ": error: cannot be read (" + error.what() + ")");
}

}  // namespace scenarios::recording
