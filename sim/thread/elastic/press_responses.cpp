#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/geometry/lane.hpp"
#include "sim/thread/elastic/press.hpp"

namespace sim::thread {

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

static void find_touching(State& state) {
    state.touching.clear();
    for (const Press& press : state.presses)
        state.touching.insert(state.touching.end(), press.pair.node.begin(),
                              press.pair.node.begin() + press.pair.nodes);
    std::sort(state.touching.begin(), state.touching.end());
    state.touching.erase(std::unique(state.touching.begin(), state.touching.end()), state.touching.end());
}

// Where each contact's nodes begin among those that touch, three axes each, and of which pieces they are.
static void find_places(State& state) {
    state.place.resize(state.nodes.size());
    state.first_touching.assign(state.island.size() + 1, 0);
    for (std::size_t k = 0; k < state.touching.size(); ++k) {
        state.place[at(state.touching[k])] = axes(k);
        state.first_touching[at(state.piece_of[at(state.touching[k])]) + 1] = k + 1;
    }
    for (std::size_t piece = 0; piece < state.island.size(); ++piece)
        state.first_touching[piece + 1] = std::max(state.first_touching[piece + 1], state.first_touching[piece]);
    for (Press& press : state.presses) {
        const Pair& pair = press.pair;
        press.place = {};
        for (int k = 0; k < pair.nodes; ++k) press.place[at(k)] = state.place[at(pair.node[at(k)])];
        press.piece = {-1, -1};
        if (pair.nodes > 0)
            press.piece = {state.piece_of[at(pair.node[0])], state.piece_of[at(pair.node[at(pair.nodes - 1)])]};
    }
}

// The contacts that are of one of two pieces, or of one.
static void add_answers(State& state, const std::array<int, 2>& pieces) {
    const auto is_one = [&](int piece) { return piece >= 0 && (piece == pieces[0] || piece == pieces[1]); };
    const std::size_t first = state.answering.size();
    for (std::size_t c = 0; c < state.presses.size(); ++c) {
        if (!is_one(state.presses[c].piece[0]) && !is_one(state.presses[c].piece[1])) continue;
        if (state.answering.size() > first && state.answering.back().past == c)
            ++state.answering.back().past;
        else
            state.answering.push_back({c, c + 1});
    }
    state.first_answer.push_back(state.answering.size());
}

// None to a contact that nothing moves, those of each piece, then of each contact between two.
static void find_answers(State& state) {
    state.first_answer.assign(2, 0), state.answering.clear();
    for (std::size_t piece = 0; piece < state.island.size(); ++piece) add_answers(state, {static_cast<int>(piece), -1});
    for (Press& press : state.presses) {
        press.answers = static_cast<std::size_t>(press.piece[0] + 1);
        if (press.piece[0] == press.piece[1]) continue;
        press.answers = state.first_answer.size() - 1;
        add_answers(state, press.piece);
    }
}

std::span<const Run> answers_to(const State& state, std::size_t d) {
    const std::size_t list = state.presses[d].answers;
    return std::span(state.answering)
        .subspan(state.first_answer[list], state.first_answer[list + 1] - state.first_answer[list]);
}

// It is symmetric: what is beyond the diagonal was found.
static void mirror(const State& state, Responses& responses) {
    for (std::size_t d = 0; d < state.presses.size(); ++d) {
        responses.block<3, 3>(axes(d), axes(d)).transposeInPlace();
        for (const Run& run : answers_to(state, d))
            for (std::size_t c = std::max(run.first, d + 1); c < run.past; ++c)
                responses.block<3, 3>(axes(c), axes(d)) = responses.block<3, 3>(axes(d), axes(c)).transpose();
    }
}

// Of each piece by itself: pieces know nothing of each other.
static void find_inverses(State& state) {
    state.first_inverse.assign(1, 0);
    const auto nodes_of = [&](std::size_t piece) {
        return std::span(state.touching)
            .subspan(state.first_touching[piece], state.first_touching[piece + 1] - state.first_touching[piece]);
    };
    for (std::size_t piece = 0; piece < state.island.size(); ++piece) {
        const std::size_t size = 3 * nodes_of(piece).size();
        state.first_inverse.push_back(state.first_inverse.back() + size * size);
    }
    if (const std::size_t all = state.first_inverse.back() + beyond; state.inverses.size() < all)
        state.inverses.resize(all);
    for (std::size_t piece = 0; piece < state.island.size(); ++piece)
        state.rod->matrix().inverse_at(nodes_of(piece), state.inverses.data() + state.first_inverse[piece]);
}

// What of a contact acts on a piece: its nodes in the columns of that one's inverse, for an axis. Others have no weight
// there.
static Weighing on_piece(const State& state, const Press& press, std::size_t piece, Eigen::Index axis) {
    const Eigen::Index first = axes(state.first_touching[piece]), rows = axes(state.first_touching[piece + 1]) - first;
    Weighing weighing{};
    for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Index own = press.place[k] - first;
        const bool is_of_it = press.pair.weight[k] != 0 && own >= 0 && own < rows;
        weighing.weight[k] = is_of_it ? press.pair.weight[k] : 0;
        weighing.place[k] = is_of_it ? (own + axis) * rows : 0;
    }
    return weighing;
}

// How the nodes that touch, of a contact's pieces, move for a unit push of it along an axis.
static void find_moves(State& state, const Press& press, Eigen::Index axis) {
    const auto move = [&](std::size_t piece) {
        const Weighing weighing = on_piece(state, press, piece, axis);
        const double* const inverse = state.inverses.data() + state.first_inverse[piece];
        double* const moves = state.press_moves.data() + axes(state.first_touching[piece]);
        const Eigen::Index rows = axes(state.first_touching[piece + 1] - state.first_touching[piece]);
        Eigen::Index i = 0;
        for (; i + 4 <= rows; i += 4) weighing.from(inverse + i).to(moves + i);
        if (i == rows) return;
        const Lane rest = weighing.from(inverse + i);
        for (std::size_t k = 0; i < rows; ++i, ++k) moves[i] = rest[k];
    };
    const auto [low, high] = std::minmax(press.piece[0], press.piece[1]);
    if (low >= 0) move(at(low));
    if (high > low) move(at(high));
}

static void forget_moves(State& state, const Press& press) {
    for (const int piece : press.piece)
        if (piece >= 0)
            std::fill(state.press_moves.begin() + axes(state.first_touching[at(piece)]),
                      state.press_moves.begin() + axes(state.first_touching[at(piece) + 1]), 0.0);
}

Responses measure_responses(State& state) {
    find_touching(state);
    find_places(state);
    find_answers(state);
    find_inverses(state);
    const std::vector<Press>& presses = state.presses;
    Responses responses = state.press_responses.resized(axes(presses.size()), axes(presses.size()));
    state.press_moves.assign(3 * state.touching.size() + beyond + 1, 0.0);  // four numbers even where nothing can move
    for (std::size_t d = 0; d < presses.size(); ++d) {
        for (Eigen::Index a = 0; a < 3; ++a) {
            find_moves(state, presses[d], a);
            double* const row = responses.row(axes(d) + a).data();
            std::fill_n(row + 3 * d, 3, 0.0);  // where nothing moves
            for (const Run& run : answers_to(state, d))
                for (std::size_t c = std::max(run.first, d); c < run.past; ++c)
                    Weighing{presses[c].pair.weight, presses[c].place}
                        .from(state.press_moves.data())
                        .three_to(row + 3 * c);
        }
        forget_moves(state, presses[d]);
    }
    mirror(state, responses);
    return responses;
}

}  // namespace sim::thread
