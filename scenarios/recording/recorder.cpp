#include <sqlite3.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cstdio>
#include <functional>
#include <utility>

#include "scenarios/recording/database.hpp"
#include "scenarios/recording/format.hpp"
#include "scenarios/recording/recording.hpp"

namespace scenarios::recording {

namespace {

constexpr double flush_s = 0.5;  ///< Of simulated time and of wall clock; half of the second that may be lost.

// A mistyped --record must not cost somebody a file of another kind.
void make_room(const std::filesystem::path& file) {
    const auto refuse = [&](const char* what) {
        throw RecordingError(file.string() + ": error: " + what + ", expected a new file or an earlier recording");
    };
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return;
    if (!std::filesystem::is_regular_file(file, error)) refuse("is not a regular file");
    if (std::filesystem::file_size(file, error) > 0 && !is_recording(file)) refuse("holds something else");
    std::filesystem::remove(file.string() + "-journal", error);
    std::filesystem::remove(file, error);
}

}  // namespace

double wall_clock() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Recorder::Impl {
    Database database;
    std::string file;
    std::size_t tools;
    std::size_t flush_ticks;
    double tick_s;
    std::vector<instruments::ToolInput> pending;  ///< Since the last flush, as are the next three.
    std::vector<TickHash> hashes;
    std::vector<world::Event> events;
    std::uint64_t saved_ticks = 0;
    Clock clock;
    double flushed;

    Impl(const std::filesystem::path& path, const Head& head, Clock wall)
        : database(path, Database::create),
          file(path.string()),
          tools(head.instruments.size()),
          flush_ticks(
              static_cast<std::size_t>(std::clamp(flush_s / head.tick_s, 1.0, static_cast<double>(most_ticks)))),
          tick_s(head.tick_s),
          clock(wall),
          flushed(wall()) {
        // A rollback journal keeps all that is committed in the one file; a write-ahead log would leave up to a whole
        // session beside it. NORMAL waits for the disk so that a power cut does not corrupt the file either.
        database.run("PRAGMA journal_mode=DELETE; PRAGMA synchronous=NORMAL; BEGIN");
        database.run("PRAGMA application_id=" + std::to_string(application_id));
        database.run("PRAGMA user_version=" + std::to_string(format_version));
        database.run(tables);
        Statement(database, "INSERT INTO head VALUES(?,?,?,?)")
            .bind(head.drill_text, head.drill_name, head.program_version, head.tick_s)
            .step();
        for (std::size_t i = 0; i < tools; ++i)
            Statement(database, "INSERT INTO instrument VALUES(?,?)")
                .bind(static_cast<std::int64_t>(i), head.instruments[i])
                .step();
        for (const Asset& asset : head.assets)
            Statement(database, "INSERT INTO asset VALUES(?,?)").bind(asset.name, asset.sha256).step();
        database.run("COMMIT");
        pending.reserve(flush_ticks * tools);
    }

    void write_pending() {
        if (!pending.empty()) {
            const auto ticks = static_cast<std::int64_t>(pending.size() / tools);
            Statement(database, "INSERT INTO chunk VALUES(?,?,?)")
                .bind(static_cast<std::int64_t>(saved_ticks), ticks, pack(pending, tools))
                .step();
        }
        for (const TickHash& entry : hashes) {
            char hex[17];
            std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(entry.hash));
            Statement(database, "INSERT OR REPLACE INTO state_hash VALUES(?,?)")
                .bind(static_cast<std::int64_t>(entry.tick), std::string(hex))
                .step();
        }
        for (const world::Event& event : events)
            Statement(database, "INSERT INTO event VALUES(?,?,?,?)")
                .bind(event.t_s, event.name(), event.what, event.value)
                .step();
    }

    /// One transaction: what is pending, and what `more` writes.
    void flush(const std::function<void()>& more = [] {}) try {
        flushed = clock();
        database.run("BEGIN");
        write_pending();
        more();
        database.run("COMMIT");
        saved_ticks += pending.size() / tools;
        pending.clear();
        hashes.clear();
        events.clear();
    } catch (const DatabaseError& error) {
        sqlite3_exec(database.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
        throw std::runtime_error(file + ": cannot be written (" + error.what() + "); the first " +
                                 std::to_string(static_cast<double>(saved_ticks) * tick_s) + " s are safe on disk");
    }

    void flush_when_due() {
        const bool full = pending.size() >= flush_ticks * tools;
        if (full || clock() - flushed >= flush_s) flush();
    }
};

Recorder::Recorder(const std::filesystem::path& file, const Head& head, Clock clock) : impl_(nullptr) {
    make_room(file);
    try {
        impl_ = new Impl(file, head, clock);
    } catch (const DatabaseError& error) {
        throw RecordingError(file.string() + ": error: cannot be written (" + error.what() + ")");
    }
}

Recorder::~Recorder() {
    if (!impl_) return;
    try {
        impl_->flush();
    } catch (const std::exception&) {  // what was flushed before is safe; there is nobody left to tell
    }
    delete impl_;
}

Recorder::Recorder(Recorder&& other) noexcept : impl_(std::exchange(other.impl_, nullptr)) {}
Recorder& Recorder::operator=(Recorder&& other) noexcept {
    std::swap(impl_, other.impl_);
    return *this;
}

void Recorder::add_tick(std::span<const instruments::ToolInput> inputs) {
    assert(inputs.size() == impl_->tools && "one input per instrument");
    impl_->pending.insert(impl_->pending.end(), inputs.begin(), inputs.end());
    impl_->flush_when_due();
}

void Recorder::add_hash(std::uint64_t tick, std::uint64_t hash) {
    impl_->hashes.push_back({tick, hash});
}

void Recorder::add_event(const world::Event& event) {
    impl_->events.push_back(event);
}

void Recorder::set_scores(const std::vector<drill::ScoreItem>& items) {
    impl_->flush([&] {
        impl_->database.run("DELETE FROM score");
        for (const auto& item : items)
            Statement(impl_->database, "INSERT INTO score VALUES(?,?,?,?,?,?,?,?)")
                .bind(item.name, item.title, item.value, item.unit, item.band, static_cast<std::int64_t>(item.passed),
                      item.at_s, item.why)
                .step();
    });
}

void Recorder::finish() {
    impl_->flush([&] {
        const auto ticks = impl_->saved_ticks + impl_->pending.size() / impl_->tools;
        impl_->database.run("DELETE FROM finished");
        Statement(impl_->database, "INSERT INTO finished VALUES(?)").bind(static_cast<std::int64_t>(ticks)).step();
    });
}

}  // namespace scenarios::recording
