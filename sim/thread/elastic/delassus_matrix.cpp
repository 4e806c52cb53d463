#include "sim/thread/elastic/delassus_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/geometry/at.hpp"
#include "sim/geometry/lane.hpp"

// The Delassus matrix W = J A^-1 J^T of the contacts' Jacobian J and the rod's band matrix A, by the columns of A^-1 at
// the nodes that touch, not by a solve a contact: a knot's contacts share nodes. Each piece of a cut thread
// moves by itself.

namespace sim::thread::elastic {

using geometry::Lane;

constexpr std::size_t beyond = 3;  // numbers behind the last, as four are read at once

// How much of a contact is at each of its nodes, always four, and where those have what it acts on.
struct Weighing {
    std::array<double, 4> weight;
    std::array<Eigen::Index, 4> place;

    /// Four numbers of what the contact makes of it.
    Lane from(const double* first) const {
        Lane sum;
#pragma GCC unroll 4
        for (std::size_t k = 0; k < 4; ++k) sum += Lane(weight[k]) * Lane::from(first + place[k]);
        return sum;
    }
};

void Pieces::find(const State& state) {
    of_node.assign(1, 0);
    for (std::size_t k = 0; k < state.rest_length.size(); ++k)
        of_node.push_back(of_node.back() + (state.is_cut(k) ? 1 : 0));
    count = at(of_node.back() + 1);
}

void DelassusMatrix::reserve(std::size_t contacts, std::size_t nodes) {
    constexpr double unwritten = std::numeric_limits<double>::quiet_NaN();
    table_.reserve(9 * contacts * contacts, unwritten);
    inverses_.assign(9 * nodes * nodes, unwritten);
}

DelassusMatrix::Block DelassusMatrix::block(std::size_t c, std::size_t d) const {
    return Block(table_.data() + axes(c) * size_ + axes(d), Eigen::OuterStride<>(size_));
}

void DelassusMatrix::find_touching(const std::vector<ContactConstraint>& contacts) {
    touching_.clear();
    for (const ContactConstraint& contact : contacts)
        touching_.insert(touching_.end(), contact.pair.node.begin(), contact.pair.node.begin() + contact.pair.nodes);
    std::sort(touching_.begin(), touching_.end());
    touching_.erase(std::unique(touching_.begin(), touching_.end()), touching_.end());
}

// Where each contact's nodes begin among those that touch, three axes each, and of which pieces they are.
void DelassusMatrix::find_places(const State& state, std::vector<ContactConstraint>& contacts, const Pieces& pieces) {
    place_.resize(state.nodes.size());
    first_touching_.assign(pieces.count + 1, 0);
    for (std::size_t k = 0; k < touching_.size(); ++k) {
        place_[at(touching_[k])] = axes(k);
        first_touching_[at(pieces.of_node[at(touching_[k])]) + 1] = k + 1;
    }
    for (std::size_t piece = 0; piece < pieces.count; ++piece)
        first_touching_[piece + 1] = std::max(first_touching_[piece + 1], first_touching_[piece]);
    for (ContactConstraint& contact : contacts) {
        const Pair& pair = contact.pair;
        contact.place = {};
        for (int k = 0; k < pair.nodes; ++k) contact.place[at(k)] = place_[at(pair.node[at(k)])];
        contact.piece = {-1, -1};
        if (pair.nodes > 0)
            contact.piece = {pieces.of_node[at(pair.node[0])], pieces.of_node[at(pair.node[at(pair.nodes - 1)])]};
    }
}

// The contacts that are of one of two pieces, or of one.
void DelassusMatrix::add_coupled(const std::vector<ContactConstraint>& contacts, const std::array<int, 2>& pieces) {
    const auto is_one = [&](int piece) { return piece >= 0 && (piece == pieces[0] || piece == pieces[1]); };
    const std::size_t first = coupled_.size();
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (!is_one(contacts[c].piece[0]) && !is_one(contacts[c].piece[1])) continue;
        if (coupled_.size() > first && coupled_.back().past == c)
            ++coupled_.back().past;
        else
            coupled_.push_back({c, c + 1});
    }
    first_coupled_.push_back(coupled_.size());
}

// None to a contact that nothing moves, those of each piece, then of each contact between two.
void DelassusMatrix::find_coupled(std::vector<ContactConstraint>& contacts, const Pieces& all) {
    first_coupled_.assign(2, 0), coupled_.clear();
    for (std::size_t piece = 0; piece < all.count; ++piece) add_coupled(contacts, {static_cast<int>(piece), -1});
    for (ContactConstraint& contact : contacts) {
        contact.coupled = static_cast<std::size_t>(contact.piece[0] + 1);
        if (contact.piece[0] == contact.piece[1]) continue;
        contact.coupled = first_coupled_.size() - 1;
        add_coupled(contacts, contact.piece);
    }
}

