#include "scenarios/recording/small_tables.hpp"

#include <cmath>

namespace scenarios::recording {

static std::uint64_t ticks_at(const Statement& row, int column) {
    return static_cast<std::uint64_t>(row.integer(column));
}

void read_scores(Database& database, std::vector<drill::ScoreItem>& scores) {
    Statement row(database, "SELECT name, title, value, unit, band, passed, at_s, why FROM score ORDER BY rowid");
    while (row.step())
        scores.push_back({row.text(0), row.text(1), row.text(2), row.text(3), row.text(4), row.integer(5) != 0,
                          row.real(6), row.text(7)});
}

void read_engine(Database& database, Engine& engine) {
    Statement row(database, "SELECT source, compiler, flags, libraries FROM engine");
    if (row.step()) engine = {row.text(0), row.text(1), row.text(2), row.text(3)};
}

void read_session(Database& database, std::optional<Circumstances>& session) {
    Statement row(database, "SELECT who, device, assists, exam, pace, machine, parent, parent_tick FROM session");
    if (row.step())
        session = {row.text(0), row.text(1), row.text(2), row.integer(3) != 0,
                   row.real(4), row.text(5), row.text(6), ticks_at(row, 7)};
}

static std::optional<Delays> delays_of(const Statement& row, int column) {
    const auto p50 = row.real_or_none(column), p99 = row.real_or_none(column + 1);
    if (!p50 || !p99) return {};
    return Delays{*p50, *p99};
}

void read_pace(Database& database, std::vector<PaceRow>& rows) {
    Statement row(database,
                  "SELECT tick, wall_s, rate, dropped_ms, used_p50_ms, used_p99_ms, shown_p50_ms, shown_p99_ms "
                  "FROM pace ORDER BY rowid");
    while (row.step())
        rows.push_back({ticks_at(row, 0), row.real(1), row.real(2), row.real(3), delays_of(row, 4), delays_of(row, 6)});
}

void read_marks(Database& database, std::vector<Mark>& marks) {
    Statement row(database, "SELECT tick, kind, text FROM mark ORDER BY rowid");
    while (row.step()) marks.push_back({ticks_at(row, 0), row.text(1), row.text(2)});
}

std::vector<std::string> read_numbers(Database& database, double tick_s, std::vector<drill::ScoreItem>& scores) {
    std::vector<std::string> strays;
    Statement row(database, "SELECT place, name, number, unit, at_s, at_tick FROM measure ORDER BY place");
    while (row.step()) {
        const std::uint64_t place = ticks_at(row, 0);
        const bool belongs = place < scores.size() && scores[place].name == row.text(1) &&
                             scores[place].unit == row.text(3) && scores[place].at_s == row.real(4) &&
                             std::llround(row.real(4) / tick_s) == row.integer(5);
        if (belongs)
            scores[place].number = row.real(2);
        else
            strays.push_back(row.text(1));
    }
    return strays;
}

}  // namespace scenarios::recording
