#include "sim/thread/state.hpp"

namespace sim::thread {

// No node leaves its bound, whatever stage moved it.
void clip(State& state) {
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const Vec3 moved = state.nodes[i] - state.before[i];
        const double distance2 = moved.squaredNorm(), bound = state.bound[i];
        if (distance2 > bound * bound) state.nodes[i] = state.before[i] + bound / std::sqrt(distance2) * moved;
    }
}

// Such an approach is geometric, so its limit can be had from two successive steps (Aitken).
static void jump_to_limit(State& state, double along, double before) {
    constexpr double longest_jump = 20;  // in steps; two steps say no more than this about the limit
    const double ratio = along / before, jump = ratio < 1 ? std::min(longest_jump, ratio / (1 - ratio)) : longest_jump;
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
        if (state.inverse_mass[i] > 0) state.nodes[i] += jump * state.last_step[i];
    clip(state);
}

// Contacts and lengths in turn until neither is violated, lengths last: they converge at once where they can. One strand
// that drags a long slack one by a single crossing converges slowly, for each pass moves the crossing by the share of one
// link in the whole strand.
double relax(State& state) {
    constexpr int most_passes = 24;  // a knot being tightened takes 5 to 15; what needs more is jammed
    constexpr int between_jumps = 4, between_aims = 4;
    std::vector<Vec3>&last = state.last_pass, &step = state.last_step;
    for (int pass = 0; pass < most_passes; ++pass) {
        last = state.nodes;
        if (pass % between_aims == 0) aim(state);
        const double overlap = resolve_contacts(state);
        limit_bends(state);
        solve_lengths(state);
        clip(state);
        if (pass > 0 && overlap < 1) break;

        double along = 0, before = 0;
        for (std::size_t i = 0; i < state.nodes.size(); ++i) {
            const Vec3 now = state.nodes[i] - last[i];
            along += now.dot(step[i]);
            before += step[i].squaredNorm();
            step[i] = now;
        }
        if (pass % between_jumps == between_jumps - 1 && along > 0 && before > 0) jump_to_limit(state, along, before);
    }
    for (int pass = 0; pass < 3 && solve_lengths(state) > 0.1 * stretch_tolerance; ++pass) clip(state);
    clip(state);
    return std::max(worst_stretch(state, state.nodes) / stretch_tolerance, aim(state));
}

}  // namespace sim::thread
