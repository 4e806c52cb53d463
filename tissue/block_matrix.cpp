// Sparse Cholesky factorisation L L^T of 3 x 3 blocks, left-looking, column by column, so that it can stop after any
// column. Order of elimination: approximate minimum degree. Source: Davis 2006, Direct Methods for Sparse Linear
// Systems, chapter
// 4. Cost: work() block products for a factorisation; a solve waits for memory (block_matrix.hpp).
#include "tissue/block_matrix.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace tissue {

namespace {

// Order of elimination by approximate minimum degree (Amestoy, Davis and Duff 1996): a quarter less to multiply than
// dissection of a tube by slices.
std::vector<int> elimination_order(int nodes, std::span<const std::array<int, 2>> couplings) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < nodes; ++i) entries.emplace_back(i, i, 1);
    for (const auto& [i, j] : couplings) entries.emplace_back(i, j, 1), entries.emplace_back(j, i, 1);
    Eigen::SparseMatrix<double> pattern(nodes, nodes);
    pattern.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(pattern, order);
    return {order.indices().data(), order.indices().data() + nodes};
}

}  // namespace

BlockMatrix::BlockMatrix(int nodes, std::span<const std::array<int, 2>> couplings)
    : node_(elimination_order(nodes, couplings)) {
    rank_.resize(node_.size());
    for (std::size_t r = 0; r < node_.size(); ++r) rank_[static_cast<std::size_t>(node_[r])] = static_cast<int>(r);
    analyse(couplings);
    next_.resize(row_.size()), finished_.resize(row_.size()), factors_.resize(row_.size());
    where_.assign(rank_.size(), -1);
    x_.resize(rank_.size());
    clear();
}

// Symbolic factorisation. Eliminating a node couples all nodes that it is coupled with, which the first of them hands
// on.
void BlockMatrix::analyse(std::span<const std::array<int, 2>> couplings) {
    const std::size_t n = rank_.size();
    std::vector<std::vector<int>> rows(n), left(n);
    for (std::size_t j = 0; j < n; ++j) rows[j].push_back(static_cast<int>(j));
    for (const auto& [a, b] : couplings) {
        const auto [low, high] = std::minmax(rank_[static_cast<std::size_t>(a)], rank_[static_cast<std::size_t>(b)]);
        if (low != high) rows[static_cast<std::size_t>(low)].push_back(high);
    }
    for (std::size_t j = 0; j < n; ++j) {
        std::vector<int>& own = rows[j];
        std::sort(own.begin(), own.end());
        own.erase(std::unique(own.begin(), own.end()), own.end());
        if (own.size() < 2) continue;
        std::vector<int>& parent = rows[static_cast<std::size_t>(own[1])];
        parent.insert(parent.end(), own.begin() + 1, own.end());
    }
    for (std::size_t j = 0; j < n; ++j) {
        first_.push_back(static_cast<int>(row_.size()));
        for (const int r : rows[j]) {
            if (r > static_cast<int>(j)) left[static_cast<std::size_t>(r)].push_back(static_cast<int>(row_.size()));
            row_.push_back(r), column_.push_back(static_cast<int>(j));
        }
        work_ += static_cast<long>(rows[j].size() * (rows[j].size() + 1) / 2);
    }
    first_.push_back(static_cast<int>(row_.size()));
    for (const std::vector<int>& updates : left) {
        first_update_.push_back(static_cast<int>(update_.size()));
        update_.insert(update_.end(), updates.begin(), updates.end());
    }
    first_update_.push_back(static_cast<int>(update_.size()));
}

BlockMatrix::Place BlockMatrix::place(int i, int j) const {
    const int a = rank_[static_cast<std::size_t>(i)], b = rank_[static_cast<std::size_t>(j)];
    const auto [low, high] = std::minmax(a, b);
    const auto begin = row_.begin() + first_[static_cast<std::size_t>(low)],
               end = row_.begin() + first_[static_cast<std::size_t>(low) + 1];
    const auto found = std::lower_bound(begin, end, high);
    assert(found != end && *found == high && "a block is asked for that was not among the couplings");
    return {static_cast<int>(found - row_.begin()), a < b};
}

