#include "sim/thread/state.hpp"

namespace sim::thread {

// The follower goes to the point at rest length from its leader on the line towards its own old place
// ([Brown2004] section 3; the old place is the nearest it can be to where it was).
static Vec3 follow(const Vec3& leader, const Vec3& old_place, double rest) {
    const Vec3 d = old_place - leader;
    const double length = d.norm();
    return length > 0 ? Vec3(leader + rest / length * d) : Vec3(leader + Vec3(rest, 0, 0));
}

// The free tail beyond a held node.
static void drag_tail(State& state, int held, int direction) {
    const int last = direction > 0 ? state.links() : 0;
    for (int i = held; i != last; i += direction) {
        const auto leader = static_cast<std::size_t>(i), follower = static_cast<std::size_t>(i + direction);
        const double rest = state.rest[static_cast<std::size_t>(direction > 0 ? i : i - 1)];
        state.nodes[follower] = follow(state.nodes[leader], state.nodes[follower], rest);
    }
}

// Between two held nodes: follow from either end from the same old state, then average.
static void drag_between(State& state, int first, int last) {
    const auto f = static_cast<std::size_t>(first), l = static_cast<std::size_t>(last);
    state.forward[f] = state.nodes[f];
    for (std::size_t i = f; i + 1 < l; ++i)
        state.forward[i + 1] = follow(state.forward[i], state.nodes[i + 1], state.rest[i]);
    for (std::size_t i = l; i > f + 1; --i)
        state.nodes[i - 1] = follow(state.nodes[i], state.nodes[i - 1], state.rest[i - 1]);
    for (std::size_t i = f + 1; i < l; ++i) state.nodes[i] = 0.5 * (state.nodes[i] + state.forward[i]);
}

// Nodes that are held side by side go straight to their targets, but their links keep their length on the way.
void place_held(State& state) {
    const auto& holds = state.input.holds;
    for (std::size_t h = 0; h < holds.size(); ++h) {
        const auto i = static_cast<std::size_t>(holds[h].node);
        const double progress = state.progress[static_cast<std::size_t>(state.input.hold_owners[h] + 1)];
        state.nodes[i] = state.hold_from[h] + progress * (holds[h].target - state.hold_from[h]);
        const bool beside_last = h > 0 && holds[h - 1].node + 1 == holds[h].node;
        if (beside_last) state.nodes[i] = follow(state.nodes[i - 1], state.nodes[i], state.rest[i - 1]);
    }
}

void follow_leader(State& state) {
    int previous = -1;
    for (int i = 0; i <= state.links(); ++i) {
        if (state.inverse_mass[static_cast<std::size_t>(i)] > 0) continue;
        if (previous < 0)
            drag_tail(state, i, -1);
        else
            drag_between(state, previous, i);
        previous = i;
    }
    if (previous >= 0) drag_tail(state, previous, +1);
}

}  // namespace sim::thread
