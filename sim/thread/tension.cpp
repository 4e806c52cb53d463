#include <algorithm>

#include "sim/thread/stages.hpp"

namespace sim::thread {

// Follow-The-Leader has no forces. What it has is lag: how far a held node is from where its tool wants it, and how the pull was
// passed on from link to link: by the capstan law where a strand slides along itself, else by the multipliers of the length solve (friction and bends take their
// share). A real thread of axial stiffness EA carrying a tension of that profile would be longer by the sum of T l / EA;
// the tension that makes this equal to the lag is the estimate.
static void spread(State& state, std::size_t first, int direction, double lag) {
    const std::vector<double>& profile = state.profile;
    const double at_hold = profile[first];
    if (at_hold == 0 || lag <= 0) return;
    double compliance = 0;  // [m/N] of the whole profile, times EA
    std::size_t last = first;
    for (std::size_t k = first; k < state.rest.size(); k += static_cast<std::size_t>(direction)) {
        if (profile[k] == 0) break;
        compliance += state.rest[k] * profile[k] / at_hold;
        last = k;
        if (state.inverse_mass[direction > 0 ? k + 1 : k] == 0) break;
    }
    const double tension = state.def.axial_stiffness * lag / compliance;
    for (std::size_t k = first;; k += static_cast<std::size_t>(direction)) {
        state.tension[k] = std::max(state.tension[k], tension * profile[k] / at_hold);
        if (k == last) break;
    }
}

void estimate_tension(State& state) {
    std::fill(state.tension.begin(), state.tension.end(), 0.0);
    if (may_slide(state) && is_taut(state))
        find_capstan_profile(state);
    else
        std::transform(state.pulled.begin(), state.pulled.end(), state.profile.begin(), [](double by) { return std::max(0.0, -by); });
    for (const Hold& hold : state.input.holds) {
        const auto i = static_cast<std::size_t>(hold.node);
        const Vec3 lag = hold.wanted - state.nodes[i];
        for (const int direction : {-1, +1}) {
            const std::size_t link = direction > 0 ? i : i - 1;
            if (link >= state.rest.size() || state.is_cut(link)) continue;  // no thread on this side
            const Vec3 away = state.nodes[direction > 0 ? i + 1 : i - 1] - state.nodes[i];
            spread(state, link, direction, -lag.dot(away) / state.rest[link]);
        }
    }
}

}  // namespace sim::thread
