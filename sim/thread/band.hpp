#pragma once
#include <Eigen/Core>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace sim::thread {

/// A symmetric positive definite matrix of 3 x 3 blocks, none further than two from the diagonal: what a rod's nodes do to each
/// other. Solved directly, in time and room that grow with the number of nodes.
class Band {
  public:
    using Block = Eigen::Matrix3d;
    using Vec3 = geometry::Vec3;

    void clear(std::size_t blocks) {
        for (auto* diagonal : {&diagonal_, &next_, &second_}) diagonal->assign(blocks, Block::Zero());
    }

    /// The block in row i and column j of the upper half: 0 <= j - i <= 2.
    Block& at(std::size_t i, std::size_t j) { return j == i ? diagonal_[i] : j == i + 1 ? next_[i] : second_[i]; }

    /// Unknown i is known to be zero: its row and column become those of the identity.
    void fix(std::size_t i);

    /// Turns the matrix into its factors (Cholesky); afterwards only solve() may be called. False when it is not positive definite.
    bool factor();

    /// x = A^-1 x.
    void solve(std::vector<Vec3>& x) const;

  private:
    std::vector<Block> diagonal_, next_, second_;
};

}  // namespace sim::thread