std::span<const Run> DelassusMatrix::coupled_with(const ContactConstraint& contact) const {
    const std::size_t list = contact.coupled;
    return std::span(coupled_).subspan(first_coupled_[list], first_coupled_[list + 1] - first_coupled_[list]);
}

// It is symmetric: what is beyond the diagonal was found.
void DelassusMatrix::mirror(const std::vector<ContactConstraint>& contacts) {
    auto matrix = table_.resized(size_, size_);
    for (std::size_t d = 0; d < contacts.size(); ++d) {
        matrix.block<3, 3>(axes(d), axes(d)).transposeInPlace();
        for (const Run& run : coupled_with(contacts[d]))
            for (std::size_t c = std::max(run.first, d + 1); c < run.past; ++c)
                matrix.block<3, 3>(axes(c), axes(d)) = matrix.block<3, 3>(axes(d), axes(c)).transpose();
    }
}

// Of each piece by itself: pieces know nothing of each other.
void DelassusMatrix::find_inverses(State& state, const Pieces& pieces) {
    first_inverse_.assign(1, 0);
    const auto nodes_of = [&](std::size_t piece) {
        return std::span(touching_).subspan(first_touching_[piece],
                                            first_touching_[piece + 1] - first_touching_[piece]);
    };
    for (std::size_t piece = 0; piece < pieces.count; ++piece) {
        const std::size_t size = 3 * nodes_of(piece).size();
        first_inverse_.push_back(first_inverse_.back() + size * size);
    }
    if (const std::size_t all = first_inverse_.back() + beyond; inverses_.size() < all) inverses_.resize(all);
    for (std::size_t piece = 0; piece < pieces.count; ++piece)
        state.rod.matrix().inverse_at(nodes_of(piece), inverses_.data() + first_inverse_[piece]);
}

// What of a contact acts on a piece: its nodes in the columns of that one's inverse, for an axis. Others have no weight
// there.
static Weighing on_piece(const ContactConstraint& contact, Eigen::Index first, Eigen::Index rows, Eigen::Index axis) {
    Weighing weighing{};
    for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Index own = contact.place[k] - first;
        const bool is_of_it = contact.pair.weight[k] != 0 && own >= 0 && own < rows;
        weighing.weight[k] = is_of_it ? contact.pair.weight[k] : 0;
        weighing.place[k] = is_of_it ? (own + axis) * rows : 0;
    }
    return weighing;
}

// How the nodes that touch, of a contact's pieces, move for a unit push of it along an axis.
void DelassusMatrix::find_moves(const ContactConstraint& contact, Eigen::Index axis) {
    const auto move = [&](std::size_t piece) {
        const Weighing weighing = on_piece(contact, axes(first_touching_[piece]),
                                           axes(first_touching_[piece + 1] - first_touching_[piece]), axis);
        const double* const inverse = inverses_.data() + first_inverse_[piece];
        double* const moves = moves_.data() + axes(first_touching_[piece]);
        const Eigen::Index rows = axes(first_touching_[piece + 1] - first_touching_[piece]);
        Eigen::Index i = 0;
        for (; i + 4 <= rows; i += 4) weighing.from(inverse + i).to(moves + i);
        if (i == rows) return;
        const Lane rest = weighing.from(inverse + i);
        for (std::size_t k = 0; i < rows; ++i, ++k) moves[i] = rest[k];
    };
    const auto [low, high] = std::minmax(contact.piece[0], contact.piece[1]);
    if (low >= 0) move(at(low));
    if (high > low) move(at(high));
}

void DelassusMatrix::forget_moves(const ContactConstraint& contact) {
    for (const int piece : contact.piece)
        if (piece >= 0)
            std::fill(moves_.begin() + axes(first_touching_[at(piece)]),
                      moves_.begin() + axes(first_touching_[at(piece) + 1]), 0.0);
}

void DelassusMatrix::measure(State& state, std::vector<ContactConstraint>& contacts, const Pieces& pieces) {
    find_touching(contacts);
    find_places(state, contacts, pieces);
    find_coupled(contacts, pieces);
    find_inverses(state, pieces);
    size_ = axes(contacts.size());
    auto matrix = table_.resized(size_, size_);
    moves_.assign(3 * touching_.size() + beyond + 1, 0.0);  // four numbers even where nothing can move
    for (std::size_t d = 0; d < contacts.size(); ++d) {
        for (Eigen::Index a = 0; a < 3; ++a) {
            find_moves(contacts[d], a);
            double* const row = matrix.row(axes(d) + a).data();
            std::fill_n(row + 3 * d, 3, 0.0);  // where nothing moves
            for (const Run& run : coupled_with(contacts[d]))
                for (std::size_t c = std::max(run.first, d); c < run.past; ++c)
                    Weighing{contacts[c].pair.weight, contacts[c].place}.from(moves_.data()).three_to(row + 3 * c);
        }
        forget_moves(contacts[d]);
    }
    mirror(contacts);
}

}  // namespace sim::thread::elastic