void BlockMatrix::clear() {
    std::fill(next_.begin(), next_.end(), Padded{});
    at_ = 0;
    positive_ = true;
}

void BlockMatrix::add(Place place, const Block& block) {
    Padded& to = next_[static_cast<std::size_t>(place.block)];
    const Block turned = place.transposed ? Block(block.transpose()) : block;
    for (std::size_t c = 0; c < 3; ++c) {
        const double* column = turned.data() + 3 * c;
        to[c] += Lane(column[0], column[1], column[2], 0);
    }
}

void BlockMatrix::add(Place place, const Vec3& a, const Vec3& b, const Vec3& w) {
    Padded& to = next_[static_cast<std::size_t>(place.block)];
    const Vec3 &left = place.transposed ? b : a, &right = place.transposed ? a : b;
    const double turned = place.transposed ? -1 : 1, x = turned * w.x(), y = turned * w.y(), z = turned * w.z();
    const Lane column(left.x(), left.y(), left.z(), 0);
    to[0] += right.x() * column + Lane(0, z, -y, 0);
    to[1] += right.y() * column + Lane(-z, 0, x, 0);
    to[2] += right.z() * column + Lane(y, -x, 0, 0);
}

void BlockMatrix::add_diagonal(Place place, const Vec3& x) {
    Padded& to = next_[static_cast<std::size_t>(place.block)];
    to[0] += Lane(x.x(), 0, 0, 0), to[1] += Lane(0, x.y(), 0, 0), to[2] += Lane(0, 0, x.z(), 0);
}

// Subtracts from a column what the columns before, as far as they reach into its row, contribute.
void BlockMatrix::update(std::size_t j) {
    for (int b = first_[j]; b < first_[j + 1]; ++b)
        where_[static_cast<std::size_t>(row_[static_cast<std::size_t>(b)])] = b;
    Padded* const next = next_.data();
    const int *const where = where_.data(), *const row = row_.data();
    for (int u = first_update_[j]; u < first_update_[j + 1]; ++u) {
        const auto b = static_cast<std::size_t>(update_[static_cast<std::size_t>(u)]);
        const auto end = static_cast<std::size_t>(first_[static_cast<std::size_t>(column_[b]) + 1]);
        std::array<Lane, 9> by;  // each number four times, row by row; there are registers for them
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c) by[3 * r + c] = Lane(next[b][c][r]);
        for (std::size_t t = b; t < end; ++t) {
            Padded& to = next[where[row[t]]];
            const Lane x = next[t][0], y = next[t][1], z = next[t][2];
            to[0] = less_product(less_product(less_product(to[0], x, by[0]), y, by[1]), z, by[2]);
            to[1] = less_product(less_product(less_product(to[1], x, by[3]), y, by[4]), z, by[5]);
            to[2] = less_product(less_product(less_product(to[2], x, by[6]), y, by[7]), z, by[8]);
        }
    }
}

// The inverse of the Cholesky root of the diagonal block takes the block's place; the others are multiplied by it.
bool BlockMatrix::finish(std::size_t j) {
    Padded& own = next_[static_cast<std::size_t>(first_[j])];
    // What is left of a number after taking off nearly all of it is rounding below this share.
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    const double l00 = own[0][0], l10 = own[0][1], l20 = own[0][2],
                 size = rounding * (own[0][0] + own[1][1] + own[2][2]);
    if (!(l00 > size)) return false;
    const double a = 1 / std::sqrt(l00), m10 = l10 * a, m20 = l20 * a, left11 = own[1][1] - m10 * m10;
    if (!(left11 > size)) return false;
    const double b = 1 / std::sqrt(left11), m21 = (own[1][2] - m20 * m10) * b,
                 left22 = own[2][2] - m20 * m20 - m21 * m21;
    if (!(left22 > size)) return false;
    const double c = 1 / std::sqrt(left22), i10 = -m10 * a * b, i21 = -m21 * b * c, i20 = -(m20 * a + m21 * i10) * c;
    own = {Lane(a, i10, i20, 0), Lane(0, b, i21, 0), Lane(0, 0, c, 0)};
    const auto begin = static_cast<std::size_t>(first_[j]), end = static_cast<std::size_t>(first_[j + 1]);
    finished_.set(begin, own);
    for (std::size_t t = begin + 1; t < end; ++t) {
        Padded& block = next_[t];
        const Padded was = block;
        block = {was[0] * a, was[0] * i10 + was[1] * b, was[0] * i20 + was[1] * i21 + was[2] * c};
        finished_.set(t, block);
    }
    return true;
}

