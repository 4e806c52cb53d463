#include "sim/thread/state.hpp"

namespace sim::thread {

// Follow-The-Leader has no forces. What it has is lag: how far a held node is from where its tool wants it. A real thread
// of axial stiffness EA would be longer by that much over the span that carries the pull, so T = EA lag / span. The span
// runs from the held node, away from the pull, to the next held node or the end of the thread.
void estimate_tension(State& state) {
    std::fill(state.tension.begin(), state.tension.end(), 0.0);
    for (const Hold& hold : state.input.holds) {
        const auto i = static_cast<std::size_t>(hold.node);
        const Vec3 lag = hold.target - state.nodes[i];
        for (const int direction : {-1, +1}) {
            const std::size_t first_link = direction > 0 ? i : i - 1;
            if (first_link >= state.rest.size()) continue;  // no thread on this side
            const Vec3 away = state.nodes[direction > 0 ? i + 1 : i - 1] - state.nodes[i];
            const double pull = -lag.dot(away) / state.rest[first_link];
            if (pull <= 0) continue;
            double span = 0;
            std::size_t link = first_link;
            do {
                span += state.rest[link];
                const std::size_t node = direction > 0 ? link + 1 : link;
                link += static_cast<std::size_t>(direction);
                if (state.inverse_mass[node] == 0) break;
            } while (link < state.rest.size());
            const double tension = state.def.axial_stiffness * pull / span;
            for (std::size_t k = first_link; k != link; k += static_cast<std::size_t>(direction))
                state.tension[k] = std::max(state.tension[k], tension);
        }
    }
}

}  // namespace sim::thread
