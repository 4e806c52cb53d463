#pragma once
#include <optional>
#include <span>
#include <vector>

#include "scenarios/recording/database.hpp"
#include "scenarios/recording/recording.hpp"

namespace scenarios::recording {

/// What was added to a recording and is written together.
struct Batch {
    std::vector<instruments::ToolInput> inputs;           ///< Whole ticks, one per instrument each.
    std::vector<TickHash> hashes;                         ///< In order of ticks.
    std::vector<world::Event> events;                     ///< In the order in which they happened.
    std::vector<Mark> marks;                              ///< In the order in which they were made.
    std::vector<PaceRow> pace;                            ///< In order of ticks.
    std::optional<std::vector<drill::ScoreItem>> scores;  ///< They replace those before.
    bool finishes = false;                                ///< The session is complete.

    /// Whether there is nothing in it.
    bool is_empty() const;
};

/// A recording's file. Of one thread at a time.
class Writer {
  public:
    /// Makes the file, in which nothing but the head is. Throws DatabaseError.
    Writer(const std::filesystem::path& file, const Head& head);
    /// Writes all of them in one transaction, or none. Throws DatabaseError or std::runtime_error.
    void write(std::span<const Batch> batches);
    /// How many ticks are on disk.
    std::uint64_t saved_ticks() const { return saved_ticks_; }

  private:
    void write_head(const Head& head);
    void write_engine(const Engine& engine);
    void write_session(const Circumstances& session);
    void write_inputs(const Batch& batch);
    void write_what_happened(const Batch& batch);
    void write_pace(const PaceRow& row);
    void write_scores(const std::vector<drill::ScoreItem>& items);
    void write_measure(std::size_t place, const drill::ScoreItem& item);

    Database database_;
    std::size_t tools_;
    double tick_s_;
    std::uint64_t saved_ticks_ = 0, ticks_ = 0;  ///< On disk; with those of the transaction.
};

}  // namespace scenarios::recording
