#pragma once
#include <vector>

#include "sim/thread/ftl/state.hpp"

namespace sim::thread::ftl {

/// Keeps all links as long as they are made, together, and hands on its last factors.
class LengthSolver {
  public:
    /// Makes room for a thread of at most so many links.
    explicit LengthSolver(std::size_t most_links);

    /// Makes one Newton step of all lengths at once; returns the worst |l/l0 - 1| found before it. O(n).
    double solve(State& state);
    /// Measures directions and length errors of all links; returns the worst |l/l0 - 1|. A cut has neither.
    double measure(const State& state);
    /// x = A^-1 x by the factors of the last solve, one number a link. O(n).
    void substitute(std::vector<double>& x) const;

    /// A link's direction towards the thread's end when last measured, unit; zero of a cut.
    const Vec3& unit(std::size_t link) const { return unit_[link]; }
    /// What a link lacked in length when last measured, and before the next solve [m].
    double lack(std::size_t link) const { return multiplier_[link]; }
    /// One over a link's pivot in the last factors [1].
    double pivot(std::size_t link) const { return pivot_[link]; }
    /// The share of the next link's solution that this one takes back, by the last factors [1].
    double upper(std::size_t link) const { return upper_[link]; }

  private:
    std::vector<Vec3> unit_;
    std::vector<double> lower_, pivot_, upper_;  // factors
    std::vector<double> multiplier_;             // errors, then the solution [m]
};

}  // namespace sim::thread::ftl
