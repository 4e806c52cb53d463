#pragma once
#include "sim/thread/ftl/bend_limit.hpp"
#include "sim/thread/ftl/capstan_solver.hpp"
#include "sim/thread/ftl/coupled_solver.hpp"
#include "sim/thread/ftl/length_solver.hpp"

namespace sim::thread::ftl {

/// What an answer may cost at most.
struct Effort {
    int passes;     ///< Over contacts and lengths in turn.
    int couplings;  ///< Solves of both together.
};

/// Contacts, bends and lengths until none is violated.
class Relaxation {
  public:
    /// Of the links that the thread has.
    explicit Relaxation(const State& state);
    /// After links have changed.
    void resize(const State& state) { bends_.resize(state); }

    /// Moves nodes within their bounds; returns the worst violation left, 1 where tools must wait.
    double relax(State& state, Effort effort);
    const BendLimit& bends() const { return bends_; }

    int work = 0;  ///< Done so far, in passes over contacts and lengths; who counts sets it back.

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
