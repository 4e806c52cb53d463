#include "sim/thread/contact/gaps.hpp"

#include <algorithm>
#include <tuple>

#include "sim/geometry/at.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/contact/tolerances.hpp"

namespace sim::thread::contact {

using geometry::closest_points;
using geometry::ClosestPair;

static void tighten(State& state, int link, double room) {
    state.bound[at(link)] = std::min(state.bound[at(link)], room);
    state.bound[at(link + 1)] = std::min(state.bound[at(link + 1)], room);
}

// A node may use `bound_share` of the distance from either of its links to whatever they are not joined to. A surface
// stands still, so the thread may use both shares.
static void bound_nodes(State& state, const Contact& c) {
    tighten(state, c.link, (c.against == Against::surface ? 2 : 1) * bound_share * c.gap);
    if (c.against == Against::thread) tighten(state, c.other, bound_share * c.gap);
}

static ClosestPair nearest(const State& state, const Contact& c) {
    const Vec3 &a0 = state.nodes[at(c.link)], &a1 = state.nodes[at(c.link + 1)];
    if (c.against == Against::surface) return closest_points(a0, a1, (*state.input.surface)[c.other]);
    if (c.against == Against::capsule)
        return closest_points(a0, a1, state.capsules[at(c.other)].a, state.capsules[at(c.other)].b);
    return closest_points(a0, a1, state.nodes[at(c.other)], state.nodes[at(c.other + 1)]);
}

static Row row_of(const State& state, const Contact& c, const ClosestPair& pair) {
    const double friction = c.against == Against::capsule ? state.def.friction_tool : state.def.friction;
    const Vec3 apart = pair.on_a - pair.on_b;
    const Vec3 normal = c.gap > 0 ? Vec3(apart / c.gap) : Vec3::UnitZ();
    return {c.against, c.link, c.other, c.thickness, friction, 0, pair.s, pair.t, normal, apart, pair.on_b, c.gap};
}

// A substep moves what touches by less than a radius each; what is missed now is met next time, outside its bound
// still.
double closing(const State& state) {
    return 1.9 * state.def.radius;
}

double about_to_press(const State& state) {
    return 0.1 * 2 * state.def.radius;
}

// Of a link on a wall, less is no difference.
static double alike(const State& state) {
    return 0.01 * 2 * state.def.radius;
}

// A link that lies along a wall touches it all along, and which place is nearest changes from step to step: shown that
// alone it tumbles where another wall squeezes it. So it is shown its ends as well, where a triangle is straight below
// them. Not on rigid walls, between which nothing is squeezed.
static void add_ends(State& state, const Contact& c, const ClosestPair& nearest) {
    const auto& surface = *state.input.surface;
    for (const int end : {0, 1}) {
        if (nearest.s == end) continue;
        const Vec3& node = state.nodes[at(c.link + end)];
        ClosestPair pair = closest_points(node, node, surface[c.other]);
        pair.s = end;
        Contact there = c;
        there.gap = std::sqrt(pair.distance_squared);
        const bool is_below = there.gap < surface.plane_gap(c.other, node, node) + alike(state);
        if (is_below && there.gap < c.thickness + about_to_press(state))
            state.rows.push_back(row_of(state, there, pair));
    }
}

// Brings the gap up to date where it may matter. Nothing has come nearer by more than twice `moved` since it was
// measured, and a link is no nearer to a triangle than to its plane: what that leaves far enough off need not be
// measured again.
static void measure(State& state, Contact& c) {
    constexpr double still_good = 0.75;
    const double touchable = c.thickness + closing(state), at_least = c.measured - 2 * (state.moved - c.measured_at);
    c.gap = at_least;
    if (at_least > touchable && at_least > still_good * c.measured) return;
    c.measured_at = state.moved;
    if (c.against == Against::surface) {
        c.gap = c.measured =
            state.input.surface->plane_gap(c.other, state.nodes[at(c.link)], state.nodes[at(c.link + 1)]);
        if (c.gap > touchable) return;
    }
    const ClosestPair pair = nearest(state, c);
    c.gap = c.measured = std::sqrt(pair.distance_squared);
    c.place = pair.t;
    if (c.gap >= touchable || (c.against == Against::surface && state.sleeps(c.link))) return;
    state.rows.push_back(row_of(state, c, pair));
    if (is_on_soft_wall(state, c) && c.gap < c.thickness + about_to_press(state)) add_ends(state, c, pair);
}

// In a corner of a hole's rim a thread leans on both sides. An elastic one that is shown one of them slides off past
// the other and is thrown back, by half a radius a tick at 20 degrees; at 14 it rests. Follow-The-Leader, which has no
// forces, leans on nothing.
double same_direction_on_wall(const State& state) {
    return state.def.elastic ? 0.97 : 0.94;
}

using Rows = std::vector<Row>::iterator;

// What lies between a link's ends where the wall is no nearer than straight from the one to the other.
static Rows without_what_ends_say(const State& state, Rows first, Rows last) {
    const Rows ends = std::partition(
        first, last, [&](const Row& row) { return !is_on_soft_wall(state, row) || row.s == 0 || row.s == 1; });
    const auto is_at = [&](double s, const Row& row) {
        return [&state, s, &row](const Row& end) {
            return end.s == s && end.normal.dot(row.normal) > same_direction_on_wall(state);
        };
    };
    return std::remove_if(ends, last, [&](const Row& row) {
        const Rows a = std::find_if(first, ends, is_at(0, row)), b = std::find_if(first, ends, is_at(1, row));
        return a != ends && b != ends && row.distance > (1 - row.s) * a->distance + row.s * b->distance - alike(state);
    });
}

// A wall's small triangles give a link many rows that say the same: of those within a radius of each other that face
// the same way, the nearest. What does not is another wall or an edge.
static void merge_walls(State& state) {
    const double radius = state.def.radius, same_direction = same_direction_on_wall(state);
    std::vector<Row>& rows = state.rows;
    const auto of_one_link = [](const Row& a, const Row& b) { return a.against == b.against && a.link == b.link; };
    const auto order = [](const Row& row) { return std::tuple(row.distance, row.other, row.s); };
    auto kept = rows.begin();
    for (auto group = rows.begin(), next = group; group != rows.end(); group = next) {
        next = std::find_if(group, rows.end(), [&](const Row& row) { return !of_one_link(row, *group); });
        const bool on_wall = group->against == Against::surface;
        const auto first_kept = kept, past = on_wall ? without_what_ends_say(state, group, next) : next;
        if (on_wall) std::sort(group, past, [&](const Row& a, const Row& b) { return order(a) < order(b); });
        for (auto row = group; row != past; ++row) {
            const auto says_it = [&](const Row& known) {
                return known.normal.dot(row->normal) > same_direction &&
                       (known.fixed - row->fixed).squaredNorm() < radius * radius;
            };
            if (!on_wall || std::none_of(first_kept, kept, says_it)) *kept++ = *row;
        }
    }
    rows.erase(kept, rows.end());
}

void measure_tool_gaps(State& state) {
    for (Contact& c : but_walls(state.contacts))
        if (c.against == Against::capsule) measure(state, c);
}

void measure_gaps(State& state, double path) {
    // Things not among the contacts were farther than `reach`.
    std::fill(state.bound.begin(), state.bound.end(), bound_share * std::max(0.0, state.reach - 2 * state.moved));
    state.rows.clear();
    for (Contact& c : state.contacts) {
        measure(state, c);
        bound_nodes(state, c);
    }
    const auto room = [&](const Row& row, auto choose) {
        return choose(state.bound[at(row.link)], state.bound[at(row.link + 1)]);
    };
    const auto most = [](double a, double b) { return std::max(a, b); };
    const auto least = [](double a, double b) { return std::min(a, b); };
    // No more overlap is undone at once than leaves the nodes most of their bound: clipped moves would stretch links.
    constexpr double for_parting = 0.25;
    for (Row& row : state.rows) row.target = std::min(row.thickness, row.distance + for_parting * room(row, least));
    // A thread follows its leader: no node needs to go much farther than what is held, and what is out of that reach
    // needs no row. Thrice is seldom enough to be missed; a quarter of a radius is for parting strands.
    const double most_move = path > 0 ? std::max(3 * path, 0.25 * state.def.radius) : state.reach;
    for (double& bound : state.bound) bound = std::min(bound, most_move);
    std::erase_if(state.rows, [&](const Row& row) { return row.distance >= row.thickness + 2 * room(row, most); });
    merge_walls(state);
}

}  // namespace sim::thread::contact
