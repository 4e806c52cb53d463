#pragma once
#include <vector>

#include "sim/thread/ftl/state.hpp"

namespace sim::thread::ftl {

/// Held nodes to where they are asked to be at State::progress; those held side by side keep their links' lengths.
void place_held(State& state);
/// Taut spans between held nodes go along with what the ways of both ends have in common, into State::carried. O(n).
void carry_taut_spans(State& state);

/// Nodes follow held ones, from every one of them outwards.
class FollowLeader {
  public:
    /// For so many links at most.
    explicit FollowLeader(std::size_t most_links);

    /// All nodes that are not held; between two that are, from both ends and blended. O(n).
    void follow(State& state);

  private:
    void drag_between(State& state, int first, int last);

    std::vector<Vec3> forward_;  // per node: followed from the first of two held ones
};

}  // namespace sim::thread::ftl
