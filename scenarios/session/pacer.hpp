#pragma once
#include <optional>
#include <vector>

#include "scenarios/recording/pace.hpp"

// When a live session's ticks are due, and how fast it goes. No clock is read here: each call is told the time.
namespace scenarios::session {

/// Says when the next tick is due. A computer that is too slow gets as many ticks as it can make, and what it owes
/// beyond 50 ms is dropped: time dilates, and nothing else.
class Pacer {
  public:
    /// `tick_s`: simulated time of a tick [s], above 0.
    explicit Pacer(double tick_s) : tick_s_(tick_s) {}

    /// Begins, or goes on after a pause: nothing is owed.
    void start(double now_s) { due_s_ = now_s; }
    /// Simulated over wall time from the next tick on, above 0.
    void set_pace(double pace) { pace_ = pace; }
    /// How long until the next tick is due [s]; 0: it is.
    double wait_s(double now_s);
    /// One tick was made.
    void add_tick() { due_s_ += tick_s_ / pace_; }
    /// Wall time given up so far [s].
    double dropped_s() const { return dropped_s_; }

  private:
    static constexpr double most_debt_s = 0.05;

    double tick_s_, pace_ = 1, due_s_ = 0, dropped_s_ = 0;
};

/// Measures the pace of a live session, a row a second, from what its tick thread says.
class PaceMeter {
  public:
    /// `tick_s`: simulated time of a tick [s], above 0.
    explicit PaceMeter(double tick_s) : tick_s_(tick_s) {}

    /// Begins, or goes on after a pause.
    void start(double now_s);
    /// A pause begins: it is not measured.
    void halt(double now_s);
    /// An event of a device was used by a tick so long after it came [s].
    void add_used(double delay_s) { used_s_.push_back(delay_s); }
    /// An event of a device was shown so long after it came [s].
    void add_shown(double delay_s) { shown_s_.push_back(delay_s); }
    /// A tick was made, and so much wall time given up so far [s]. The row that ends with it, once a second.
    std::optional<recording::PaceRow> add_tick(double now_s, double dropped_s);
    /// What is left at the session's end, if that is half a second at least, or all there is.
    std::optional<recording::PaceRow> last_row(double now_s, double dropped_s);
    /// Simulated over wall time in the last whole second; before its end since the beginning; 0 before the first tick.
    double rate(double now_s) const;

  private:
    double length_s(double now_s) const;
    recording::PaceRow end_row(double now_s, double dropped_s);

    double tick_s_;
    std::uint64_t ticks_ = 0, first_ = 0;       // so far; when the row began
    double begin_s_ = 0, before_pauses_s_ = 0;  // of the row, or since the last pause; what of it was before that
    double wall_s_ = 0, dropped_s_ = 0;         // when the row began
    double last_rate_ = 0;
    bool has_rows_ = false;
    std::vector<double> used_s_, shown_s_;
};

}  // namespace scenarios::session
