#pragma once
#include <span>
#include <vector>

#include "sim/thread/mover.hpp"

// Links that come and go between ticks.
namespace sim::thread {

/// Halves links that bend or touch and joins straight ones, by ThreadDef::shortest_link.
class LinkFitter {
  public:
    /// Makes room for a thread of at most so many links.
    explicit LinkFitter(std::size_t most_links) { nearest_.reserve(most_links); }

    /// Does what Thread::fit_links() says, each time the thread has moved by its own radius; returns whether any link
    /// changed. O(n + contacts).
    bool fit(Mover& mover, std::span<int> held);

  private:
    void measure_nearest(const contact::State& state);
    bool asks_for_shorter(const contact::State& state, std::size_t link) const;
    bool can_go(const contact::State& state, std::size_t node) const;
    bool halve_where_needed(Mover& mover, std::span<int> held) const;
    bool join_where_straight(Mover& mover, std::span<int> held);

    std::vector<double> nearest_;  // per link: distance of the nearest other strand, in thicknesses
};

/// Puts a node more at a share of a link, 0..1; nothing moves. `held` is as in Thread::fit_links().
void split(Mover& mover, std::size_t link, double share, std::span<int> held);
/// After links have changed: resizes what has one entry a link, and forgets what was known of their surroundings.
void renew(Mover& mover);

/// The same as Thread::cut().
bool cut(Mover& mover, std::size_t link, double share, std::span<int> held);
/// The same as Thread::most_loaded().
int most_loaded(const Mover& mover);

}  // namespace sim::thread
