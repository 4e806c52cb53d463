#include "sim/thread/ftl/bend_limit.hpp"

#include <algorithm>
#include <cmath>

// A distance constraint between the nodes on either side of each bend, solved one after the other (position-based
// dynamics): one pass a pass over contacts is enough, for a bend that is too tight is a local fault.
namespace sim::thread::ftl {

// A round thread cannot bend tighter than its own radius. Two links of length l that turn by the angle a go round a
// circle of radius l / (2 tan(a/2)), so their outer ends stay at least 2 l cos(a/2) apart; what one is longer comes on
// top.
static double least_span(double a, double b, double radius) {
    const double l = std::min(a, b);
    return 2 * l * radius / std::sqrt(radius * radius + 0.25 * l * l) + std::abs(a - b);
}

BendLimit::BendLimit(const State& state) {
    least_span_.reserve(state.most_links() + 1);
    resize(state);
}

void BendLimit::resize(const State& state) {
    const std::size_t n = state.rest_length.size();
    least_span_.assign(n, 0.0);
    for (std::size_t i = 1; i < n; ++i)
        if (!state.is_end(i))
            least_span_[i] = least_span(state.rest_length[i - 1], state.rest_length[i], state.def.radius);
}

void BendLimit::limit(State& state) const {
    for (std::size_t i = 1; i < state.rest_length.size(); ++i) {
        const double least = least_span_[i];
        const Vec3 d = state.nodes[i + 1] - state.nodes[i - 1];
        const double length2 = d.squaredNorm();
        if (length2 >= least * least || length2 == 0) continue;
        const double length = std::sqrt(length2), wa = state.inverse_mass[i - 1], wb = state.inverse_mass[i + 1];
        if (wa + wb == 0) continue;
        const Vec3 push = (least - length) / (length * (wa + wb)) * d;
        state.nodes[i - 1] -= wa * push;
        state.nodes[i + 1] += wb * push;
    }
}

}  // namespace sim::thread::ftl
