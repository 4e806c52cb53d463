#include "sim/thread/ftl/resolve.hpp"

#include <algorithm>
#include <cmath>

#include "sim/geometry/at.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/thread/contact/tolerances.hpp"

// Contacts one after the other: projected Gauss-Seidel on positions, with Coulomb friction by accumulated pushes
// (position-based dynamics [Macklin2016]). A pass costs O(rows) and hands a push on by one contact; what is many
// contacts away is left to the coupled solve.
namespace sim::thread::ftl {

using contact::mobility_of;
using contact::point_on;
using contact::steel_limit;

static void push_link(State& state, int link, double place, const Vec3& push) {
    state.nodes[at(link)] += state.inverse_mass[at(link)] * (1 - place) * push;
    state.nodes[at(link + 1)] += state.inverse_mass[at(link + 1)] * place * push;
}

double over_goal(const State& state, const Row& row, double distance) {
    const double thickness = 2 * state.def.radius;
    if (row.against == Against::thread) return std::max(0.0, (row.target - distance) / (strand_goal * thickness));
    // Lengths that are met after the last pass draw a taut thread in again.
    constexpr double room_for_lengths = 0.9;
    return std::max({0.0, (row.target - distance) / (0.1 * thickness),
                     (row.thickness - distance) / (room_for_lengths * steel_limit * thickness)});
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
    if (row.in_wrap) return over_goal(state, row, distance);  // met with the lengths, by the capstan solve
    if ((distance > row.target && row.normal_push == 0) || row.mobility == 0) return 0;
    const Vec3 slip = contact::slip_of(row, apart), normal = add_normal_push(row, apart, row.mobility) * row.normal;
    push_apart(state, row, normal + add_tangent_push(row, slip, -slip / row.mobility));
    return std::max(over_goal(state, row, distance), row.slip / (slip_goal * 2 * state.def.radius));
}

double resolve_contacts(State& state) {
    double worst = 0;
    for (Row& row : state.rows) worst = std::max(worst, resolve(state, row));
    return worst;
}

bool is_next_link(const Row& row, const Row& next) {
    return next.against == row.against && next.other == row.other && next.link == row.link + 1;
}

// Links along steel touch it in their middles, and a push there says as much of one end as of the other: errors that
// change from link to link would be answered by ever larger zigzags. So where thread lies finely on steel, the node
// between two links is pushed, until the two together lie right.
static void aim_at_nodes(State& state) {
    const double fine = 0.1 * state.def.radius;
    for (std::size_t r = 0; r + 1 < state.on_steel.size(); ++r) {
        Row& row = state.rows[at(state.on_steel[r])];
        const Row& next = state.rows[at(state.on_steel[r + 1])];
        if (!is_next_link(row, next)) continue;
        const Vec3& node = state.nodes[at(next.link)];
        const Capsule &now = state.capsules[at(row.other)], &then = state.capsules_before[at(row.other)];
        const geometry::ClosestPair pair = geometry::closest_points(node, node, now.a, now.b);
        const double node_distance = std::sqrt(pair.distance_squared), distance = 0.5 * (row.distance + next.distance);
        if (std::abs(node_distance - distance) > fine) continue;
        // Across the thread, for steel that is smooth pushes no other way.
        const Vec3 out = node - pair.on_b,
                   chord = (state.nodes[at(next.link + 1)] - state.nodes[at(row.link)]).stableNormalized();
        row.s = 1;
        row.t = pair.t;
        row.normal = (out - out.dot(chord) * chord).stableNormalized();
        row.fixed = node - distance * row.normal;
        row.start = state.before[at(next.link)] - Vec3(then.a + row.t * (then.b - then.a));
        row.mobility = mobility_of(state, row.link, row.s);
        row.distance = distance;
    }
}

double aim(State& state) {
    const double worst = contact::aim(state);
    aim_at_nodes(state);
    return worst;
}

}  // namespace sim::thread::ftl
