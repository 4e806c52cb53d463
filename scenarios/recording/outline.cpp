#include "scenarios/recording/outline.hpp"

#include <sys/stat.h>

#include "scenarios/recording/database.hpp"
#include "scenarios/recording/recording.hpp"

namespace scenarios::recording {

static std::int64_t written_at(const std::filesystem::path& file) {
    struct stat status {};
    return stat(file.c_str(), &status) == 0 ? status.st_mtim.tv_sec : 0;
}

static void read_head(Database& database, Outline& outline) {
    Statement row(database,
                  "SELECT drill_text, drill_name, tick_s, "
                  "(SELECT max(first_tick + ticks) FROM chunk), (SELECT count(*) FROM finished) FROM head");
    if (!row.step()) throw DatabaseError("it holds no drill");
    outline.drill_text = row.text(0);
    outline.drill_name = row.text(1);
    outline.duration_s = row.real(2) * static_cast<double>(row.integer(3));
    outline.finished = row.integer(4) > 0;
}

static void read_scores(Database& database, Outline& outline) {
    Statement row(database, "SELECT name, title, value, unit, band, passed, at_s, why FROM score ORDER BY rowid");
    while (row.step())
        outline.scores.push_back({row.text(0), row.text(1), row.text(2), row.text(3), row.text(4), row.integer(5) != 0,
                                  row.real(6), row.text(7)});
}

Outline read_outline(const std::filesystem::path& file) try {
    if (!is_recording(file)) throw DatabaseError("it is not a recording");
    Outline outline;
    outline.recorded_at = written_at(file);
    Database database(file, Database::read);
    read_head(database, outline);
    read_scores(database, outline);
    return outline;
} catch (const DatabaseError& error) {
    throw RecordingError(file.string() + ": error: cannot be read (" + error.what() + ")");
}

}  // namespace scenarios::recording
