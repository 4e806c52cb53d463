#include "sim/rod/chain_matrix.hpp"

#include <algorithm>
#include <cassert>

namespace sim::rod {

using Eight = Eigen::Matrix<double, 8, 1>;
using Four = Eigen::Matrix<double, 4, 1>;

template <class Column>
static Eigen::Map<Column> at(double* p) {
    return Eigen::Map<Column>(p);
}

void ChainMatrix::clear(std::size_t nodes) {
    nodes_ = nodes;
    band_.assign((3 * nodes + width) * stride, 0.0);
}

void ChainMatrix::add(std::size_t i, std::size_t j, const Block& block) {
    assert(i <= j && j <= i + 2 && j < nodes_ && "a block of the band's upper half");
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t r = j == i ? c : 0; r < 3; ++r)
            band_[(3 * i + c) * stride + 3 * (j - i) + r - c] +=
                block(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(r));
}

void ChainMatrix::lead(std::size_t i, const Vec3& x, std::vector<Vec3>& right) const {
    assert(i < nodes_ && right.size() == nodes_);
    for (std::size_t j = i < 2 ? 0 : i - 2; j < std::min(nodes_, i + 3); ++j) {
        if (j == i) continue;
        const std::size_t first = std::min(i, j), by = 3 * (std::max(i, j) - first);
        for (std::size_t a = 0; a < 3; ++a)        // of the node that comes first
            for (std::size_t b = 0; b < 3; ++b) {  // of the other
                const double entry = band_[(3 * first + a) * stride + by + b - a];
                const auto [r, c] = j < i ? std::pair(a, b) : std::pair(b, a);
                right[j][static_cast<Eigen::Index>(r)] -= entry * x[static_cast<Eigen::Index>(c)];
            }
    }
}

void ChainMatrix::fix(std::size_t i) {
    assert(i < nodes_);
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
        std::fill_n(column(c), width, 0.0);
        column(c)[0] = 1;
        for (std::size_t before = c < width ? 0 : c - width + 1; before < c; ++before) column(before)[c - before] = 0;
    }
}

// L D L^T, column by column; each takes its part from the eight after it.
bool ChainMatrix::factor(double more) {
    factor_ = band_;
    for (std::size_t c = 0; c < 3 * nodes_; ++c) {
        double* const pivot = factor_.data() + c * stride;
        pivot[0] += more;
        if (!(pivot[0] > 0)) return false;
        pivot[0] = 1 / pivot[0];
        double below[16];
        at<Eight>(below) = at<Eight>(pivot + 1);
        at<Eight>(below + 8).setZero();
        at<Eight>(pivot + 1) *= pivot[0];
        for (std::size_t k = 0; k < 4; ++k) at<Eight>(pivot + (k + 1) * stride) -= pivot[k + 1] * at<Eight>(below + k);
        for (std::size_t k = 4; k < 8; ++k) at<Four>(pivot + (k + 1) * stride) -= pivot[k + 1] * at<Four>(below + k);
    }
    return true;
}

// Node by node, what is still to be eliminated of the next two in registers.
void ChainMatrix::solve_forward(std::vector<Vec3>& x) const {
    double window[9];
    const std::size_t past = nodes_ - 1;
    for (int r = 0; r < 6; ++r) window[r] = x[std::min(static_cast<std::size_t>(r / 3), past)][r % 3];
    for (std::size_t i = 0; i < nodes_; ++i) {
#pragma GCC unroll 9
        for (int r = 0; r < 3; ++r) window[6 + r] = x[std::min(i + 2, past)][r];
#pragma GCC unroll 3
        for (std::size_t c = 0; c < 3; ++c) {
            const double* const below = factor_.data() + (3 * i + c) * stride;
#pragma GCC unroll 9
            for (std::size_t r = c + 1; r < 9; ++r) window[r] -= window[c] * below[r - c];
        }
#pragma GCC unroll 9
        for (std::size_t r = 0; r < 3; ++r) x[i][static_cast<int>(r)] = window[r];
#pragma GCC unroll 9
        for (std::size_t r = 0; r < 6; ++r) window[r] = window[r + 3];
    }
}

void ChainMatrix::solve_backward(std::vector<Vec3>& x) const {
    double window[9] = {};
    for (std::size_t i = nodes_; i-- > 0;) {
#pragma GCC unroll 3
        for (std::size_t c = 3; c-- > 0;) {
            const double* const below = factor_.data() + (3 * i + c) * stride;
            double rest = x[i][static_cast<int>(c)] * below[0];
#pragma GCC unroll 9
            for (std::size_t r = 8; r > c; --r) rest -= below[r - c] * window[r];
            window[c] = rest;
        }
#pragma GCC unroll 9
        for (std::size_t r = 0; r < 3; ++r) x[i][static_cast<int>(r)] = window[r];
#pragma GCC unroll 9
        for (std::size_t r = 9; r-- > 3;) window[r] = window[r - 3];
    }
}

void ChainMatrix::solve(std::vector<Vec3>& x) const {
    assert(x.size() == nodes_ && "one entry for each node");
    solve_forward(x);
    solve_backward(x);
}

}  // namespace sim::rod
