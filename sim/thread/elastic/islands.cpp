#include <algorithm>
#include <numeric>

#include "sim/geometry/at.hpp"
#include "sim/thread/elastic/contact_solver.hpp"

// Pieces of a cut thread that do not touch do not move for each other's pushes. Each island of those that do is solved
// by itself: work is quadratic in the contacts solved together, and a stitch that is tied is of no concern to the next.
namespace sim::thread::elastic {

IslandSolver::IslandSolver(std::size_t most_links) {
    alone_.contacts.reserve(2 * most_links);
    alone_.apart.reserve(6 * most_links);
    pieces_.of_node.reserve(most_links + 1);
}

// Of a piece, the first that it touches or that those touch.
int IslandSolver::island_of(int piece) const {
    while (island_[at(piece)] != piece) piece = island_[at(piece)];
    return piece;
}

// What has no node that could move is with the first piece.
int IslandSolver::island_of(const ContactConstraint& contact) const {
    return island_of(contact.pair.nodes > 0 ? pieces_.of_node[at(contact.pair.node[0])] : 0);
}

void IslandSolver::find_islands(const State& state, const ContactSet& set) {
    pieces_.find(state);
    island_.resize(pieces_.count);
    std::iota(island_.begin(), island_.end(), 0);
    for (const ContactConstraint& contact : set.contacts)
        for (int k = 1; k < contact.pair.nodes; ++k) {
            const int a = island_of(contact), b = island_of(pieces_.of_node[at(contact.pair.node[at(k)])]);
            island_[at(std::max(a, b))] = std::min(a, b);
        }
}

int IslandSolver::solve_island(State& state, ContactSet& set, int island) {
    alone_.contacts.clear();
    for (const ContactConstraint& contact : set.contacts)
        if (island_of(contact) == island) alone_.contacts.push_back(contact);
    const int sweeps = solver_.solve(state, alone_, pieces_);
    for (std::size_t c = 0, i = 0; c < set.contacts.size(); ++c) {
        if (island_of(set.contacts[c]) != island) continue;
        std::copy_n(alone_.apart.data() + 3 * i, 3, set.apart.data() + 3 * c);
        set.contacts[c] = alone_.contacts[i++];
    }
    return sweeps;
}

int IslandSolver::solve(State& state, ContactSet& set) {
    find_islands(state, set);
    if (island_.size() == 1) return solver_.solve(state, set, pieces_);
    set.apart.assign(3 * set.contacts.size(), 0.0);
    int sweeps = 0;
    for (std::size_t piece = 0; piece < island_.size(); ++piece)
        if (island_[piece] == static_cast<int>(piece))
            sweeps = std::max(sweeps, solve_island(state, set, static_cast<int>(piece)));
    return sweeps;
}

}  // namespace sim::thread::elastic
