#pragma once
#include <cmath>

#include "sim/thread/ftl/state.hpp"

namespace sim::thread::ftl {

/// Brings every node back within State::bound of where the substep began, whatever stage moved it. O(n).
inline void clip(State& state) {
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const Vec3 moved = state.nodes[i] - state.before[i];
        const double distance2 = moved.squaredNorm(), bound = state.bound[i];
        if (distance2 > bound * bound) state.nodes[i] = state.before[i] + bound / std::sqrt(distance2) * moved;
    }
}

}  // namespace sim::thread::ftl
