#include <algorithm>
#include <limits>

#include "sim/thread/ftl/tail.hpp"
#include "sim/thread/stages.hpp"

namespace sim::thread {

// Follow-The-Leader has no forces. What it has is lag: how far a held node is from where its tool wants it, and how the
// pull was passed on from link to link: by the capstan law where a strand slides along itself, else by the multipliers
// of the length solve (friction and bends take their share). A real thread of axial stiffness EA carrying a tension of
// that profile would be longer by the sum of T l / EA; the tension that makes this equal to the lag is the estimate.
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

// What slid on in this tick is held by friction, not by as much as it lags: that is what the tick could not afford.
static double most_lag(const State& state, const Vec3& went) {
    constexpr double slid = 0.1, by_friction = 10;  // radii
    return state.slides && went.norm() > slid * state.def.radius ? by_friction * state.def.radius
                                                                 : std::numeric_limits<double>::infinity();
}

// Whether it ends free and touches nothing on its way there.
static bool is_loose(const State& state, std::size_t held, int direction) {
    const auto tail = tail_from(state, held, direction);
    return tail && last_rubbed(state, *tail) == held;
}

void estimate_tension(State& state) {
    std::fill(state.tension.begin(), state.tension.end(), 0.0);
    find_rubbed(state);
    if (state.slides)
        find_capstan_profile(state);
    else
        std::transform(state.pulled.begin(), state.pulled.end(), state.profile.begin(),
                       [](double by) { return std::max(0.0, -by); });
    for (std::size_t h = 0; h < state.input.holds.size(); ++h) {
        const Hold& hold = state.input.holds[h];
        const auto i = static_cast<std::size_t>(hold.node);
        const Vec3 lag = hold.wanted - state.nodes[i];
        const double most = most_lag(state, state.nodes[i] - state.hold_from[h]);
        for (const int direction : {-1, +1}) {
            const std::size_t link = direction > 0 ? i : i - 1;
            if (link >= state.rest.size() || state.is_cut(link) || is_loose(state, i, direction))
                continue;  // no thread on this side, or none that is held
            const Vec3 away = state.nodes[direction > 0 ? i + 1 : i - 1] - state.nodes[i];
            spread(state, link, direction, std::min(most, -lag.dot(away) / state.rest[link]));
        }
    }
}

}  // namespace sim::thread
