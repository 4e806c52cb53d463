#include "sim/thread/ftl/length_solver.hpp"

#include <algorithm>
#include <cmath>

// Lengths: the smallest move of all nodes together that restores every length to first order, J W J^T lambda = -C with
// C the length errors, one step of Newton's method on position-based constraints. Each link meets only its two
// neighbours, so the matrix is tridiagonal and one sweep of the Thomas algorithm solves it [Han2013]: O(n), where
// Gauss-Seidel link by link takes some n^2.

namespace sim::thread::ftl {

LengthSolver::LengthSolver(std::size_t most_links) {
    unit_.reserve(most_links);
    for (auto* of_links : {&lower_, &pivot_, &upper_, &multiplier_}) of_links->reserve(most_links);
}

double LengthSolver::measure(const State& state) {
    unit_.resize(state.rest_length.size());
    multiplier_.resize(state.rest_length.size());
    double worst = 0;
    for (std::size_t k = 0; k < state.rest_length.size(); ++k) {
        if (state.is_cut(k)) {
            unit_[k].setZero();
            multiplier_[k] = 0;
            continue;
        }
        const Vec3 d = state.nodes[k + 1] - state.nodes[k];
        const double length = d.norm();
        unit_[k] = length > 0 ? Vec3(d / length) : Vec3::UnitX();
        multiplier_[k] = state.rest_length[k] - length;
        if (state.inverse_mass[k] + state.inverse_mass[k + 1] == 0) multiplier_[k] = 0;  // held at both ends
        worst = std::max(worst, std::abs(multiplier_[k]) / state.rest_length[k]);
    }
    return worst;
}

double LengthSolver::solve(State& state) {
    // A taut straight span between two grasps makes the matrix singular. This much compliance (beside a diagonal of 2)
    // keeps its corrections finite; what it cannot correct shows in the stretch, and the tools wait.
    constexpr double compliance = 1e-6;
    const double worst = measure(state);
    const std::size_t n = state.rest_length.size();
    for (auto* of_links : {&lower_, &pivot_, &upper_}) of_links->resize(n);
    double upper = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const double left = state.inverse_mass[k], right = state.inverse_mass[k + 1];
        const double lower = k > 0 ? -left * unit_[k - 1].dot(unit_[k]) : 0;
        const double pivot = 1 / (left + right + compliance - lower * upper);
        lower_[k] = lower;
        pivot_[k] = pivot;
        multiplier_[k] = (multiplier_[k] - (k > 0 ? lower * multiplier_[k - 1] : 0)) * pivot;
        upper = k + 1 < n ? -right * unit_[k].dot(unit_[k + 1]) * pivot : 0;
        upper_[k] = upper;
    }
    for (std::size_t k = n - 1; k-- > 0;) multiplier_[k] -= upper_[k] * multiplier_[k + 1];
    for (std::size_t k = 0; k < n; ++k) {
        state.pulled[k] += multiplier_[k];
        const Vec3 push = multiplier_[k] * unit_[k];
        state.nodes[k] -= state.inverse_mass[k] * push;
        state.nodes[k + 1] += state.inverse_mass[k + 1] * push;
    }
    return worst;
}

void LengthSolver::substitute(std::vector<double>& x) const {
    x[0] *= pivot_[0];
    for (std::size_t k = 1; k < x.size(); ++k) x[k] = pivot_[k] * (x[k] - lower_[k] * x[k - 1]);
    for (std::size_t k = x.size() - 1; k-- > 0;) x[k] -= upper_[k] * x[k + 1];
}

}  // namespace sim::thread::ftl
