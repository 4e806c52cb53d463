#include <algorithm>
#include <cmath>

#include "sim/geometry/at.hpp"
#include "sim/thread/stages.hpp"

namespace sim::thread {

void find_capstan_profile(State& state) {
    std::vector<double>& friction = state.upper;  // of links, where they touch; not needed until lengths are solved again
    std::fill(friction.begin(), friction.end(), 0.0);
    for (const Row& row : state.rows)
        if (row.against != Against::thread && is_touched(state, row)) friction[at(row.link)] = std::max(friction[at(row.link)], row.friction);
    std::fill(state.profile.begin(), state.profile.end(), 0.0);
    // A free end lies as it was left. From the first place that the strand is drawn over to its hold it is taut: each turn is at one such place or the next, for nothing else turns it.
    const auto pull_from = [&](std::size_t held, int step) {
        std::size_t node = held;
        while (step > 0 ? !state.is_last(node) : !state.is_first(node)) node += static_cast<std::size_t>(step);
        double pull = 1, rubs = 0;
        for (; node != held; node -= static_cast<std::size_t>(step)) {
            if (!state.is_end(node)) {
                const double here = std::max(friction[node - 1], friction[node]);
                if (here > 0) rubs = here;
                pull *= std::exp(rubs * turn_at(state, node));
            }
            state.profile[step > 0 ? node - 1 : node] = pull;
        }
    };
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        if (state.inverse_mass[i] > 0) continue;
        if (!state.is_last(i) && state.inverse_mass[i + 1] > 0) pull_from(i, 1);
        if (!state.is_first(i) && state.inverse_mass[i - 1] > 0) pull_from(i, -1);
    }
}

}  // namespace sim::thread