void BlockMatrix::Short::set(std::size_t block, const Padded& columns) {
    for (std::size_t k = 0; k < 3; ++k) to_short(columns[k], numbers.data() + 9 * block + 3 * k);
}

bool BlockMatrix::factor(long work) {
    for (; at_ < rank_.size() && positive_; ++at_) {
        if (work <= 0) return false;
        for (int u = first_update_[at_]; u < first_update_[at_ + 1]; ++u) {
            const int b = update_[static_cast<std::size_t>(u)];
            work -= first_[static_cast<std::size_t>(column_[static_cast<std::size_t>(b)]) + 1] - b;
        }
        work -= first_[at_ + 1] - first_[at_];
        update(at_);
        positive_ = finish(at_);
    }
    return true;
}

void BlockMatrix::use() {
    std::swap(factors_, finished_);
}

void BlockMatrix::solve(std::vector<Vec3>& x) {
    assert(x.size() == rank_.size() && "one entry for each node");
    const std::size_t n = rank_.size();
    for (std::size_t r = 0; r < n; ++r) {
        const Vec3& from = x[static_cast<std::size_t>(node_[r])];
        x_[r] = Lane(from.x(), from.y(), from.z(), 0);
    }
    for (std::size_t j = 0; j < n; ++j) {
        const auto begin = static_cast<std::size_t>(first_[j]), end = static_cast<std::size_t>(first_[j + 1]);
        const auto own = [&](std::size_t k) { return factors_.column(begin, k); };
        const Lane y = own(0) * x_[j][0] + own(1) * x_[j][1] + own(2) * x_[j][2], y0(y[0]), y1(y[1]), y2(y[2]);
        x_[j] = y;
        for (std::size_t t = begin + 1; t < end; ++t) {
            const auto l = [&](std::size_t k) { return factors_.column(t, k); };
            Lane& to = x_[static_cast<std::size_t>(row_[t])];
            to = less_product(less_product(less_product(to, l(0), y0), l(1), y1), l(2), y2);
        }
    }
    for (std::size_t j = n; j-- > 0;) {
        const auto begin = static_cast<std::size_t>(first_[j]), end = static_cast<std::size_t>(first_[j + 1]);
        Lane s0, s1, s2;
        for (std::size_t t = begin + 1; t < end; ++t) {
            const auto l = [&](std::size_t k) { return factors_.column(t, k); };
            const Lane& below = x_[static_cast<std::size_t>(row_[t])];
            s0 = less_product(s0, l(0), below), s1 = less_product(s1, l(1), below), s2 = less_product(s2, l(2), below);
        }
        const auto own = [&](std::size_t k) { return factors_.column(begin, k); };
        Lane y = x_[j] + Lane(s0.sum(), s1.sum(), s2.sum(), 0);
        y.clear_from(3);  // what the columns' fourth numbers made of it
        x_[j] = Lane((own(0) * y).sum(), (own(1) * y).sum(), (own(2) * y).sum(), 0);
    }
    for (std::size_t r = 0; r < n; ++r) x[static_cast<std::size_t>(node_[r])] = Vec3(x_[r][0], x_[r][1], x_[r][2]);
}

}  // namespace tissue
