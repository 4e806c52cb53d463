#include <algorithm>
#include <numeric>

#include "sim/geometry/at.hpp"
#include "sim/thread/elastic/press_solver.hpp"

// Pieces of a cut thread that do not touch do not answer to each other's pushes. Each island of those that do is solved
// by itself: work is quadratic in the presses solved together, and a stitch that is tied is of no concern to the next.
namespace sim::thread::elastic {

IslandSolver::IslandSolver(std::size_t most_links) {
    alone_.presses.reserve(2 * most_links);
    alone_.apart.reserve(6 * most_links);
    pieces_.of_node.reserve(most_links + 1);
}

// Of a piece, the first that it touches or that those touch.
int IslandSolver::island_of(int piece) const {
    while (island_[at(piece)] != piece) piece = island_[at(piece)];
    return piece;
}

// What has no node that could move is with the first piece.
int IslandSolver::island_of(const Press& press) const {
    return island_of(press.pair.nodes > 0 ? pieces_.of_node[at(press.pair.node[0])] : 0);
}

void IslandSolver::find_islands(const State& state, const PressSet& set) {
    pieces_.find(state);
    island_.resize(pieces_.count);
    std::iota(island_.begin(), island_.end(), 0);
    for (const Press& press : set.presses)
        for (int k = 1; k < press.pair.nodes; ++k) {
            const int a = island_of(press), b = island_of(pieces_.of_node[at(press.pair.node[at(k)])]);
            island_[at(std::max(a, b))] = std::min(a, b);
        }
}

int IslandSolver::solve_island(State& state, PressSet& set, int island) {
    alone_.presses.clear();
    for (const Press& press : set.presses)
        if (island_of(press) == island) alone_.presses.push_back(press);
    const int sweeps = solver_.solve(state, alone_, pieces_);
    for (std::size_t c = 0, i = 0; c < set.presses.size(); ++c) {
        if (island_of(set.presses[c]) != island) continue;
        std::copy_n(alone_.apart.data() + 3 * i, 3, set.apart.data() + 3 * c);
        set.presses[c] = alone_.presses[i++];
    }
    return sweeps;
}

int IslandSolver::solve(State& state, PressSet& set) {
    find_islands(state, set);
    if (island_.size() == 1) return solver_.solve(state, set, pieces_);
    set.apart.assign(3 * set.presses.size(), 0.0);
    int sweeps = 0;
    for (std::size_t piece = 0; piece < island_.size(); ++piece)
        if (island_[piece] == static_cast<int>(piece))
            sweeps = std::max(sweeps, solve_island(state, set, static_cast<int>(piece)));
    return sweeps;
}

}  // namespace sim::thread::elastic
