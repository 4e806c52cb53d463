#pragma once
#include "sim/thread/ftl/bend_limit.hpp"
#include "sim/thread/ftl/capstan_solver.hpp"
#include "sim/thread/ftl/coupled_solver.hpp"
#include "sim/thread/ftl/length_solver.hpp"

namespace sim::thread::ftl {

/// What the search for a substep's shape may cost at most.
struct Effort {
    int passes;     ///< Passes over contacts and lengths in turn.
    int couplings;  ///< Coupled solves of contacts and lengths together.
};

/// Solves contacts, bends and lengths in turn until none is violated.
class Relaxation {
  public:
    /// Makes room for the links that the thread may come to have.
    explicit Relaxation(const State& state);
    /// Measures bends anew, after links have changed.
    void resize(const State& state) { bends_.resize(state); }

    /// Moves nodes within their bounds; returns the worst violation left, 1 where tools must wait.
    double relax(State& state, Effort effort);
    /// The limit of the thread's bends.
    const BendLimit& bends() const { return bends_; }

    int work = 0;  ///< Work done so far, in passes over contacts and lengths; whoever counts sets it back.

  private:
    double solve(State& state);
    double pass(State& state, bool coupled);
    double settle(State& state);

    LengthSolver lengths_;
    CapstanSolver capstan_;
    CoupledSolver coupled_;
    BendLimit bends_;
};

}  // namespace sim::thread::ftl
