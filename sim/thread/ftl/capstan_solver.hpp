#pragma once
#include <array>
#include <vector>

#include "sim/thread/ftl/band.hpp"
#include "sim/thread/ftl/length_solver.hpp"
#include "sim/thread/ftl/resolve.hpp"

namespace sim::thread::ftl {

/// Whether any row in a wrap pushes or is about to.
bool is_on_steel(const State& state);

/// Solves all lengths of a thread that lies along steel together with the pushes and the friction of the steel.
class CapstanSolver {
  public:
    /// Makes room for a thread of at most so many links.
    explicit CapstanSolver(std::size_t most_links);

    /// Makes one Newton step of all lengths and all rows in wraps together; returns the worst |l/l0 - 1| found before
    /// it. O(n).
    double solve(State& state, LengthSolver& lengths);

  private:
    /// What is found together with all others: the pull of a link, or the push of a contact. It acts on the link's two
    /// nodes with `weight` * `force`, so that what they measure along `axis` is right.
    struct Unknown {
        Row* row;  // none: a length
        int link;
        std::array<double, 2> weight;
        Vec3 axis, force;
        double compliance;
    };
    void measure_stiffness(const State& state);
    Vec3 move_of(const State& state, int node, const Vec3& push) const;
    void move_row(const State& state, const Row& row, const Vec3& push);
    void change_push(const State& state, Row& row, double normal, const Vec3& tangent);
    void add_contact(const State& state, Row& row);
    void add_length(const LengthSolver& lengths, int link);
    double collect(State& state, LengthSolver& lengths);
    double response(const State& state, const Unknown& of, const Unknown& by) const;
    void fill_band(const State& state);
    void push(State& state, const Unknown& unknown, double by);

    std::vector<Unknown> unknowns_;
    std::vector<double> unknown_;  // errors, then the solution
    Band band_;
    std::vector<Vec3> line_;       // per node: along the thread
    std::vector<Vec3> displaced_;  // per node: how it moves [m]
    std::vector<double> stiff_;    // per node: how much harder it moves across the thread than along it, >= 1
};

}  // namespace sim::thread::ftl
