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

// Where each contact's nodes begin among those that touch, three axes each.
static void find_places(State& state) {
    state.place.resize(state.nodes.size());
    for (std::size_t k = 0; k < state.touching.size(); ++k) state.place[at(state.touching[k])] = axes(k);
    for (Press& press : state.presses) {
        press.place = {};
        for (int k = 0; k < press.pair.nodes; ++k) press.place[at(k)] = state.place[at(press.pair.node[at(k)])];
    }
}

// It is symmetric: what is beyond the diagonal was found.
static void mirror(Responses& responses, std::size_t presses) {
    for (std::size_t d = 0; d < presses; ++d) {
        responses.block<3, 3>(axes(d), axes(d)).transposeInPlace();
        for (Eigen::Index c = axes(d + 1); c < responses.cols(); ++c)
            for (Eigen::Index a = 0; a < 3; ++a) responses(c, axes(d) + a) = responses(axes(d) + a, c);
    }
}

Responses measure_responses(State& state) {
    find_touching(state);
    const auto inverse = state.rod->matrix().inverse_at(state.touching);
    find_places(state);
    const std::vector<Press>& presses = state.presses;
    Responses responses = state.press_responses.resized(axes(presses.size()), axes(presses.size()));
    const Eigen::Index touching = inverse.rows();
    state.press_moves.assign(static_cast<std::size_t>(touching) + ChainMatrix::beyond + 1, 0.0);  // four numbers even where nothing can move
    double* const moves = state.press_moves.data();
    for (std::size_t d = 0; d < presses.size(); ++d)
        for (Eigen::Index a = 0; a < 3; ++a) {
            std::array<Eigen::Index, 4> columns{};
            for (std::size_t k = 0; k < 4; ++k) columns[k] = (presses[d].place[k] + a) * touching;
            for (Eigen::Index i = 0; i < touching; i += 4) weighed(presses[d].pair, inverse.data() + i, columns).to(moves + i);
            double* const row = responses.row(axes(d) + a).data();
            for (std::size_t c = d; c < presses.size(); ++c) weighed(presses[c].pair, moves, presses[c].place).three_to(row + 3 * c);
        }
    mirror(responses, presses.size());
    return responses;
}

}  // namespace sim::thread
