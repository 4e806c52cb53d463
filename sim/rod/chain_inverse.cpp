#include <algorithm>
#include <cassert>

#include "sim/geometry/lane.hpp"
#include "sim/rod/chain_matrix.hpp"

namespace sim::rod {

using geometry::Lane;

// Where a chain is cut no number joins the nodes before to those after.
bool ChainMatrix::ends_at(std::size_t node) const {
    const std::size_t past = 3 * node + 3;
    for (std::size_t c = node > 0 ? 3 * node - 3 : 0; c < past; ++c)
        for (std::size_t k = past - c; k < width; ++k)
            if (factor_[c * stride + k] != 0) return false;
    return true;
}

// The inverse Z = D^-1 L^-1 + (1 - L^T) Z within the band, from the end of the piece with the last of these nodes
// [Takahashi, Fagan and Chin 1973] up to the first.
void ChainMatrix::invert_band(std::size_t first, std::size_t last) {
    using Eight = Eigen::Matrix<double, 8, 1>;
    const auto eight = [](double* p) { return Eigen::Map<Eight>(p); };
    inverse_band_.resize(band_.size());
    double next[8][8] = {};  // of the next eight rows and columns
    while (last + 1 < nodes_ && !ends_at(last)) ++last;
    for (std::size_t c = 3 * last + 3; c-- > 3 * first;) {
        const double* const below = factor_.data() + c * stride;
        Eight column = Eight::Zero();
        for (std::size_t k = 0; k < 8; ++k) column -= below[k + 1] * eight(next[k]);
        double pivot = below[0];
        for (std::size_t k = 0; k < 8; ++k) pivot -= below[k + 1] * column[static_cast<int>(k)];
        double* const kept = inverse_band_.data() + c * stride;
        kept[0] = pivot;
        eight(kept + 1) = column;
        for (std::size_t k = 8; k-- > 1;) {
            for (std::size_t r = 8; r-- > 1;) next[k][r] = next[k - 1][r - 1];
            next[k][0] = column[static_cast<int>(k) - 1];
        }
        eight(next[0]) = eight(kept);
    }
}

namespace {

constexpr std::size_t together = 8, ring = 12;  // columns of so many nodes at once, each a lane; rows of four nodes

// Rows of the inverse on their way up the chain: row r is at r modulo the ring.
struct Window {
    Lane rows[ring][together];
    Lane* row(std::size_t r) { return rows[r % ring]; }
};

// The three rows of a node from the eight below each, in columns `first` to `last`.
void go_up(Window& window, const double* factor, std::size_t node, std::size_t first, std::size_t last) {
    for (std::size_t r = 3 * node + 3; r-- > 3 * node;) {
        const double* const below = factor + r * ChainMatrix::stride;
        const Lane b1(below[1]), b2(below[2]), b3(below[3]), b4(below[4]), b5(below[5]), b6(below[6]), b7(below[7]),
            b8(-below[8]);
        const Lane *const r1 = window.row(r + 1), *const r2 = window.row(r + 2), *const r3 = window.row(r + 3),
                          *const r4 = window.row(r + 4), *const r5 = window.row(r + 5), *const r6 = window.row(r + 6),
                          *const r7 = window.row(r + 7), *const r8 = window.row(r + 8);
        Lane* const to = window.row(r);
        for (std::size_t p = first; p < last; ++p)
            to[p] =
                b8 * r8[p] - b7 * r7[p] - b6 * r6[p] - b5 * r5[p] - b4 * r4[p] - b3 * r3[p] - b2 * r2[p] - b1 * r1[p];
    }
}

}  // namespace

// Of nodes, increasing, the first that is in the same piece as the last of them.
std::size_t ChainMatrix::first_in_piece(std::span<const int> nodes) const {
    std::size_t first = nodes.size() - 1;
    for (auto node = static_cast<std::size_t>(nodes[first]);
         first > 0 && node-- > static_cast<std::size_t>(nodes.front()) && !ends_at(node);)
        if (node == static_cast<std::size_t>(nodes[first - 1])) --first;
    return first;
}

// Above the band Z is what its next eight rows make of it: the three columns of each node, from there up to the first
// node of its piece; pieces know nothing of each other. Columns go up together, as each row waits for the one below it.
void ChainMatrix::inverse_at(std::span<const int> nodes, double* to) {
    assert((nodes.empty() || (nodes.front() >= 0 && static_cast<std::size_t>(nodes.back()) < nodes_)) &&
           std::is_sorted(nodes.begin(), nodes.end()) && "nodes of the chain, increasing");
    const std::size_t count = nodes.size(), size = 3 * count;
    Window window;
    const auto node_at = [&](std::size_t place) { return static_cast<std::size_t>(nodes[place]); };
    if (count > 0) invert_band(node_at(0), node_at(count - 1));
    const auto inverse = [size, to](std::size_t column, std::size_t axis, std::size_t row) {
        return to + (3 * column + axis) * size + 3 * row;
    };
    for (std::size_t end = count, top = count; end > 0;) {
        if (end == top) top = first_in_piece(nodes.first(end));
        const std::size_t begin = std::max(top, end > together ? end - together : 0);
        const auto enter = [&](std::size_t place) {
            for (std::size_t r = 0; r < 9; ++r) {
                Lane& lane = window.row(3 * node_at(place) + r)[place - begin] = Lane();
                for (std::size_t c = 0; c < 3; ++c)
                    lane.q[c] = inverse_band_[(3 * node_at(place) + std::min(r, c)) * stride + (r < c ? c - r : r - c)];
            }
        };
        const auto keep = [&](std::size_t row, const std::array<const Lane*, 3>& found, std::size_t place) {
            const Lane x = found[0][place - begin], y = found[1][place - begin], z = found[2][place - begin];
            for (std::size_t c = 0; c < 3; ++c) Lane(x[c], y[c], z[c], 0).three_to(inverse(place, c, row));
            x.three_to(inverse(row, 0, place)), y.three_to(inverse(row, 1, place)), z.three_to(inverse(row, 2, place));
        };
        std::size_t first = end, row = end;  // of the columns that are on their way; what was kept last
        for (std::size_t node = node_at(end - 1); row > top; --node) {
            if (first < end) go_up(window, factor_.data(), node, first - begin, end - begin);
            if (node_at(row - 1) != node) continue;
            if (first > begin) enter(--first);
            --row;
            const std::array<const Lane*, 3> found{window.row(3 * node), window.row(3 * node + 1),
                                                   window.row(3 * node + 2)};
            for (std::size_t place = first; place < end; ++place) keep(row, found, place);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t place = begin; place < end; ++place) std::fill_n(inverse(place, c, 0), 3 * top, 0.0);
            for (std::size_t place = 0; place < top; ++place)
                std::fill_n(inverse(place, c, begin), 3 * (end - begin), 0.0);
        }
        end = begin;
    }
}

}  // namespace sim::rod
