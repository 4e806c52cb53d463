#include <cmath>
#include <optional>

#include "sim/thread/contact/tolerances.hpp"
#include "sim/thread/links.hpp"

// The thread cut in two. A stump ends half a contact's thickness from where it was cut, as a round end does that covers
// what the cut left; so the two just touch, and as nothing moves nothing can be passed through.
namespace sim::thread {

using contact::State;

namespace {

/// A node, or one to be.
struct Place {
    std::size_t link;
    double along;  ///< From its first node [m].
};

// Where the stump towards `direction` ends; no place where no link of it would be left.
std::optional<Place> end_of_stump(const State& state, std::size_t link, double share, int direction) {
    double room = (direction < 0 ? share : 1 - share) * state.rest_length[link],
           off = 0.5 * (1 + contact::margin) * 2 * state.def.radius;
    while (off >= room) {
        if (direction < 0 ? state.is_first(link) : state.is_last(link + 1)) return {};
        off -= room;
        link += static_cast<std::size_t>(direction);
        room = state.rest_length[link];
    }
    double left = room - off;
    if (left < std::min(state.def.radius, 0.25 * state.rest_length[link])) {  // no link so short is any good
        if (direction < 0 ? state.is_first(link) : state.is_last(link + 1)) return {};
        left = 0;
    }
    return Place{link, direction < 0 ? left : state.rest_length[link] - left};
}

// The node there is, or is made, at a place.
std::size_t node_at(Mover& mover, const Place& place, std::span<int> held) {
    const State& state = state_of(mover);
    if (place.along == 0) return place.link;
    if (place.along < state.rest_length[place.link])
        split(mover, place.link, place.along / state.rest_length[place.link], held);
    return place.link + 1;
}

template <class T>
void erase(std::vector<T>& values, std::size_t first, std::size_t last) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(first),
                 values.begin() + static_cast<std::ptrdiff_t>(last));
}

// Nodes between the two stumps are no more, nor what pressed on their links.
void leave_out(Mover& mover, std::size_t first, std::size_t second, std::span<int> held) {
    State& state = state_of(mover);
    const int from = static_cast<int>(first), to = static_cast<int>(second), fewer = to - from - 1;
    for (int& node : held) node = node >= to ? node - fewer : node > from ? -1 : node;
    erase(state.nodes, first + 1, second);
    erase(state.inverse_mass, first + 1, second);
    for (std::vector<double>* of_links : {&state.rest_length, &state.tension}) {
        (*of_links)[first] = 0;
        erase(*of_links, first + 1, second);
    }
    std::visit([&](auto& one) { one.leave_out(first, second); }, mover);
}

// By how much it is bent, from the shape that it keeps, at the end where that is more [1/m].
double curvature(const Mover& mover, std::size_t link) {
    const State& state = state_of(mover);
    const auto* elastic = std::get_if<elastic::Mover>(&mover);
    const auto at = [&](std::size_t node) {
        if (state.is_end(node)) return 0.0;
        const double natural = elastic ? elastic->state().rod.natural_bends()[node] : 0;
        return 2 * std::abs(contact::turn_at(state, node) - natural) /
               (state.rest_length[node - 1] + state.rest_length[node]);
    };
    return std::max(at(link), at(link + 1));
}

}  // namespace

int most_loaded(const Mover& mover) {
    const State& state = state_of(mover);
    int found = -1;
    double most = 0;
    for (std::size_t k = 0; k < state.rest_length.size(); ++k) {
        if (state.is_cut(k) || state.tension[k] <= 0) continue;
        const double load = state.tension[k] * (1 + state.def.radius * curvature(mover, k));
        if (load <= most || !end_of_stump(state, k, 0.5, -1) || !end_of_stump(state, k, 0.5, +1)) continue;
        most = load;
        found = static_cast<int>(k);
    }
    return found;
}

bool cut(Mover& mover, std::size_t link, double share, std::span<int> held) {
    State& state = state_of(mover);
    if (state.is_cut(link)) return false;
    const auto before = end_of_stump(state, link, share, -1), after = end_of_stump(state, link, share, +1);
    if (!before || !after) return false;
    std::visit([&](auto& one) { one.wake_at(link); }, mover);
    std::size_t second = node_at(mover, *after, held);
    const std::size_t nodes = state.nodes.size(), first = node_at(mover, *before, held);
    second += state.nodes.size() - nodes;
    leave_out(mover, first, second, held);
    renew(mover);
    state.moved = 0;  // no link is joined before we have looked around again
    std::visit([](auto& one) { one.forget_jams(); }, mover);
    return true;
}

}  // namespace sim::thread
