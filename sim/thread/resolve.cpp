#include "sim/geometry/closest_points.hpp"
#include "sim/thread/state.hpp"

namespace sim::thread {

using geometry::ClosestPair;
using geometry::closest_points;

static std::size_t at(int i) { return static_cast<std::size_t>(i); }

static Vec3 along(const Vec3& a, const Vec3& b, double s) { return a + s * (b - a); }

// How far the touching points have slid over each other since the substep began: those of the link minus the other's.
static Vec3 slid(const State& state, const Contact& c, const ClosestPair& pair) {
    Vec3 slip = pair.on_a - along(state.before[at(c.link)], state.before[at(c.link + 1)], pair.s);
    if (c.against == Against::thread)
        slip -= pair.on_b - along(state.before[at(c.other)], state.before[at(c.other + 1)], pair.t);
    if (c.against == Against::capsule)
        slip -= pair.on_b - along(state.capsules_before[at(c.other)].a, state.capsules_before[at(c.other)].b, pair.t);
    return slip;
}

static void push_link(State& state, int link, double place, const Vec3& push) {
    state.nodes[at(link)] += state.inverse_mass[at(link)] * (1 - place) * push;
    state.nodes[at(link + 1)] += state.inverse_mass[at(link + 1)] * place * push;
}

static double mobility(const State& state, int link, double place) {
    return state.inverse_mass[at(link)] * (1 - place) * (1 - place) + state.inverse_mass[at(link + 1)] * place * place;
}

// What passes stop for: strands into each other by a thirtieth of the thread's thickness, thread into steel or a wall by a
// tenth of it, both out of sight.
static double over_goal(const State& state, const Contact& c, double distance) {
    const double goal = (c.against == Against::thread ? 0.03 : 0.1) * 2 * state.def.radius;
    return std::max(0.0, (c.target - distance) / goal);
}

// What tools wait for: strands by a twentieth, for there topology is at stake; a centre line half way to a tool's axis or
// to a wall, which only a thread that is trapped comes to.
static double over_limit(const Contact& c, double distance) {
    const double limit = (c.against == Against::thread ? 0.05 : 0.5) * c.thickness;
    return std::max(0.0, (c.thickness - distance) / limit);
}

// Projected Gauss-Seidel on one contact: the normal push never pulls, the tangential one stays in Coulomb's cone. Both
// are totals of the substep, so neither depends on how many passes are made or how long a tick is.
static double resolve(State& state, Contact& c) {
    const ClosestPair pair = nearest(state, c);
    const double distance = std::sqrt(pair.distance_squared);
    if (distance > c.target && c.normal_push == 0) return 0;
    if (distance > 0) c.normal = (pair.on_a - pair.on_b) / distance;

    double weight = mobility(state, c.link, pair.s);
    if (c.against == Against::thread) weight += mobility(state, c.other, pair.t);
    if (weight == 0) return 0;  // both held: nothing to push

    const double wanted = std::max(0.0, c.normal_push + (c.target - distance) / weight);
    Vec3 push = (wanted - c.normal_push) * c.normal;
    c.normal_push = wanted;

    Vec3 slip = slid(state, c, pair);
    slip -= slip.dot(c.normal) * c.normal;
    Vec3 tangent = c.tangent_push - slip / weight;
    const double limit = c.friction * c.normal_push, size = tangent.norm();
    if (size > limit) tangent *= limit / size;
    push += tangent - c.tangent_push;
    c.tangent_push = tangent;

    push_link(state, c.link, pair.s, push);
    if (c.against == Against::thread) push_link(state, c.other, pair.t, -push);
    return over_goal(state, c, distance);
}

double resolve_contacts(State& state) {
    double worst = 0;
    for (const int k : state.active) worst = std::max(worst, resolve(state, state.contacts[at(k)]));
    return worst;
}

double worst_overlap(const State& state) {
    double worst = 0;
    for (const int k : state.active) {
        const Contact& c = state.contacts[at(k)];
        worst = std::max(worst, over_limit(c, std::sqrt(nearest(state, c).distance_squared)));
    }
    return worst;
}

// A round thread cannot bend tighter than its own radius. Two links of length l that turn by the angle a go round a
// circle of radius l / (2 tan(a/2)), so their outer ends stay at least 2 l cos(a/2) apart.
void limit_bends(State& state) {
    for (std::size_t i = 1; i < state.rest.size(); ++i) {
        const double l = 0.5 * (state.rest[i - 1] + state.rest[i]), r = state.def.radius;
        const double least = 2 * l * r / std::sqrt(r * r + 0.25 * l * l);
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

}  // namespace sim::thread
