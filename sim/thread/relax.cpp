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

static double pass(State& state, double (*contacts)(State&)) {
    ++state.work;
    const double overlap = contacts(state);
    limit_bends(state);
    solve_lengths(state);
    clip(state);
    return overlap;
}

// Contacts and lengths in turn until neither is violated, lengths last: they converge at once where they can. Where one
// strand drags a long one by a single crossing, each pass moves the crossing by the share of one link in the whole strand:
// what a few passes have not settled is solved with contacts and lengths together. Near enough and no longer coming nearer is
// settled too: a knot pulled tight has no more to give.
double relax(State& state) {
    constexpr int least_passes = 2;  // friction knows what presses after the first
    constexpr int most_passes = 8, between_aims = 4, most_couplings = 4, work_of_coupling = 9;  // 40 rows, measured
    double overlap = 1, was = 1;
    const auto stands_still = [&](int passes) { return passes > least_passes && overlap < 1.2 && overlap > 0.95 * was; };
    for (int i = 0; i < most_passes && (i < least_passes || overlap >= 1) && !stands_still(i); ++i) {
        if (i % between_aims == 0) aim(state);
        was = overlap;
        overlap = pass(state, resolve_contacts);
    }
    const bool good_enough = stands_still(most_passes);
    for (int i = 0; i < most_couplings && overlap >= 1 && !good_enough && state.work < most_work; ++i) {
        state.work += work_of_coupling;
        aim(state);
        overlap = pass(state, couple);
    }
    constexpr int least_solves = 3, most_solves = 12;  // a wrap that lies on steel takes more than a knot
    double stretch = 1, before = 2;
    for (int i = 0; i < most_solves && stretch > 0.1 * stretch_tolerance && (i < least_solves || stretch < 0.5 * before); ++i) {
        before = stretch;
        stretch = solve_lengths(state);
        clip(state);
    }
    clip(state);
    return std::max(worst_stretch(state, state.nodes) / stretch_tolerance, aim(state));
}

}  // namespace sim::thread
