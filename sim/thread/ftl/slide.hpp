#pragma once
#include <vector>

#include "sim/thread/ftl/bend_limit.hpp"
#include "sim/thread/ftl/follow_leader.hpp"

namespace sim::thread::ftl {

/// Whether the thread lies at walls and is only drawn, away from free ends.
bool may_slide(const State& state);
/// After a substep: notes in State::slides whether the thread may slide and its free ends followed, so that there is no
/// slack to take up first.
void note_whether_it_slides(State& state);
/// The share, 0..1, of a displacement of `path` [m] that the thread can follow in one step by sliding.
double share_of_slide(const State& state, double path);

/// Moves a strand along itself.
class Slide {
  public:
    /// Makes room for a thread of at most so many links.
    explicit Slide(std::size_t most_links);

    /// Moves the thread along itself after what leads it; returns the worst violation left, 1 where tools must wait,
    /// and adds its passes to `work`.
    double slide_along(State& state, FollowLeader& leader, const BendLimit& bends, int& work);

  private:
    void follow_along(State& state, FollowLeader& leader);

    std::vector<double> rubbed_;  // per link, as find_rubbed() has it
};

}  // namespace sim::thread::ftl
