#include "sim/thread/stages.hpp"

namespace sim::thread {

double worst_stretch(const State& state, const std::vector<Vec3>& nodes) {
    double worst = 0;
    for (std::size_t k = 0; k < state.rest.size(); ++k) {
        if (state.is_cut(k)) continue;
        const double length = (nodes[k + 1] - nodes[k]).norm();
        worst = std::max(worst, std::abs(length / state.rest[k] - 1));
    }
    return worst;
}

double measure_links(State& state) {
    double worst = 0;
    for (std::size_t k = 0; k < state.rest.size(); ++k) {
        if (state.is_cut(k)) {
            state.unit[k].setZero();
            state.multiplier[k] = 0;
            continue;
        }
        const Vec3 d = state.nodes[k + 1] - state.nodes[k];
        const double length = d.norm();
        state.unit[k] = length > 0 ? Vec3(d / length) : Vec3::UnitX();
        state.multiplier[k] = state.rest[k] - length;
        if (state.inverse_mass[k] + state.inverse_mass[k + 1] == 0) state.multiplier[k] = 0;  // held at both ends
        worst = std::max(worst, std::abs(state.multiplier[k]) / state.rest[k]);
    }
    return worst;
}

// What is left after Follow-The-Leader and contacts: the
// smallest move of all nodes together that restores every length to first order, J W J^T lambda = -C with C the length
// errors. Each link meets only its two neighbours, so the matrix is tridiagonal and one sweep solves it [Han2013].
double solve_lengths(State& state) {
    // A taut straight span between two grasps makes the matrix singular. This much compliance (beside a diagonal of 2)
    // keeps its corrections finite; what it cannot correct shows in the stretch, and the tools wait.
    constexpr double compliance = 1e-6;
    const double worst = measure_links(state);
    const std::size_t n = state.rest.size();
    double upper = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const double left = state.inverse_mass[k], right = state.inverse_mass[k + 1];
        const double lower = k > 0 ? -left * state.unit[k - 1].dot(state.unit[k]) : 0;
        const double pivot = 1 / (left + right + compliance - lower * upper);
        state.lower[k] = lower;
        state.pivot[k] = pivot;
        state.multiplier[k] = (state.multiplier[k] - (k > 0 ? lower * state.multiplier[k - 1] : 0)) * pivot;
        upper = k + 1 < n ? -right * state.unit[k].dot(state.unit[k + 1]) * pivot : 0;
        state.upper[k] = upper;
    }
    for (std::size_t k = n - 1; k-- > 0;) state.multiplier[k] -= state.upper[k] * state.multiplier[k + 1];
    for (std::size_t k = 0; k < n; ++k) {
        state.pulled[k] += state.multiplier[k];
        const Vec3 push = state.multiplier[k] * state.unit[k];
        state.nodes[k] -= state.inverse_mass[k] * push;
        state.nodes[k + 1] += state.inverse_mass[k + 1] * push;
    }
    return worst;
}

}  // namespace sim::thread
