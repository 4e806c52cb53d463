#pragma once
#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "sim/geometry/hash.hpp"
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
    using Block = Eigen::Matrix3d;  ///< What couples two nodes: 3 x 3 numbers.

    BlockMatrix() = default;  ///< Of no nodes.
    /// `nodes`: how many. `couplings`: pairs of nodes with a block, from 0, in any order, also more than once.
    BlockMatrix(int nodes, std::span<const std::array<int, 2>> couplings);

    /// Where a block is kept.
    struct Place {
        int block;        ///< Its number.
        bool transposed;  ///< Of its two nodes the second is eliminated first.
    };
    /// The place of the block in row i and column j, of two nodes that are coupled or one and the same.
    Place place(int i, int j) const;

    /// Makes all blocks zero; none of them is factored then.
    void clear();
    /// Adds a block.
    void add(Place place, const Block& block);
    /// Adds a b^T and the matrix of the cross product w x.
    void add(Place place, const Vec3& a, const Vec3& b, const Vec3& w);
    /// Adds to the diagonal of a block.
    void add_diagonal(Place place, const Vec3& x);

    /// Goes on factoring with `work` block products, or a little more; true when it is done. A matrix that is not
    /// positive definite is done too, and not taken for solves.
    bool factor(long work);
    bool is_positive() const { return positive_; }  ///< The matrix that was factored last is positive definite.
    void use();                                     ///< Solves use the factors of that one from now on.

    long work() const { return work_; }  ///< Block products of a whole factorisation.
    /// x = A^-1 x, one entry for each node, off by at most 1e-7 times the condition of A. 90 us for 624 nodes of a
    /// tube, 150 us were factors kept whole.
    void solve(std::vector<Vec3>& x);
    /// Adds the numbers of the matrix and of its factors, not where they are.
    friend void add_to(sim::geometry::Hash& hash, const BlockMatrix& matrix);

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

    std::vector<int> rank_;          // of each node, when it is eliminated
    std::vector<int> node_;          // of each rank, the node
    std::vector<int> first_;         // column j has blocks first_[j] to first_[j + 1] - 1, its diagonal first
    std::vector<int> row_;           // of each block
    std::vector<int> column_;        // of each block
    std::vector<int> first_update_;  // row j has first_update_[j] to first_update_[j + 1] - 1 of update_
    std::vector<int> update_;        // blocks left of each row's diagonal
    long work_ = 0;                  // block products of a whole factorisation

    std::vector<Padded> next_;  // the matrix at work
    std::size_t at_ = 0;        // columns of it before this one are factored
    bool positive_ = false;     // so far
    Short finished_;            // factors of the matrix at work, as far as it has come
    Short factors_;             // factors that solves use

    // Scratch.
    std::vector<int> where_;  // of each row, its block in the column at work
    std::vector<Lane> x_;     // of each rank, the solution so far
};

}  // namespace tissue
