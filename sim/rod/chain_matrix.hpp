#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace sim::rod {

/// A symmetric positive definite matrix of 3 x 3 blocks, one row of them for each node of a chain, none further than
/// two from the diagonal. Solved directly, in time and room that grow with the number of nodes.
class ChainMatrix {
  public:
    using Block = Eigen::Matrix3d;  ///< What couples two nodes: 3 x 3 numbers.
    using Vec3 = geometry::Vec3;    ///< What belongs to one node: 3 numbers.

    static constexpr int width = 9;    ///< Numbers of the band in one column, from the diagonal down.
    static constexpr int stride = 12;  ///< Numbers from the start of one column to that of the next.

    /// Makes it the zero matrix of a chain of so many nodes.
    void clear(std::size_t nodes);

    /// Adds to the block in row i and column j, i <= j <= i + 2, and what mirrors it; of a block on the diagonal all is
    /// given.
    void add(std::size_t i, std::size_t j, const Block& block);

    /// The matrix below its diagonal in one column of the band: row c of it is `stride` times c numbers on. For who
    /// fills all of it.
    double* column(std::size_t c) { return band_.data() + c * stride; }

    /// Subtracts from `right` what the band makes of node i being `x`, but at i itself.
    void lead(std::size_t i, const Vec3& x, std::vector<Vec3>& right) const;

    /// Node i is known to be zero: its row and column become those of the identity. Nothing may be added to it
    /// afterwards.
    void fix(std::size_t i);

    /// Factors the matrix with `more` added to all of its diagonal (L D L^T). False when that is not positive definite.
    bool factor(double more = 0);

    /// The part of A^-1 in the rows and columns of some nodes, increasing, three scalars each in their order, by the
    /// last factors: column after column, (3 n)^2 numbers from `to` on for n nodes [m/N of a rod's matrix]. Its time
    /// grows, piece by piece, with the nodes from the first of them to the end of the piece, times those.
    void inverse_at(std::span<const int> nodes, double* to);

    /// x = A^-1 x, by the last factors.
    void solve(std::vector<Vec3>& x) const;

  private:
    bool ends_at(std::size_t node) const;
    std::size_t first_in_piece(std::span<const int> nodes) const;
    void invert_band(std::size_t first, std::size_t last);
    void solve_forward(std::vector<Vec3>& x) const;
    void solve_backward(std::vector<Vec3>& x) const;

    std::size_t nodes_ = 0;
    std::vector<double> band_, factor_, inverse_band_;  // columns
};

}  // namespace sim::rod
