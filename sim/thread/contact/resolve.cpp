#include <algorithm>
#include <cmath>

#include "sim/geometry/at.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/thread/stages.hpp"

namespace sim::thread {

using geometry::closest_points;
using geometry::ClosestPair;

static Vec3 along(const Vec3& a, const Vec3& b, double s) {
    return a + s * (b - a);
}
static Vec3 on_link(const std::vector<Vec3>& nodes, int link, double s) {
    return along(nodes[at(link)], nodes[at(link + 1)], s);
}

static void push_link(State& state, int link, double place, const Vec3& push) {
    state.nodes[at(link)] += state.inverse_mass[at(link)] * (1 - place) * push;
    state.nodes[at(link + 1)] += state.inverse_mass[at(link + 1)] * place * push;
}

static double mobility(const State& state, int link, double place) {
    return state.inverse_mass[at(link)] * (1 - place) * (1 - place) + state.inverse_mass[at(link + 1)] * place * place;
}

double over_goal(const State& state, const Row& row, double distance) {
    const double thickness = 2 * state.def.radius;
    if (row.against == Against::thread) return std::max(0.0, (row.target - distance) / (strand_goal * thickness));
    // Lengths that are met after the last pass draw a taut thread in again.
    constexpr double room_for_lengths = 0.9;
    return std::max({0.0, (row.target - distance) / (0.1 * thickness),
                     (row.thickness - distance) / (room_for_lengths * steel_limit * thickness)});
}

double over_limit(const State& state, const Row& row) {
    const double limit = (row.against == Against::thread ? strand_limit : steel_limit) * 2 * state.def.radius;
    return std::max(0.0, (row.thickness - row.distance) / limit);
}

Vec3 apart_of(const State& state, const Row& row) {
    return on_link(state.nodes, row.link, row.s) -
           (row.against == Against::thread ? on_link(state.nodes, row.other, row.t) : row.fixed);
}

void push_apart(State& state, const Row& row, const Vec3& push) {
    push_link(state, row.link, row.s, push);
    if (row.against == Against::thread) push_link(state, row.other, row.t, -push);
}

double add_normal_push(Row& row, const Vec3& apart, double mobility) {
    const double before = row.normal_push;
    row.normal_push = std::max(0.0, before + (row.target - apart.dot(row.normal)) / mobility);
    return row.normal_push - before;
}

Vec3 slip_of(const Row& row, const Vec3& apart) {
    const Vec3 moved = apart - row.start;
    return moved - moved.dot(row.normal) * row.normal;
}

Vec3 add_tangent_push(Row& row, const Vec3& slip, const Vec3& wanted) {
    const Vec3 before = row.tangent_push;
    const double limit = row.friction * row.normal_push;
    row.tangent_push += wanted;
    const double size = row.tangent_push.norm();
    row.slip = size <= limit && limit > 0 ? slip.norm() : 0;
    if (size > limit) row.tangent_push *= limit / size;
    return row.tangent_push - before;
}

static double resolve(State& state, Row& row) {
    const Vec3 apart = apart_of(state, row);
    const double distance = apart.dot(row.normal);
    if (row.glides) return over_goal(state, row, distance);  // met by lengths (glide.cpp)
    if ((distance > row.target && row.normal_push == 0) || row.mobility == 0) return 0;
    const Vec3 slip = slip_of(row, apart), normal = add_normal_push(row, apart, row.mobility) * row.normal;
    push_apart(state, row, normal + add_tangent_push(row, slip, -slip / row.mobility));
    return std::max(over_goal(state, row, distance), row.slip / (slip_goal * 2 * state.def.radius));
}

double resolve_contacts(State& state) {
    double worst = 0;
    for (Row& row : state.rows) worst = std::max(worst, resolve(state, row));
    return worst;
}

// Within a substep a wall is the plane through the point that was nearest when it began: the link moves by less than
// the thread's radius meanwhile, and the next substep looks again.
static void aim_at_wall(const State& state, Row& row) {
    row.mobility = mobility(state, row.link, row.s);
    row.distance = (on_link(state.nodes, row.link, row.s) - row.fixed).dot(row.normal);
}

static void aim_at(const State& state, Row& row, const ClosestPair& pair) {
    row.s = pair.s;
    row.t = pair.t;
    row.fixed = pair.on_b;
    row.start = on_link(state.before, row.link, row.s);
    row.mobility = mobility(state, row.link, row.s);
    row.distance = std::sqrt(pair.distance_squared);
    if (row.distance > 0) row.normal = (pair.on_a - pair.on_b) / row.distance;
}

// Links along steel touch it in their middles, and a push there says as much of one end as of the other: errors that
// change from link to link would be answered by ever larger zigzags. So where thread lies finely on steel, the node
// between two links is pushed, until the two together lie right.
static void aim_at_nodes(State& state) {
    const double fine = 0.1 * state.def.radius;
    for (std::size_t r = 0; r + 1 < state.on_steel.size(); ++r) {
        Row& row = state.rows[at(state.on_steel[r])];
        const Row& next = state.rows[at(state.on_steel[r + 1])];
        if (!goes_on(row, next)) continue;
        const Vec3& node = state.nodes[at(next.link)];
        const Capsule &now = state.capsules[at(row.other)], &then = state.capsules_before[at(row.other)];
        const ClosestPair pair = closest_points(node, node, now.a, now.b);
        const double node_distance = std::sqrt(pair.distance_squared), distance = 0.5 * (row.distance + next.distance);
        if (std::abs(node_distance - distance) > fine) continue;
        // Across the thread, for steel that is smooth pushes no other way.
        const Vec3 out = node - pair.on_b,
                   chord = (state.nodes[at(next.link + 1)] - state.nodes[at(row.link)]).stableNormalized();
        row.s = 1;
        row.t = pair.t;
        row.normal = (out - out.dot(chord) * chord).stableNormalized();
        row.fixed = node - distance * row.normal;
        row.start = state.before[at(next.link)] - along(then.a, then.b, row.t);
        row.mobility = mobility(state, row.link, row.s);
        row.distance = distance;
    }
}

double aim(State& state) {
    double worst = 0;
    for (Row& row : state.rows) {
        const Vec3 &a0 = state.nodes[at(row.link)], &a1 = state.nodes[at(row.link + 1)];
        switch (row.against) {
            case Against::thread:
                aim_at(state, row, closest_points(a0, a1, state.nodes[at(row.other)], state.nodes[at(row.other + 1)]));
                row.start -= on_link(state.before, row.other, row.t);
                row.mobility += mobility(state, row.other, row.t);
                break;
            case Against::capsule: {
                const Capsule &now = state.capsules[at(row.other)], &then = state.capsules_before[at(row.other)];
                aim_at(state, row, closest_points(a0, a1, now.a, now.b));
                row.start -= along(then.a, then.b, row.t);
                break;
            }
            case Against::surface:
                aim_at_wall(state, row);
                break;
        }
        worst = std::max(worst, over_limit(state, row));
    }
    aim_at_nodes(state);
    return worst;
}

// A round thread cannot bend tighter than its own radius. Two links of length l that turn by the angle a go round a
// circle of radius l / (2 tan(a/2)), so their outer ends stay at least 2 l cos(a/2) apart; what one is longer comes on
// top.
double least_span(double a, double b, double radius) {
    const double l = std::min(a, b);
    return 2 * l * radius / std::sqrt(radius * radius + 0.25 * l * l) + std::abs(a - b);
}

void limit_bends(State& state) {
    for (std::size_t i = 1; i < state.rest.size(); ++i) {
        const double least = state.least_span[i];
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
