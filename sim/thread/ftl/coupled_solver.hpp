#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "sim/thread/contact/table.hpp"
#include "sim/thread/ftl/length_solver.hpp"
#include "sim/thread/ftl/resolve.hpp"

namespace sim::thread::ftl {

using contact::Table;

/// Solves contacts and lengths together, by the Schur complement of the lengths on the rows that push.
class CoupledSolver {
  public:
    static constexpr int most_rows = 64;  ///< The most rows that are solved together with all lengths.

    /// Makes room for a thread of at most so many links.
    explicit CoupledSolver(std::size_t most_links);

    /// Solves all rows that push, together with all lengths, by the factors of the last length solve; returns the worst
    /// overlap that its linear model expects to be left, 1 where it is small enough. O(n + m^2) for m rows.
    double solve(State& state, const LengthSolver& lengths);

    /// How many rows the last solve took together.
    std::size_t rows() const { return pushed_.size(); }
    /// Row c of those that the last solve took, from 0.
    const Row& row(std::size_t c) const { return *pushed_[c].row; }
    /// How far apart the points of row c should be after the last solve, by its linear model [m].
    Vec3 foreseen(std::size_t c);

  private:
    /// A number per axis of the rows.
    template <int rows, int columns>
    using PerAxis = Eigen::Matrix<double, rows, columns, columns == 1 ? Eigen::ColMajor : Eigen::RowMajor,
                                  rows == 1 ? 1 : 3 * most_rows, columns == 1 ? 1 : 3 * most_rows>;
    /// A row that pushes, and what its pushes do to the thread as a whole.
    struct PushedRow {
        explicit PushedRow(Row& of) : row(&of) {}

        Row* row;
        std::array<int, 4> node{};  // its points lie apart by the sum of weight * node
        std::array<double, 4> weight{};
        int nodes = 0;
        std::array<int, 8> link{};  // links whose lengths a push changes, by effect * push
        std::array<Vec3, 8> effect{};
        std::array<int, 8> place{};  // where those links are among all that rows touch
        int links = 0;
        Vec3 apart = Vec3::Zero();            // before all pushes [m]
        Eigen::Matrix3d diagonal_block = {};  // its block of the Delassus matrix
        double mobility = 0;                  // the same, along the normal
        Eigen::Matrix3d against = {};         // times a slip: the push that undoes it
    };
    /// Of the inverse of the lengths' matrix at a link: its diagonal, and the share of a solution that reaches from it
    /// to the next such link.
    struct Reach {
        double diagonal, share;
    };

    void collect(State& state, const LengthSolver& lengths);
    void add_effect(const State& state, const LengthSolver& lengths, PushedRow& row, int node, double weight) const;
    void measure_effects(const State& state, const LengthSolver& lengths, PushedRow& out) const;
    void invert_lengths(const State& state, const LengthSolver& lengths);
    void find_multipliers();
    void add_direct(const State& state, std::size_t d, Eigen::Map<Table::Matrix>& delassus);
    void measure_diagonal_block(const State& state, std::size_t c, const Eigen::Map<Table::Matrix>& delassus);
    void measure_delassus(const State& state, const LengthSolver& lengths);
    double push(const State& state, std::size_t c, const Eigen::Map<Table::Matrix>& delassus);
    double sweep(const State& state);
    void go_on_by(double again);
    double solve_pushes(const State& state);
    void move_by_pushes(State& state, const LengthSolver& lengths);

    std::vector<PushedRow> pushed_;
    PerAxis<Eigen::Dynamic, 1> pushes_;         // of all those rows
    PerAxis<Eigen::Dynamic, 1> pushes_before_;  // as a sweep began
    PerAxis<Eigen::Dynamic, 1> gain_;           // of a sweep
    PerAxis<Eigen::Dynamic, 1> search_;         // where sweeps lead
    Table delassus_;                            // the Delassus matrix: how far points move apart for unit pushes
    Table effects_, multipliers_;               // of unit pushes on lengths, and of the lengths' multipliers to those
    PerAxis<1, Eigen::Dynamic> from_left_;
    std::vector<double> weight_at_;  // per node; 0 between uses
    std::vector<int> touched_;       // links that pushed rows touch, increasing
    std::vector<Reach> inverse_;     // at those links
    std::vector<Vec3> move_;         // per node [m]
    std::vector<double> change_;     // per link: of the multipliers
};

}  // namespace sim::thread::ftl
