#pragma once
#include <vector>

#include "sim/thread/elastic/press.hpp"

namespace sim::thread::elastic {

/// Whether a row is too far off to push in the next step, which leaves it just touching at most.
bool is_far(const State& state, const Row& row);

/// By how much a wall that gives way goes for what a push on it has changed by since it was moved [m/N]; 0 where it
/// does not.
double give_of_wall(const State& state, const Row& row);

/// What of all that an elastic thread is near may press on it in a step.
class PressFinder {
  public:
    /// For so many links at most.
    explicit PressFinder(std::size_t most_links);

    /// Rows that press, or may come to in this step, into `presses`, nearest first. O(rows log rows + rows presses).
    void find(State& state, std::vector<Press>& presses);

    /// Of those found last: the forces on the rod.
    std::span<const Pair> pairs() const { return pairs_; }
    /// Of those found last: links that roll on what they are pressed against.
    std::span<const Rolling> rolling() const { return rolling_; }

  private:
    void sort_by_distance(State& state);
    void add_press(State& state, std::vector<Press>& presses, Row& row);
    void add_rolling(const State& state, const Row& row);
    void set_rest(const State& state, Press& press);

    std::vector<Row*> nearest_rows_;
    std::vector<Pair> pairs_;
    std::vector<Rolling> rolling_;
};

}  // namespace sim::thread::elastic
