#include "sim/thread/chain_matrix.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <new>

namespace sim::thread {

using Eight = Eigen::Matrix<double, 8, 1>;
using Four = Eigen::Matrix<double, 4, 1>;

template <class Column>
static Eigen::Map<Column> at(double* p) { return Eigen::Map<Column>(p); }
template <class Column>
static Eigen::Map<const Column> at(const double* p) { return Eigen::Map<const Column>(p); }

void ChainMatrix::clear(std::size_t nodes, std::span<const int> touching) {
    nodes_ = nodes;
    band_.assign((3 * nodes + width) * stride, 0.0);
    touching_.assign(touching.begin(), touching.end());
    place_.assign(nodes, -1);
    for (std::size_t k = 0; k < touching_.size(); ++k) place_[static_cast<std::size_t>(touching_[k])] = static_cast<int>(k);
    find_pieces();
}

void ChainMatrix::find_pieces() {
    pieces_.clear();
    for (std::size_t i = 0; i < nodes_;) {
        const std::size_t first = i;
        while (i < nodes_ && place_[i] < 0) ++i;
        if (i > first) pieces_.push_back({first, i, first > 0});
        while (i < nodes_ && place_[i] >= 0) ++i;
    }
}

void ChainMatrix::add(std::size_t i, std::size_t j, const Block& block) {
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t r = j == i ? c : 0; r < 3; ++r)
            band_[(3 * i + c) * stride + 3 * (j - i) + r - c] += block(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(r));
}

void ChainMatrix::lead(std::size_t i, const Vec3& x, std::vector<Vec3>& right) const {
    for (std::size_t j = i < 2 ? 0 : i - 2; j < std::min(nodes_, i + 3); ++j) {
        if (j == i) continue;
        const std::size_t first = std::min(i, j), by = 3 * (std::max(i, j) - first);
        for (std::size_t a = 0; a < 3; ++a)      // of the node that comes first
            for (std::size_t b = 0; b < 3; ++b) {  // of the other
                const double entry = band_[(3 * first + a) * stride + by + b - a];
                const auto [r, c] = j < i ? std::pair(a, b) : std::pair(b, a);
                right[j][static_cast<Eigen::Index>(r)] -= entry * x[static_cast<Eigen::Index>(c)];
            }
    }
}

void ChainMatrix::fix(std::size_t i) {
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
        std::fill_n(column(c), width, 0.0);
        column(c)[0] = 1;
        for (std::size_t before = c < width ? 0 : c - width + 1; before < c; ++before) column(before)[c - before] = 0;
    }
}

bool ChainMatrix::factor(double more) {
    factor_ = band_;
    for (std::size_t c = 0; c < 3 * nodes_; ++c) factor_[c * stride] += more;
    const auto size = static_cast<Eigen::Index>(3 * touching_.size());
    dense_room_.assign(static_cast<std::size_t>(size * size), 0.0);
    new (&dense_) Eigen::Map<Dense>(dense_room_.data(), size, size);
    if (size > 0) edges_.assign((3 * nodes_ + width) * edge_stride, 0.0);
    for (const Piece& piece : pieces_) {
        if (piece.after_touching) reach_back(piece);
        if (!eliminate(piece)) return false;
        if (piece.after_touching) give_to_touching(piece);
    }
    return size == 0 || factor_touching();
}

// What the two nodes before a piece and its first two do to each other.
void ChainMatrix::reach_back(const Piece& piece) {
    own_.setZero();
    const std::size_t from = 3 * (piece.first - 2), end = 3 * piece.last - from;
    for (std::size_t c = 0; c < edge; ++c)
        for (std::size_t r = edge; r < std::min(c + width, end); ++r) edges_[(from + r) * edge_stride + c] = band_[(from + c) * stride + r - c];
}

// L D L^T, column by column; each takes its part from the eight after it and from the nodes before the piece.
bool ChainMatrix::eliminate(const Piece& piece) {
    for (std::size_t c = 3 * piece.first; c < 3 * piece.last; ++c) {
        double* const pivot = factor_.data() + c * stride;
        if (!(pivot[0] > 0)) return false;
        pivot[0] = 1 / pivot[0];
        double below[16];
        at<Eight>(below) = at<Eight>(pivot + 1);
        at<Eight>(below + 8).setZero();
        at<Eight>(pivot + 1) *= pivot[0];
        for (std::size_t k = 0; k < 4; ++k) at<Eight>(pivot + (k + 1) * stride) -= pivot[k + 1] * at<Eight>(below + k);
        for (std::size_t k = 4; k < 8; ++k) at<Four>(pivot + (k + 1) * stride) -= pivot[k + 1] * at<Four>(below + k);
        if (!piece.after_touching) continue;
        double* const back = edges_.data() + c * edge_stride;
        for (std::size_t k = 0; k < 8; ++k) at<Eight>(back + (k + 1) * edge_stride) -= pivot[k + 1] * at<Eight>(back);
        const Eight scaled = pivot[0] * at<Eight>(back);
        own_.noalias() -= scaled * at<Eight>(back).transpose();
        at<Eight>(back) = scaled;
    }
    return true;
}

void ChainMatrix::give_to_touching(const Piece& piece) {
    const Eigen::Index before = row_of(piece.first - 2);
    dense_.block<edge, edge>(before, before) += own_.topLeftCorner<edge, edge>();
    if (piece.last == nodes_) return;
    const Eigen::Index after = row_of(piece.last);
    for (int r = 0; r < edge; ++r)
        dense_.block<1, edge>(after + r, before) += at<Eight>(edges_.data() + (3 * piece.last + static_cast<std::size_t>(r)) * edge_stride).head<edge>().transpose();
}

