#pragma once
#include <vector>

#include "sim/thread/ftl/bend_limit.hpp"
#include "sim/thread/ftl/follow_leader.hpp"

namespace sim::thread::ftl {

/// Whether the thread lies at walls and is only drawn, away from free ends.
bool may_slide(const State& state);
/// Into State::slides, after a substep: whether it may, and free ends followed: there is no slack to take up first.
void note_whether_it_slides(State& state);
/// What share of `way` [m] the thread can so follow in one step, 0..1.
double share_of_slide(const State& state, double way);

/// A strand along itself.
class Slide {
  public:
    /// For so many links at most.
    explicit Slide(std::size_t most_links);

    /// The thread along itself after what leads it; returns the worst violation left, 1 where tools must wait, and adds
    /// its passes to `work`.
    double slide_along(State& state, FollowLeader& leader, const BendLimit& bends, int& work);

  private:
    void follow_along(State& state, FollowLeader& leader);

    std::vector<double> rubbed_;  // per link, as find_rubbed() has it
};

}  // namespace sim::thread::ftl
