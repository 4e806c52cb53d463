#include "sim/thread/elastic/advance.hpp"

#include <algorithm>
#include <limits>

#include "sim/geometry/at.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/thread/contact/gaps.hpp"
#include "sim/thread/contact/tolerances.hpp"

namespace sim::thread::elastic {

// How far a tool or a wall may be in a link; the rest is for turns.
static double deepest(const State& state) {
    return 0.8 * contact::steel_limit * 2 * state.def.radius;
}

static double depth_of(const Row& row) {
    return row.thickness - row.distance;
}
static double room_in(const State& state, const Row& row) {
    return std::max(0.0, deepest(state) - depth_of(row));
}

// A tool presses on a link, which while it hardly is in it responds within the step.
static double share_of_tool(const State& state, const Row& row) {
    const MovingCapsule& tool = state.input.capsules[at(row.other)];
    const Vec3 displacement = tool.to.a - tool.from.a + row.t * (tool.to.b - tool.to.a - tool.from.b + tool.from.a);
    const double into = displacement.dot(row.normal),
                 room = depth_of(row) < 0.6 * deepest(state) ? deepest(state) : room_in(state, row);
    return into > room ? room / into : 1;
}

static bool is_at_wall(const Row& row, int node) {
    return row.against == Against::surface && (row.link == node || row.link + 1 == node);
}

// Of each node, what is free between its links and the nearest wall at least.
void Advance::find_room_at_walls(const State& state) {
    room_at_walls_.assign(state.nodes.size(), std::numeric_limits<double>::infinity());
    for (const Contact& c : state.contacts) {
        if (c.against != Against::surface) continue;
        const double room = c.measured - 2 * (state.moved - c.measured_at) - c.thickness;
        for (const int node : {c.link, c.link + 1}) room_at_walls_[at(node)] = std::min(room_at_walls_[at(node)], room);
    }
}

static double share_of_node(const Row& row, int node) {
    return row.link == node ? 1 - row.s : row.s;
}

static bool is_in_jaws(const State& state, std::size_t hold) {
    return std::any_of(state.input.capsules.begin(), state.input.capsules.end(),
                       [&](const MovingCapsule& c) { return c.owner == state.input.hold_owners[hold]; });
}

// Neither a held node nor a wall gives way: what of its motion it may make before it touches one, and in jaws, of which
// it must not come out, when it does.
double Advance::share_at_walls(const State& state, std::size_t hold) const {
    const int node = state.input.holds[hold].node;
    const Vec3 displacement = state.input.holds[hold].target - state.hold_from[hold];
    double share = std::min(1.0, std::max(state.def.radius, room_at_walls_[at(node)]) / displacement.norm());
    if (!is_in_jaws(state, hold)) return share;
    for (const Row& row : state.rows) {
        const double into = -share_of_node(row, node) * displacement.dot(row.normal), room = room_in(state, row);
        if (is_at_wall(row, node) && into > room) share = std::min(share, room / into);
    }
    return share;
}

// Whether a row is of what is held, and with what leads it aside: a tool that does not hold it, or, if no jaws do, a
// wall.
static bool leads_aside(const State& state, const Row& row, std::size_t hold) {
    const int node = state.input.holds[hold].node;
    if ((row.link != node && row.link + 1 != node) || share_of_node(row, node) < 0.5)
        return false;  // one that touches nearer to its other end turns
    if (row.against == Against::capsule)
        return state.input.capsules[at(row.other)].owner != state.input.hold_owners[hold];
    return row.against == Against::surface && !is_in_jaws(state, hold);
}

// What of its way would lead it too far into that is left out, for all that the same tool holds: it slides.
void slide_aside(const State& state, std::vector<Hold>& targets) {
    constexpr int sweeps = 4;  // a corner between two
    const auto& owners = state.input.hold_owners;
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (const Row& row : state.rows)
            for (std::size_t h = 0; row.against != Against::thread && h < targets.size(); ++h) {
                if (!leads_aside(state, row, h)) continue;
                const Hold& hold = targets[h];
                const double into = (state.nodes[at(hold.node)] - hold.target).dot(row.normal),
                             room = room_in(state, row);
                for (std::size_t k = 0; into > room && k < owners.size(); ++k)
                    if (k == h || (owners[h] >= 0 && owners[k] == owners[h]))
                        targets[k].target += (into - room) * row.normal;
            }
}

// Whether the tool holds an end of the link.
static bool goes_along(const State& state, const Row& row) {
    const auto& holds = state.input.holds;
    for (std::size_t h = 0; h < holds.size(); ++h)
        if (state.input.hold_owners[h] == state.input.capsules[at(row.other)].owner &&
            (holds[h].node == row.link || holds[h].node == row.link + 1))
            return true;
    return false;
}

double Advance::share_of_tools(const State& state, double left, const Motion& motion) {
    find_room_at_walls(state);
    double share = std::min(left, unseen_room(state) / motion.of_capsules);
    for (const Contact& c : but_walls(state.contacts))
        if (c.against == Against::capsule) share = std::min(share, share_beside(state, c));
    for (std::size_t h = 0; h < state.hold_from.size(); ++h) share = std::min(share, share_at_walls(state, h));
    return share / left;
}

double careful_share(const State& state, double left, double share) {
    for (const Row& row : state.rows)
        if (row.against == Against::capsule && !goes_along(state, row))
            share = std::min(share, share_of_tool(state, row) / left);
    return share;
}

bool may_dare(const State& state) {
    const int enough = state.def.contacts_per_tick;
    return enough == 0 || static_cast<int>(state.pressed.size()) < enough;
}

bool is_deep(const State& state) {
    const std::span<const Vec3> step = state.rod.step_found();
    const auto then = [&](int node) { return Vec3(state.nodes[at(node)] + step[at(node)]); };
    const auto contacts = but_walls(state.contacts);
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
        if (c.against != Against::capsule || c.gap - c.thickness > closing(state)) return false;
        const Capsule& tool = state.capsules[at(c.other)];
        const double least = c.thickness - deepest(state);
        return geometry::closest_points(then(c.link), then(c.link + 1), tool.a, tool.b).distance_squared <
               least * least;
    });
}

}  // namespace sim::thread::elastic