bool ChainMatrix::factor_touching() {
    for (const int node : touching_) {
        const auto i = static_cast<std::size_t>(node);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t r = c; r < c + width && 3 * i + r < 3 * nodes_; ++r)
                if (place_[i + r / 3] >= 0)
                    dense_(row_of(i + r / 3) + static_cast<Eigen::Index>(r % 3), row_of(i) + static_cast<Eigen::Index>(c)) += factor_[(3 * i + c) * stride + r - c];
    }
    const Eigen::LLT<Eigen::Ref<Dense>> in_place(dense_);
    return in_place.info() == Eigen::Success;
}

Eigen::Map<const Eigen::MatrixXd> ChainMatrix::touching_inverse() {
    const Eigen::Index size = dense_.rows();
    inverse_.resize(static_cast<std::size_t>(size * size));
    Eigen::Map<Dense> inverse(inverse_.data(), size, size);
    inverse.setIdentity();
    dense_.triangularView<Eigen::Lower>().solveInPlace(inverse);
    dense_.transpose().triangularView<Eigen::Upper>().solveInPlace(inverse);
    return {inverse_.data(), size, size};
}

// Node by node, what is still to be eliminated of the next two in registers.
void ChainMatrix::solve_forward(const Piece& piece, std::vector<Vec3>& x) const {
    double window[9], back[edge] = {};
    const std::size_t past = nodes_ - 1;
    for (int r = 0; r < 6; ++r) window[r] = x[std::min(piece.first + static_cast<std::size_t>(r / 3), past)][r % 3];
    for (std::size_t i = piece.first; i < piece.last; ++i) {
#pragma GCC unroll 9
        for (int r = 0; r < 3; ++r) window[6 + r] = x[std::min(i + 2, past)][r];
#pragma GCC unroll 3
        for (std::size_t c = 0; c < 3; ++c) {
            const double* const below = factor_.data() + (3 * i + c) * stride;
#pragma GCC unroll 9
            for (std::size_t r = c + 1; r < 9; ++r) window[r] -= window[c] * below[r - c];
            if (!piece.after_touching) continue;
            for (std::size_t e = 0; e < edge; ++e) back[e] += window[c] * edges_[(3 * i + c) * edge_stride + e];
        }
#pragma GCC unroll 9
        for (std::size_t r = 0; r < 3; ++r) x[i][static_cast<int>(r)] = window[r];
#pragma GCC unroll 9
        for (std::size_t r = 0; r < 6; ++r) window[r] = window[r + 3];
    }
    for (std::size_t r = 0; r < 6; ++r)
        if (piece.last + r / 3 < nodes_) x[piece.last + r / 3][static_cast<int>(r % 3)] = window[r];
    if (piece.after_touching)
        for (std::size_t e = 0; e < edge; ++e) x[piece.first - 2 + e / 3][static_cast<int>(e % 3)] -= back[e];
}

void ChainMatrix::solve_backward(const Piece& piece, std::vector<Vec3>& x) const {
    double window[9] = {}, back[edge] = {};
    for (std::size_t r = 0; r < 6; ++r)
        if (piece.last + r / 3 < nodes_) window[3 + r] = x[piece.last + r / 3][static_cast<int>(r % 3)];
    if (piece.after_touching)
        for (std::size_t e = 0; e < edge; ++e) back[e] = x[piece.first - 2 + e / 3][static_cast<int>(e % 3)];
    for (std::size_t i = piece.last; i-- > piece.first;) {
#pragma GCC unroll 3
        for (std::size_t c = 3; c-- > 0;) {
            const double* const below = factor_.data() + (3 * i + c) * stride;
            double rest = x[i][static_cast<int>(c)] * below[0];
#pragma GCC unroll 9
            for (std::size_t r = 8; r > c; --r) rest -= below[r - c] * window[r];
            if (piece.after_touching)
                for (std::size_t e = 0; e < edge; ++e) rest -= edges_[(3 * i + c) * edge_stride + e] * back[e];
            window[c] = rest;
        }
#pragma GCC unroll 9
        for (std::size_t r = 0; r < 3; ++r) x[i][static_cast<int>(r)] = window[r];
#pragma GCC unroll 9
        for (std::size_t r = 9; r-- > 3;) window[r] = window[r - 3];
    }
}

void ChainMatrix::solve(std::vector<Vec3>& x) const {
    for (const Piece& piece : pieces_) solve_forward(piece, x);
    if (!touching_.empty()) {
        touching_x_.resize(3 * touching_.size());
        Eigen::Map<Eigen::VectorXd> together(touching_x_.data(), dense_.rows());
        for (const int node : touching_) together.segment<3>(row_of(static_cast<std::size_t>(node))) = x[static_cast<std::size_t>(node)];
        dense_.triangularView<Eigen::Lower>().solveInPlace(together);
        dense_.transpose().triangularView<Eigen::Upper>().solveInPlace(together);
        for (const int node : touching_) x[static_cast<std::size_t>(node)] = together.segment<3>(row_of(static_cast<std::size_t>(node)));
    }
    for (auto piece = pieces_.rbegin(); piece != pieces_.rend(); ++piece) solve_backward(*piece, x);
}

}  // namespace sim::thread
