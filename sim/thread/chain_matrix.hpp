#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace sim::thread {

/// A symmetric positive definite matrix of 3 x 3 blocks, one row of them for each node of a chain, none further than two from the
/// diagonal. Solved directly, in time and room that grow with the number of nodes; with some nodes last, where its inverse is asked
/// for, and a dense part for them (time grows with the third power of their number).
class ChainMatrix {
  public:
    using Block = Eigen::Matrix3d;
    using Vec3 = geometry::Vec3;

    static constexpr int width = 9;     ///< Of the band in one column, its diagonal and all.
    static constexpr int stride = 12;   ///< From column to column.

    /// All zero. `touching`, the nodes that come last: increasing, each beside another one.
    void clear(std::size_t nodes, std::span<const int> touching = {});

    /// Adds to the block in row i and column j, i <= j <= i + 2, and what mirrors it; of a block on the diagonal all is given.
    void add(std::size_t i, std::size_t j, const Block& block);

    /// The matrix below its diagonal in one column of the band: row c of it is `stride` times c numbers on. For who fills all of it.
    double* column(std::size_t c) { return band_.data() + c * stride; }

    /// Subtracts from `right` what the band makes of node i being `x`, but at i itself.
    void lead(std::size_t i, const Vec3& x, std::vector<Vec3>& right) const;

    /// Node i is known to be zero: its row and column become those of the identity. Nothing may be added to it afterwards.
    void fix(std::size_t i);

    /// Factors the matrix with `more` added to all of its diagonal (L D L^T). False when that is not positive definite.
    bool factor(double more = 0);

    /// The part of A^-1 in the rows and columns of touching nodes, three scalars each in their order.
    Eigen::Map<const Eigen::MatrixXd> touching_inverse();

    /// Which of the touching nodes this is, counted from 0; -1: none.
    int place_of(std::size_t node) const { return place_[node]; }

    /// x = A^-1 x, by the last factors.
    void solve(std::vector<Vec3>& x) const;

  private:
    static constexpr int edge = 6, edge_stride = 8;  // scalars of the two touching nodes before a piece
    /// Nodes first to last - 1 touch nothing.
    struct Piece {
        std::size_t first, last;
        bool after_touching;  ///< Whether nodes first - 2 and first - 1 are there, and touch.
    };
    using Dense = Eigen::MatrixXd;

    void find_pieces();
    void reach_back(const Piece& piece);
    bool eliminate(const Piece& piece);
    void give_to_touching(const Piece& piece);
    bool factor_touching();
    void solve_forward(const Piece& piece, std::vector<Vec3>& x) const;
    void solve_backward(const Piece& piece, std::vector<Vec3>& x) const;
    Eigen::Index row_of(std::size_t touching_node) const { return 3 * place_[touching_node]; }

    std::size_t nodes_ = 0;
    std::vector<double> band_, factor_;   // columns
    std::vector<double> edges_;           // of the factors: per column, what couples it to the nodes before its piece
    std::vector<int> place_, touching_;
    std::vector<Piece> pieces_;
    Eigen::Matrix<double, edge_stride, edge_stride> own_;  // what a piece does to those two nodes
    std::vector<double> dense_room_;
    Eigen::Map<Dense> dense_{nullptr, 0, 0};  // its lower half
    mutable std::vector<double> touching_x_;
    std::vector<double> inverse_;
};

}  // namespace sim::thread
