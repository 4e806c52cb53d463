#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/geometry/lane.hpp"
#include "sim/thread/press.hpp"

namespace sim::thread {

using geometry::Lane;

// Four numbers of what a contact makes of its nodes, from where each has them on. Always of four nodes, what is missing with no weight.
static Lane weighed(const Pair& pair, const double* from, const std::array<Eigen::Index, 4>& place) {
    Lane sum;
#pragma GCC unroll 4
    for (std::size_t k = 0; k < 4; ++k) sum += Lane(pair.weight[k]) * Lane::from(from + place[k]);
    return sum;
}

static void find_touching(State& state) {
    state.touching.clear();
    for (const Press& press : state.presses) state.touching.insert(state.touching.end(), press.pair.node.begin(), press.pair.node.begin() + press.pair.nodes);
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
        if (pair.nodes > 0) press.piece = {state.piece_of[at(pair.node[0])], state.piece_of[at(pair.node[at(pair.nodes - 1)])]};
    }
}

// The contacts that are of one of two pieces, or of one.
static void add_answers(State& state, const std::array<int, 2>& pieces) {
    const auto is_one = [&](int piece) { return piece >= 0 && (piece == pieces[0] || piece == pieces[1]); };
    for (std::size_t c = 0; c < state.presses.size(); ++c)
        if (is_one(state.presses[c].piece[0]) || is_one(state.presses[c].piece[1])) state.answer.push_back(c);
    state.first_answer.push_back(state.answer.size());
}

// Those of each piece, then of each contact between two.
static void find_answers(State& state) {
    state.first_answer.assign(1, 0), state.answer.clear();
    for (std::size_t piece = 0; piece < state.island.size(); ++piece) add_answers(state, {static_cast<int>(piece), -1});
    for (Press& press : state.presses) {
        press.answers = static_cast<std::size_t>(std::max(0, press.piece[0]));
        if (press.piece[0] == press.piece[1]) continue;
        press.answers = state.first_answer.size() - 1;
        add_answers(state, press.piece);
    }
}

// The contacts that move when d pushes, increasing: those that share a piece of thread with it.
static std::span<const std::size_t> answers_to(const State& state, std::size_t d) {
    const std::size_t list = state.presses[d].answers;
    return std::span(state.answer).subspan(state.first_answer[list], state.first_answer[list + 1] - state.first_answer[list]);
}

// It is symmetric: what is beyond the diagonal was found.
static void mirror(const State& state, Responses& responses) {
    for (std::size_t d = 0; d < state.presses.size(); ++d)
        for (const std::size_t c : answers_to(state, d)) {
            if (c == d) responses.block<3, 3>(axes(d), axes(d)).transposeInPlace();
            if (c > d) responses.block<3, 3>(axes(c), axes(d)) = responses.block<3, 3>(axes(d), axes(c)).transpose();
        }
}

// How the nodes that touch, of a contact's pieces, move for a unit push of it along an axis.
static void find_moves(State& state, const Eigen::Map<const Eigen::MatrixXd>& inverse, const Press& press, Eigen::Index axis) {
    std::array<Eigen::Index, 4> columns{};
    for (std::size_t k = 0; k < 4; ++k) columns[k] = (press.place[k] + axis) * inverse.rows();
    const auto [low, high] = std::minmax(press.piece[0], press.piece[1]);
    const auto move = [&](int piece) {
        const Eigen::Index past = axes(state.first_touching[at(piece) + 1]);
        for (Eigen::Index i = axes(state.first_touching[at(piece)]); i < past; i += 4) weighed(press.pair, inverse.data() + i, columns).to(state.press_moves.data() + i);
    };
    if (low >= 0) move(low);
    if (high > low) move(high);
}

static void forget_moves(State& state, const Press& press) {
    for (const int piece : press.piece)
        if (piece >= 0) std::fill(state.press_moves.begin() + axes(state.first_touching[at(piece)]), state.press_moves.begin() + axes(state.first_touching[at(piece) + 1]), 0.0);
}

Responses measure_responses(State& state) {
    find_touching(state);
    const auto inverse = state.rod->matrix().inverse_at(state.touching);
    find_places(state);
    find_answers(state);
    const std::vector<Press>& presses = state.presses;
    Responses responses = state.press_responses.resized(axes(presses.size()), axes(presses.size()));
    state.press_moves.assign(static_cast<std::size_t>(inverse.rows()) + ChainMatrix::beyond + 1, 0.0);  // four numbers even where nothing can move
    for (std::size_t d = 0; d < presses.size(); ++d) {
        const std::span<const std::size_t> answers = answers_to(state, d);
        for (Eigen::Index a = 0; a < 3; ++a) {
            find_moves(state, inverse, presses[d], a);
            double* const row = responses.row(axes(d) + a).data();
            if (answers.size() < presses.size()) std::fill_n(row, 3 * presses.size(), 0.0);
            for (const std::size_t c : answers)
                if (c >= d) weighed(presses[c].pair, state.press_moves.data(), presses[c].place).three_to(row + 3 * c);
        }
        forget_moves(state, presses[d]);
    }
    mirror(state, responses);
    return responses;
}

}  // namespace sim::thread
