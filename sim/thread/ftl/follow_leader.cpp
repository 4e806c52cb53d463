#include "sim/thread/ftl/follow_leader.hpp"

#include <algorithm>

// Follow-The-Leader [Brown2004]: each node goes straight towards the one before it until their link is as long as it
// was made. One pass, O(n), no iteration, and what is taut follows at once; slack is dragged along as if it were taut.

namespace sim::thread::ftl {

// The follower goes to the point at rest length from its leader on the line towards its own old place
// ([Brown2004] section 3; the old place is the nearest it can be to where it was).
static Vec3 place_after(const Vec3& leader, const Vec3& old_place, double rest) {
    const Vec3 d = old_place - leader;
    const double length = d.norm();
    return length > 0 ? Vec3(leader + rest / length * d) : Vec3(leader + Vec3(rest, 0, 0));
}

FollowLeader::FollowLeader(std::size_t most_links) {
    forward_.reserve(most_links + 1);
}

// The free tail beyond a held node.
static void drag_tail(State& state, int held, int direction) {
    const auto is_tip = [&](int node) {
        return direction > 0 ? state.is_last(static_cast<std::size_t>(node))
                             : state.is_first(static_cast<std::size_t>(node));
    };
    for (int i = held; !is_tip(i); i += direction) {
        const auto leader = static_cast<std::size_t>(i), follower = static_cast<std::size_t>(i + direction);
        const double rest = state.rest_length[static_cast<std::size_t>(direction > 0 ? i : i - 1)];
        state.nodes[follower] = place_after(state.nodes[leader], state.nodes[follower], rest);
    }
}

// Between two held nodes: follow from either end from the same old state and blend, so that every link takes its share
// of what is missing.
void FollowLeader::drag_between(State& state, int first, int last) {
    const auto f = static_cast<std::size_t>(first), l = static_cast<std::size_t>(last);
    forward_[f] = state.nodes[f];
    for (std::size_t i = f; i + 1 < l; ++i)
        forward_[i + 1] = place_after(forward_[i], state.nodes[i + 1], state.rest_length[i]);
    for (std::size_t i = l; i > f + 1; --i)
        state.nodes[i - 1] = place_after(state.nodes[i], state.nodes[i - 1], state.rest_length[i - 1]);
    for (std::size_t i = f + 1; i < l; ++i) {
        const double share = static_cast<double>(i - f) / static_cast<double>(l - f);
        state.nodes[i] = share * state.nodes[i] + (1 - share) * forward_[i];
    }
}

// Nodes that are held side by side go straight to their targets, but their links keep their length on the way.
void place_held(State& state) {
    const auto& holds = state.input.holds;
    for (std::size_t h = 0; h < holds.size(); ++h) {
        const auto i = static_cast<std::size_t>(holds[h].node);
        const double progress = state.progress[static_cast<std::size_t>(state.input.hold_owners[h] + 1)];
        state.nodes[i] = state.hold_from[h] + progress * (holds[h].target - state.hold_from[h]);
        const bool beside_last = h > 0 && holds[h - 1].node + 1 == holds[h].node && !state.is_cut(i - 1);
        if (beside_last) state.nodes[i] = place_after(state.nodes[i - 1], state.nodes[i], state.rest_length[i - 1]);
    }
}

// What two displacements have in common: the shorter of them, along their middle, as far as they point the same way.
static Vec3 common(const Vec3& a, const Vec3& b) {
    const double lengths = a.norm() * b.norm(), along = a.dot(b);
    return along > 0 ? Vec3(along / lengths * std::min(a.norm(), b.norm()) * (a + b).normalized()) : Vec3::Zero();
}

// A span between two held nodes that is straight but for this share has no slack from which it could respond by itself.
static double tautness(const State& state, std::size_t first, std::size_t last) {
    constexpr double slack_share = 0.05;
    double length = 0;
    for (std::size_t i = first; i < last; ++i) length += state.rest_length[i];
    return std::max(0.0, 1 - (1 - (state.before[last] - state.before[first]).norm() / length) / slack_share);
}

void carry_taut_spans(State& state) {
    std::fill(state.carried.begin(), state.carried.end(), Vec3::Zero());
    std::size_t previous = state.nodes.size();
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        if (state.is_first(i)) previous = state.nodes.size();
        if (state.inverse_mass[i] > 0) continue;
        if (previous + 1 < i) {
            const Vec3 displacement =
                tautness(state, previous, i) *
                common(state.nodes[previous] - state.before[previous], state.nodes[i] - state.before[i]);
            std::fill(state.carried.begin() + static_cast<std::ptrdiff_t>(previous) + 1,
                      state.carried.begin() + static_cast<std::ptrdiff_t>(i), displacement);
        }
        previous = i;
    }
    for (std::size_t i = 0; i < state.nodes.size(); ++i) state.nodes[i] += state.carried[i];
}

void FollowLeader::follow(State& state) {
    forward_.resize(state.nodes.size());
    int previous = -1;
    for (int i = 0; i <= state.links(); ++i) {
        if (state.inverse_mass[static_cast<std::size_t>(i)] == 0) {
            if (previous < 0)
                drag_tail(state, i, -1);
            else
                drag_between(state, previous, i);
            previous = i;
        }
        if (!state.is_last(static_cast<std::size_t>(i))) continue;
        if (previous >= 0) drag_tail(state, previous, +1);
        previous = -1;
    }
}

}  // namespace sim::thread::ftl
