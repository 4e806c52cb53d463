#pragma once
#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "sim/geometry/vec.hpp"
#include "tissue/lanes.hpp"

namespace tissue {

using sim::geometry::Vec3;

/// A symmetric positive definite matrix of 3 x 3 blocks between nodes, factored (L L^T) in slices, so that no step has
/// to wait for all of it, while solves go on with the factors before. Finished factors are kept to 24 bits: a solve
/// waits for memory, and what it is for, the direction of a descent whose forces are exact, needs no more. Which blocks
/// there are is settled at the start; nothing is allocated afterwards.
class BlockMatrix {
  public:
    using Block = Eigen::Matrix3d;

    BlockMatrix() = default;
    /// `couplings`: pairs of nodes with a block, in any order.
    BlockMatrix(int nodes, std::span<const std::array<int, 2>> couplings);

    /// Number of the block in row i and column j; which of both comes first in the elimination decides whether it is
    /// kept transposed.
    struct Place {
        int block;
        bool transposed;
    };
    Place place(int i, int j) const;

    void clear();  ///< All zero, and none of it factored.
    void add(Place place, const Block& block);
    void add(Place place, const Vec3& a, const Vec3& b,
             const Vec3& w);                        ///< a b^T and the matrix of the cross product w x.
    void add_diagonal(Place place, const Vec3& x);  ///< To the diagonal of that block.

    /// Goes on factoring with `work` block products, or a little more; true when it is done. A matrix that is not
    /// positive definite is done too, and not taken for solves.
    bool factor(long work);
    bool is_positive() const { return positive_; }  ///< The one factored last.
    void use();                                     ///< Solves are with these factors from now on.

    long work() const { return work_; }  ///< Block products of a whole factorisation.
    /// x = A^-1 x, off by at most 1e-7 times the condition of A. 90 us for 624 nodes of a tube, 150 us were factors
    /// kept whole.
    void solve(std::vector<Vec3>& x);

  private:
    using Padded = std::array<Lane, 3>;  // columns of a block, their last number zero
    // To 24 bits without padding, as memory is what a solve waits for: columns of three numbers follow each other, and
    // are fetched with one of the next.
    struct Short {
        std::vector<float> numbers;
        void resize(std::size_t blocks) { numbers.resize(9 * blocks + 1); }
        Lane column(std::size_t block, std::size_t k) const { return from_short(numbers.data() + 9 * block + 3 * k); }
        void set(std::size_t block, const Padded& columns);
    };

    void analyse(std::span<const std::array<int, 2>> couplings);
    void update(std::size_t column);
    bool finish(std::size_t column);

    std::vector<int> rank_, node_;  // of a node in the elimination, and back
    std::vector<int> first_, row_,
        column_;  // of column j blocks first_[j] to first_[j + 1] - 1, its diagonal first; of a block
    std::vector<int> first_update_, update_;  // of row j, the blocks left of its diagonal
    std::vector<Padded> next_;
    Short finished_, factors_;  // of the matrix at work as far as it has come, of the one before
    std::vector<int> where_;    // of a row, its block in the column at work
    std::vector<Lane> x_;
    std::size_t at_ = 0;  // columns before are factored
    long work_ = 0;
    bool positive_ = false;
};

}  // namespace tissue
