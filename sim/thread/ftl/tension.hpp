#pragma once
#include <vector>

#include "sim/thread/ftl/tail.hpp"

namespace sim::thread::ftl {

/// Estimates what a thread of ThreadDef::axial_stiffness would carry from how far held nodes lag behind their targets.
class TensionEstimate {
  public:
    /// Makes room for a thread of at most so many links.
    explicit TensionEstimate(std::size_t most_links);

    /// Puts the pull of every link into State::tension [N]. O(n + rows).
    void find(State& state);

  private:
    /// Of strands that are drawn over walls and tools with their other ends free: Euler's and Eytelwein's law, the pull
    /// grows by e to friction times turn.
    void find_capstan_profile(const State& state);
    void pull_through(const State& state, const Tail& tail);
    void spread(State& state, std::size_t first, int direction, double lag) const;
    bool is_loose(const State& state, std::size_t held, int direction) const;

    std::vector<double> rubbed_;   // per link, as find_rubbed() has it
    std::vector<double> profile_;  // per link, its tension as a share of any
};

}  // namespace sim::thread::ftl
