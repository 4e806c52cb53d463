#include "sim/thread/contact/rows.hpp"

#include <algorithm>
#include <cmath>

#include "sim/geometry/at.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/thread/contact/tolerances.hpp"

namespace sim::thread::contact {

using geometry::closest_points;
using geometry::ClosestPair;

static Vec3 along(const Vec3& a, const Vec3& b, double s) {
    return a + s * (b - a);
}

Vec3 point_on(const std::vector<Vec3>& nodes, int link, double s) {
    return along(nodes[at(link)], nodes[at(link + 1)], s);
}

double mobility_of(const State& state, int link, double place) {
    return state.inverse_mass[at(link)] * (1 - place) * (1 - place) + state.inverse_mass[at(link + 1)] * place * place;
}

double over_limit(const State& state, const Row& row) {
    const double limit = (row.against == Against::thread ? strand_limit : steel_limit) * 2 * state.def.radius;
    return std::max(0.0, (row.thickness - row.distance) / limit);
}

Vec3 apart_of(const State& state, const Row& row) {
    return point_on(state.nodes, row.link, row.s) -
           (row.against == Against::thread ? point_on(state.nodes, row.other, row.t) : row.fixed);
}

Vec3 slip_of(const Row& row, const Vec3& apart) {
    const Vec3 moved = apart - row.start;
    return moved - moved.dot(row.normal) * row.normal;
}

// Within a substep a wall is the plane through the point that was nearest when it began: the link moves by less than
// the thread's radius meanwhile, and the next substep looks again.
static void aim_at_wall(const State& state, Row& row) {
    row.mobility = mobility_of(state, row.link, row.s);
    row.distance = (point_on(state.nodes, row.link, row.s) - row.fixed).dot(row.normal);
}

static void aim_at(const State& state, Row& row, const ClosestPair& pair) {
    row.s = pair.s;
    row.t = pair.t;
    row.fixed = pair.on_b;
    row.start = point_on(state.before, row.link, row.s);
    row.mobility = mobility_of(state, row.link, row.s);
    row.distance = std::sqrt(pair.distance_squared);
    if (row.distance > 0) row.normal = (pair.on_a - pair.on_b) / row.distance;
}

double aim(State& state) {
    double worst = 0;
    for (Row& row : state.rows) {
        const Vec3 &a0 = state.nodes[at(row.link)], &a1 = state.nodes[at(row.link + 1)];
        switch (row.against) {
            case Against::thread:
                aim_at(state, row, closest_points(a0, a1, state.nodes[at(row.other)], state.nodes[at(row.other + 1)]));
                row.start -= point_on(state.before, row.other, row.t);
                row.mobility += mobility_of(state, row.other, row.t);
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
    return worst;
}

}  // namespace sim::thread::contact
