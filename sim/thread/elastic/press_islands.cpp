#include <algorithm>
#include <numeric>

#include "sim/geometry/at.hpp"
#include "sim/thread/elastic/press.hpp"

// Pieces of a cut thread that do not touch do not answer to each other's pushes. Each island of those that do is solved
// by itself: work is quadratic in the presses solved together, and a stitch that is tied is of no concern to the next.
namespace sim::thread {

// Of a piece, the first that it touches or that those touch.
static int island_of(const State& state, int piece) {
    while (state.island[at(piece)] != piece) piece = state.island[at(piece)];
    return piece;
}

// What has no node that could move is with the first piece.
static int island_of(const State& state, const Press& press) {
    return island_of(state, press.pair.nodes > 0 ? state.piece_of[at(press.pair.node[0])] : 0);
}

static void find_islands(State& state) {
    state.piece_of.assign(1, 0);
    for (std::size_t k = 0; k < state.rest.size(); ++k)
        state.piece_of.push_back(state.piece_of.back() + (state.is_cut(k) ? 1 : 0));
    state.island.resize(at(state.piece_of.back() + 1));
    std::iota(state.island.begin(), state.island.end(), 0);
    for (const Press& press : state.presses)
        for (int k = 1; k < press.pair.nodes; ++k) {
            const int a = island_of(state, press), b = island_of(state, state.piece_of[at(press.pair.node[at(k)])]);
            state.island[at(std::max(a, b))] = std::min(a, b);
        }
}

static int solve_island(State& state, int island) {
    state.presses.clear();
    for (const Press& press : state.all_presses)
        if (island_of(state, press) == island) state.presses.push_back(press);
    const int sweeps = solve_together(state);
    for (std::size_t c = 0, i = 0; c < state.all_presses.size(); ++c) {
        if (island_of(state, state.all_presses[c]) != island) continue;
        std::copy_n(state.apart.data() + 3 * i, 3, state.all_apart.data() + 3 * c);
        state.all_presses[c] = state.presses[i++];
    }
    return sweeps;
}

int solve_presses(State& state) {
    find_islands(state);
    if (state.island.size() == 1) return solve_together(state);
    state.all_presses.swap(state.presses);
    state.all_apart.assign(3 * state.all_presses.size(), 0.0);
    int sweeps = 0;
    for (std::size_t piece = 0; piece < state.island.size(); ++piece)
        if (state.island[piece] == static_cast<int>(piece))
            sweeps = std::max(sweeps, solve_island(state, static_cast<int>(piece)));
    state.all_presses.swap(state.presses);
    state.all_apart.swap(state.apart);
    return sweeps;
}

}  // namespace sim::thread
