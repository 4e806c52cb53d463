#pragma once
#include <vector>

#include "sim/thread/contact/tools.hpp"
#include "sim/thread/elastic/state.hpp"

namespace sim::thread::elastic {

using contact::Motion;

/// How far tools, and what they hold, go in a step of an elastic thread: up to what they meet, into what moves away as
/// far as it does, along what does not.
class Advance {
  public:
    /// The share, 0..1, of the motion left that tools may make before the next detection, should the thread respond as
    /// freely as it may. `left`: the share of the tick's motion still to be made, 0..1. O(contacts).
    double share_of_tools(const State& state, double left, const Motion& motion);

  private:
    void find_room_at_walls(const State& state);
    double share_at_walls(const State& state, std::size_t hold) const;

    std::vector<double> room_at_walls_;  // per node: what is free between its links and walls [m]
};

/// The share, 0..1, that tools may make should the thread not move away: no farther into links than any may be.
/// `share`: what they may make should it move.
double careful_share(const State& state, double left, double share);

/// Whether a step may be found twice: not where one solves as many contacts as a tick may.
bool may_dare(const State& state);

/// Whether the step that was found leaves a tool farther in a link than any may be. O(contacts with tools).
bool is_deep(const State& state);

/// Takes out of `targets`, one a hold of the input, the motion that would lead what is held too far into a tool that
/// does not hold it or, where no jaws do, into a wall: it slides along instead.
void slide_aside(const State& state, std::vector<Hold>& targets);

}  // namespace sim::thread::elastic
