#include "sim/thread/ftl/tension.hpp"

#include <algorithm>
#include <limits>

#include "sim/geometry/portable_math.hpp"
#include "sim/thread/ftl/rubbed.hpp"

// Follow-The-Leader has no forces. What it has is lag: how far a held node is from where its tool wants it, and how the
// pull was passed on from link to link: by the capstan law where a strand slides along itself, else by the multipliers
// of the length solve (friction and bends take their share). A real thread of axial stiffness EA carrying a tension of
// that profile would be longer by the sum of T l / EA; the tension that makes this equal to the lag is the estimate.
// O(n).
namespace sim::thread::ftl {

TensionEstimate::TensionEstimate(std::size_t most_links) {
    for (auto* of_links : {&rubbed_, &profile_}) of_links->reserve(most_links);
}

// A free end lies as it was left. From the last place that the strand is drawn over to its hold it is taut: each turn
// is at one such place or the next, for nothing else turns it.
void TensionEstimate::pull_through(const State& state, const Tail& tail) {
    double grown = 0, friction = 0;  // the pull by e to this, since the free end
    for (std::size_t node = tail.end; node != tail.held; node = tail.before(node)) {
        const double here = node == tail.end ? -1 : std::max(rubbed_[node - 1], rubbed_[node]);
        if (here >= 0) friction = here;
        if (node != tail.end) grown += friction * turn_at(state, node);
        profile_[tail.link_to(node)] = grown;
    }
    for (std::size_t node = tail.held; node != tail.end; node = tail.next(node)) {
        double& pull = profile_[tail.link_to(tail.next(node))];
        pull = sim::geometry::portable_exp(pull - grown);
    }
}

void TensionEstimate::find_capstan_profile(const State& state) {
    profile_.assign(state.rest_length.size(), 0.0);
    for_each_tail(state, [&](const Tail& tail) { pull_through(state, tail); });
}

void TensionEstimate::spread(State& state, std::size_t first, int direction, double lag) const {
    const std::vector<double>& profile = profile_;
    const double at_hold = profile[first];
    if (at_hold == 0 || lag <= 0) return;
    double compliance = 0;  // [m/N] of the whole profile, times EA
    std::size_t last = first;
    for (std::size_t k = first; k < state.rest_length.size(); k += static_cast<std::size_t>(direction)) {
        if (profile[k] == 0) break;
        compliance += state.rest_length[k] * profile[k] / at_hold;
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
bool TensionEstimate::is_loose(const State& state, std::size_t held, int direction) const {
    const auto tail = tail_from(state, held, direction);
    return tail && last_rubbed(rubbed_, *tail) == held;
}

void TensionEstimate::find(State& state) {
    std::fill(state.tension.begin(), state.tension.end(), 0.0);
    find_rubbed(state, rubbed_);
    profile_.resize(state.rest_length.size());
    if (state.slides)
        find_capstan_profile(state);
    else
        std::transform(state.pulled.begin(), state.pulled.end(), profile_.begin(),
                       [](double by) { return std::max(0.0, -by); });
    for (std::size_t h = 0; h < state.input.holds.size(); ++h) {
        const Hold& hold = state.input.holds[h];
        const auto i = static_cast<std::size_t>(hold.node);
        const Vec3 lag = hold.wanted - state.nodes[i];
        const double most = most_lag(state, state.nodes[i] - state.hold_from[h]);
        for (const int direction : {-1, +1}) {
            const std::size_t link = direction > 0 ? i : i - 1;
            if (link >= state.rest_length.size() || state.is_cut(link) || is_loose(state, i, direction))
                continue;  // no thread on this side, or none that is held
            const Vec3 away = state.nodes[direction > 0 ? i + 1 : i - 1] - state.nodes[i];
            spread(state, link, direction, std::min(most, -lag.dot(away) / state.rest_length[link]));
        }
    }
}

}  // namespace sim::thread::ftl
