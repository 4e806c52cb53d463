#include "sim/thread/ftl/relaxation.hpp"

#include <algorithm>

#include "sim/thread/ftl/clip.hpp"

// Contacts and lengths in turn until neither is violated (block Gauss-Seidel), lengths last: they converge at once
// where they can. What a few passes have not settled is solved with contacts and lengths together. A pass costs O(n +
// rows).

namespace sim::thread::ftl {

Relaxation::Relaxation(const State& state)
    : lengths_(state.most_links()), capstan_(state.most_links()), coupled_(state.most_links()), bends_(state) {}

double Relaxation::solve(State& state) {
    return is_on_steel(state) ? capstan_.solve(state, lengths_) : lengths_.solve(state);
}

double Relaxation::pass(State& state, bool coupled) {
    ++work;
    const double overlap = coupled ? coupled_.solve(state, lengths_) : resolve_contacts(state);
    bends_.limit(state);
    solve(state);
    clip(state);
    return overlap;
}

// Lengths to the end, contacts no more; returns the worst violation of both, 1 where tools must wait.
double Relaxation::settle(State& state) {
    // Newton's method on a long chain may err at first and then converges at once.
    constexpr int least_solves = 6, most_solves = 12;  // a wrap that lies on steel takes more than a knot
    double stretch = 1, before = 2;
    for (int i = 0;
         i < most_solves && stretch > 0.1 * stretch_tolerance && (i < least_solves || stretch < 0.5 * before); ++i) {
        before = stretch;
        stretch = solve(state);
        clip(state);
    }
    return std::max(worst_stretch(state, state.nodes) / stretch_tolerance, aim(state));
}

// Contacts and lengths in turn until neither is violated, lengths last: they converge at once where they can. Where one
// strand drags a long one by a single crossing, each pass moves the crossing by the share of one link in the whole
// strand: what a few passes have not settled is solved with contacts and lengths together. Near enough and no longer
// coming nearer is settled too: a knot pulled tight has no more to give.
double Relaxation::relax(State& state, Effort effort) {
    constexpr int least_passes =
        4;  // two know what presses; with less than four a wrap drags by half more than it should
    constexpr int work_of_coupling = 9;  // 20 rows, measured; a knot has 10 to 50
    double overlap = 1, was = 1;
    const auto stands_still = [&](int passes) {
        return passes > least_passes && overlap < 1.2 && overlap > 0.95 * was;
    };
    int passes = 0;
    for (; passes < effort.passes && (passes < least_passes || overlap >= 1) && !stands_still(passes); ++passes) {
        aim(state);
        was = overlap;
        overlap = pass(state, false);
    }
    // What a wrap and lengths alone leave is met by their own solve.
    const bool others_press = std::any_of(state.rows.begin(), state.rows.end(),
                                          [](const Row& row) { return !row.in_wrap && row.normal_push > 0; });
    const int couplings = others_press || state.on_steel.empty() ? effort.couplings : 0;
    double violation = overlap < 1 || stands_still(passes) || couplings == 0 ? settle(state) : overlap;
    for (int i = 1; i <= couplings && violation > 1 && !state.rows.empty(); ++i) {
        work += work_of_coupling;
        if (!state.on_steel.empty()) lengths_.solve(state);  // coupling goes by its factors
        aim(state);
        overlap = pass(state, true);
        if (overlap < 1 || i == couplings) violation = settle(state);
    }
    return violation;
}

}  // namespace sim::thread::ftl
