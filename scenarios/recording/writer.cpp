#include "scenarios/recording/writer.hpp"

#include <cmath>
#include <cstdio>

#include "scenarios/recording/format.hpp"

namespace scenarios::recording {

bool Batch::is_empty() const {
    return inputs.empty() && hashes.empty() && events.empty() && marks.empty() && pace.empty() && !scores && !finishes;
}

// A rollback journal keeps all that is committed in the one file; a write-ahead log would leave up to a whole session
// beside it. NORMAL waits for the disk so that a power cut does not corrupt the file either.
Writer::Writer(const std::filesystem::path& file, const Head& head)
    : database_(file, Database::create), tools_(head.instruments.size()), tick_s_(head.tick_s) {
    database_.run("PRAGMA journal_mode=DELETE; PRAGMA synchronous=NORMAL; BEGIN");
    database_.run("PRAGMA application_id=" + std::to_string(application_id));
    database_.run("PRAGMA user_version=" + std::to_string(format_version));
    database_.run(head_tables);
    write_head(head);
    database_.run(other_tables);
    write_engine(head.engine);
    if (head.session) write_session(*head.session);
    database_.run("COMMIT");
}

void Writer::write_head(const Head& head) {
    Statement(database_, "INSERT INTO head VALUES(?,?,?,?)")
        .bind(head.drill_text, head.drill_name, head.program_version, head.tick_s)
        .step();
    for (std::size_t i = 0; i < tools_; ++i)
        Statement(database_, "INSERT INTO instrument VALUES(?,?)")
            .bind(static_cast<std::int64_t>(i), head.instruments[i])
            .step();
    for (const Asset& asset : head.assets)
        Statement(database_, "INSERT INTO asset VALUES(?,?)").bind(asset.name, asset.sha256).step();
}

void Writer::write_engine(const Engine& engine) {
    Statement(database_, "INSERT INTO engine VALUES(?,?,?,?)")
        .bind(engine.source, engine.compiler, engine.flags, engine.libraries)
        .step();
}

void Writer::write_session(const Circumstances& session) {
    Statement(database_, "INSERT INTO session VALUES(?,?,?,?,?,?,?,?)")
        .bind(session.who, session.device, session.assists, static_cast<std::int64_t>(session.exam), session.pace,
              session.machine, session.parent, static_cast<std::int64_t>(session.parent_tick))
        .step();
}

void Writer::write(std::span<const Batch> batches) try {
    ticks_ = saved_ticks_;
    database_.run("BEGIN");
    for (const Batch& batch : batches) {
        write_inputs(batch);
        write_what_happened(batch);
        for (const PaceRow& row : batch.pace) write_pace(row);
        if (batch.scores) write_scores(*batch.scores);
        if (!batch.finishes) continue;
        database_.run("DELETE FROM finished");
        Statement(database_, "INSERT INTO finished VALUES(?)").bind(static_cast<std::int64_t>(ticks_)).step();
    }
    database_.run("COMMIT");
    saved_ticks_ = ticks_;
} catch (...) {
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
}

void Writer::write_inputs(const Batch& batch) {
    if (batch.inputs.empty()) return;
    const std::size_t ticks = batch.inputs.size() / tools_;
    Statement(database_, "INSERT INTO chunk VALUES(?,?,?)")
        .bind(static_cast<std::int64_t>(ticks_), static_cast<std::int64_t>(ticks), pack(batch.inputs, tools_))
        .step();
    ticks_ += ticks;
}

void Writer::write_what_happened(const Batch& batch) {
    for (const TickHash& entry : batch.hashes) {
        char hex[17];
        std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(entry.hash));
        Statement(database_, "INSERT OR REPLACE INTO state_hash VALUES(?,?)")
            .bind(static_cast<std::int64_t>(entry.tick), std::string(hex))
            .step();
    }
    for (const world::Event& event : batch.events)
        Statement(database_, "INSERT INTO event VALUES(?,?,?,?)")
            .bind(event.t_s, event.name(), event.what, event.value)
            .step();
    for (const Mark& mark : batch.marks)
        Statement(database_, "INSERT INTO mark VALUES(?,?,?)")
            .bind(static_cast<std::int64_t>(mark.tick), mark.kind, mark.text)
            .step();
}

void Writer::write_pace(const PaceRow& row) {
    const auto half = [](const std::optional<Delays>& delays) {
        return delays ? std::optional(delays->p50_ms) : std::nullopt;
    };
    const auto most = [](const std::optional<Delays>& delays) {
        return delays ? std::optional(delays->p99_ms) : std::nullopt;
    };
    Statement(database_, "INSERT INTO pace VALUES(?,?,?,?,?,?,?,?)")
        .bind(static_cast<std::int64_t>(row.tick), row.wall_s, row.rate, row.dropped_ms, half(row.used), most(row.used),
              half(row.shown), most(row.shown))
        .step();
}

void Writer::write_scores(const std::vector<drill::ScoreItem>& items) {
    database_.run("DELETE FROM score; DELETE FROM measure");
    for (std::size_t i = 0; i < items.size(); ++i) {
        const drill::ScoreItem& item = items[i];
        Statement(database_, "INSERT INTO score VALUES(?,?,?,?,?,?,?,?)")
            .bind(item.name, item.title, item.value, item.unit, item.band, static_cast<std::int64_t>(item.passed),
                  item.at_s, item.why)
            .step();
        if (item.number) write_measure(i, item);
    }
}

void Writer::write_measure(std::size_t place, const drill::ScoreItem& item) {
    Statement(database_, "INSERT INTO measure VALUES(?,?,?,?,?,?)")
        .bind(static_cast<std::int64_t>(place), item.name, *item.number, item.unit, item.at_s,
              static_cast<std::int64_t>(std::llround(item.at_s / tick_s_)))
        .step();
}

}  // namespace scenarios::recording
