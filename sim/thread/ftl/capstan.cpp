#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/geometry/portable_math.hpp"
#include "sim/thread/ftl/tail.hpp"
#include "sim/thread/stages.hpp"

namespace sim::thread {

void find_rubbed(State& state) {
    std::fill(state.rubbed.begin(), state.rubbed.end(), -1.0);
    for (const Row& row : state.rows)
        if (is_touched(state, row))
            for (const int link : {row.link, row.against == Against::thread ? row.other : row.link})
                state.rubbed[at(link)] = std::max(state.rubbed[at(link)], row.friction);
}

std::size_t last_rubbed(const State& state, const Tail& tail) {
    std::size_t node = tail.end;
    while (node != tail.held && state.rubbed[tail.link_to(node)] < 0) node = tail.before(node);
    return node;
}

// A free end lies as it was left. From the last place that the strand is drawn over to its hold it is taut: each turn
// is at one such place or the next, for nothing else turns it.
static void pull_through(State& state, const Tail& tail) {
    double grown = 0, friction = 0;  // the pull by e to this, since the free end
    for (std::size_t node = tail.end; node != tail.held; node = tail.before(node)) {
        const double here = node == tail.end ? -1 : std::max(state.rubbed[node - 1], state.rubbed[node]);
        if (here >= 0) friction = here;
        if (node != tail.end) grown += friction * turn_at(state, node);
        state.profile[tail.link_to(node)] = grown;
    }
    for (std::size_t node = tail.held; node != tail.end; node = tail.next(node)) {
        double& pull = state.profile[tail.link_to(tail.next(node))];
        pull = sim::geometry::portable_exp(pull - grown);
    }
}

void find_capstan_profile(State& state) {
    std::fill(state.profile.begin(), state.profile.end(), 0.0);
    for_each_tail(state, [&](const Tail& tail) { pull_through(state, tail); });
}

}  // namespace sim::thread
