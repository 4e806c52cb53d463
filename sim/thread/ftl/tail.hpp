#pragma once
#include <optional>

#include "sim/thread/ftl/state.hpp"

namespace sim::thread::ftl {

/// A strand from a held node to a free end.
struct Tail {
    std::size_t held;  ///< The held node.
    std::size_t end;   ///< The node at the free end.
    int step;          ///< What leads from one node to the next towards the free end, 1 or -1.

    /// The node after this one, seen from the hold.
    std::size_t next(std::size_t node) const { return node + static_cast<std::size_t>(step); }
    /// The node before this one, seen from the hold.
    std::size_t before(std::size_t node) const { return node - static_cast<std::size_t>(step); }
    /// The link to this node from the one before it, seen from the hold.
    std::size_t link_to(std::size_t node) const { return step > 0 ? node - 1 : node; }
};

/// The tail from a held node in the direction `step`, 1 or -1; nothing where another node is held that way or the piece
/// ends.
inline std::optional<Tail> tail_from(const State& state, std::size_t held, int step) {
    Tail tail{held, held, step};
    const auto has_next = [&] { return !(step > 0 ? state.is_last(tail.end) : state.is_first(tail.end)); };
    while (has_next() && state.inverse_mass[tail.next(tail.end)] > 0) tail.end = tail.next(tail.end);
    return has_next() || tail.end == held ? std::nullopt : std::optional(tail);
}

/// Calls with(tail) for every tail of the thread, by the number of its held node.
template <class Do>
void for_each_tail(const State& state, const Do& with) {
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
        for (const int step : {1, -1})
            if (state.inverse_mass[i] == 0)
                if (const auto tail = tail_from(state, i, step)) with(*tail);
}

}  // namespace sim::thread::ftl
