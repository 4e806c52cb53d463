#pragma once
#include <vector>

#include "sim/thread/ftl/state.hpp"

namespace sim::thread::ftl {

/// Puts held nodes where they are asked to be at State::progress; those held side by side keep their links' lengths.
void place_held(State& state);
/// Moves taut spans between held nodes along with what the displacements of both ends have in common, and notes it in
/// State::carried. O(n).
void carry_taut_spans(State& state);

/// Nodes follow held ones, from every one of them outwards.
class FollowLeader {
  public:
    /// Makes room for a thread of at most so many links.
    explicit FollowLeader(std::size_t most_links);

    /// Moves all nodes that are not held; between two that are, it follows from both ends and blends. O(n).
    void follow(State& state);

  private:
    void drag_between(State& state, int first, int last);

    std::vector<Vec3> forward_;  // per node: followed from the first of two held ones
};

}  // namespace sim::thread::ftl
