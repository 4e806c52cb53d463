#include <algorithm>

#include "sim/geometry/closest_points.hpp"
#include "sim/thread/press.hpp"

// A tick of an elastic thread: one implicit step in which the rod and all that it touches are linear, a step of Newton's method; what
// that leaves is taken up by the next tick. Where a node has used up what it may move before we look around again, the rest of the
// tick is another such step.
namespace sim::thread {

static std::size_t at(int i) { return static_cast<std::size_t>(i); }

// How much nearer the step may bring what a contact is of: no point of a link goes farther than one of its ends.
static double nearing(std::span<const Vec3> step, const Contact& c) {
    const Vec3 &a = step[at(c.link)], &b = step[at(c.link + 1)];
    if (c.against != Against::thread) return std::max(a.norm(), b.norm());
    const Vec3 &from = step[at(c.other)], &to = step[at(c.other + 1)];
    return std::max({(a - from).norm(), (a - to).norm(), (b - from).norm(), (b - to).norm()});
}

// The largest share of the step that leaves every node within its bound, no contact's points farther along each other than links see
// straight, and what was too far to push, or for a row, just touching.
static double share_within_bounds(const State& state) {
    constexpr double for_lengths = 0.9, for_turning = 0.3;
    const double most = for_turning * 2 * state.def.radius;
    const std::span<const Vec3> step = state.rod->step_found();
    double share = 1;
    const auto limit = [&](double size, double to) { if (size > to) share = std::min(share, to / size); };
    double largest = 0;
    for (std::size_t i = 0; i < step.size(); ++i) {
        const double size = step[i].norm();
        largest = std::max(largest, size);
        limit(size, for_lengths * state.bound[i]);
    }
    for (const Contact& c : state.contacts)
        if (const double room = c.gap - c.thickness; room >= closing(state) && 2 * largest > room) limit(nearing(step, c), room);
    for (std::size_t c = 0; c < state.presses.size(); ++c) {
        const Press& press = state.presses[c];
        if (press.push.squaredNorm() > 0 && press.row->against == Against::thread)
            limit((Eigen::Map<const Vec3>(state.apart.data() + 3 * c) - apart_of(state, *press.row)).norm(), most);
    }
    for (const Row& row : state.rows)
        if (is_far(state, row)) limit(-way_of(state, row).dot(row.normal), row.distance - row.target);
    return share;
}

// Ends a step: what moved since `before` is known to pass through nothing by its bounds, and checked.
static void end_step(State& state, TickReport& report) {
    double moved = largest_capsule_move(state);
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const double way = (state.nodes[i] - state.before[i]).norm();
        moved = std::max(moved, way);
        if (way > 0) report.step_over_bound = std::max(report.step_over_bound, way / state.bound[i]);
    }
    state.moved += moved;
    report.pass_throughs += audit(state);
    ++report.substeps;
    state.pressed.clear();
    for (const Press& press : state.presses) {
        if (press.push.squaredNorm() == 0) continue;
        Row& row = state.pressed.emplace_back(*press.row);
        row.normal_push = press.push.dot(row.normal);
        row.tangent_push = press.push - row.normal_push * row.normal;
    }
}

// What the pushes have become since the rod's step was found.
static void add_changes(State& state) {
    state.forces.assign(state.nodes.size(), Vec3::Zero());
    for (const Press& press : state.presses)
        for (int k = 0; k < press.pair.nodes; ++k) state.forces[at(press.pair.node[at(k)])] += press.pair.weight[at(k)] * (press.push - press.pair.force);
    if (!state.presses.empty()) state.rod->add_forces(state.forces);
}

// How far a tool or a wall may be in a link; the rest is for turns.
static double deepest(const State& state) { return 0.8 * steel_limit * 2 * state.def.radius; }

static double depth_of(const Row& row) { return row.thickness - row.distance; }
static double room_in(const State& state, const Row& row) { return std::max(0.0, deepest(state) - depth_of(row)); }

// A tool presses on a link, which while it hardly is in it answers within the step.
static double share_of_tool(const State& state, const Row& row) {
    const MovingCapsule& tool = state.input.capsules[at(row.other)];
    const Vec3 way = tool.to.a - tool.from.a + row.t * (tool.to.b - tool.to.a - tool.from.b + tool.from.a);
    const double into = way.dot(row.normal), room = depth_of(row) < 0.6 * deepest(state) ? deepest(state) : room_in(state, row);
    return into > room ? room / into : 1;
}

// A row or contact, with a wall, of a link that ends in this node.
template <class Near>
static bool is_at_wall(const Near& near, int node) { return near.against == Against::surface && (near.link == node || near.link + 1 == node); }

static double share_of_node(const Row& row, int node) { return row.link == node ? 1 - row.s : row.s; }

static bool is_in_jaws(const State& state, std::size_t hold) {
    return std::any_of(state.input.capsules.begin(), state.input.capsules.end(), [&](const MovingCapsule& c) { return c.owner == state.input.hold_owners[hold]; });
}

// Neither a held node nor a wall gives way: what of its motion it may make before it touches one, and in jaws, of which it must not come out, when it does.
static double share_at_walls(const State& state, std::size_t hold) {
    const int node = state.input.holds[hold].node;
    const Vec3 way = state.input.holds[hold].target - state.hold_from[hold];
    double share = 1;
    for (const Contact& c : state.contacts)
        if (is_at_wall(c, node)) share = std::min(share, std::max(state.def.radius, c.measured - 2 * (state.moved - c.measured_at) - c.thickness) / way.norm());
    if (!is_in_jaws(state, hold)) return share;
    for (const Row& row : state.rows) {
        const double into = -share_of_node(row, node) * way.dot(row.normal), room = room_in(state, row);
        if (is_at_wall(row, node) && into > room) share = std::min(share, room / into);
    }
    return share;
}

// Whether a row is of what is held, and with what leads it aside: a tool that does not hold it, or, if no jaws do, a wall.
static bool leads_aside(const State& state, const Row& row, std::size_t hold) {
    const int node = state.input.holds[hold].node;
    if ((row.link != node && row.link + 1 != node) || share_of_node(row, node) < 0.5) return false;  // one that touches nearer to its other end turns
    if (row.against == Against::capsule) return state.input.capsules[at(row.other)].owner != state.input.hold_owners[hold];
    return row.against == Against::surface && !is_in_jaws(state, hold);
}

// What of its way would lead it too far into that is left out, for all that the same tool holds: it slides.
static void slide(State& state) {
    constexpr int sweeps = 4;  // a corner between two
    const auto& owners = state.input.hold_owners;
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (const Row& row : state.rows)
            for (std::size_t h = 0; row.against != Against::thread && h < state.targets.size(); ++h) {
                if (!leads_aside(state, row, h)) continue;
                const Hold& hold = state.targets[h];
                const double into = (state.nodes[at(hold.node)] - hold.target).dot(row.normal), room = room_in(state, row);
                for (std::size_t k = 0; into > room && k < owners.size(); ++k)
                    if (owners[k] == owners[h]) state.targets[k].target += (into - room) * row.normal;
            }
}

// Whether the tool holds an end of the link.
static bool goes_along(const State& state, const Row& row) {
    const auto& holds = state.input.holds;
    for (std::size_t h = 0; h < holds.size(); ++h)
        if (state.input.hold_owners[h] == state.input.capsules[at(row.other)].owner && (holds[h].node == row.link || holds[h].node == row.link + 1)) return true;
    return false;
}

// What share of the motion that is left tools may make before we look again, should the thread answer as freely as it may.
static double share_of_tools(const State& state, double left, const Motion& motion) {
    double share = std::min(left, unseen_room(state) / motion.of_capsules);
    for (const Contact& c : state.contacts)
        if (c.against == Against::capsule) share = std::min(share, share_beside(state, c));
    for (std::size_t h = 0; h < state.hold_from.size(); ++h) share = std::min(share, share_at_walls(state, h));
    return share / left;
}

// And should it not.
static double careful_share(const State& state, double left, double share) {
    for (const Row& row : state.rows)
        if (row.against == Against::capsule && !goes_along(state, row)) share = std::min(share, share_of_tool(state, row) / left);
    return share;
}

// Whether a step may be found twice: not where one solves as many contacts as a tick may.
static bool may_dare(const State& state) {
    const int enough = state.def.contacts_per_tick;
    return enough == 0 || static_cast<int>(state.pressed.size()) < enough;
}

// Whether the step leaves a tool farther in a link than any may be.
static bool is_deep(const State& state) {
    const std::span<const Vec3> step = state.rod->step_found();
    const auto then = [&](int node) { return Vec3(state.nodes[at(node)] + step[at(node)]); };
    return std::any_of(state.contacts.begin(), state.contacts.end(), [&](const Contact& c) {
        if (c.against != Against::capsule || c.gap - c.thickness > closing(state)) return false;
        const Capsule& tool = state.capsules[at(c.other)];
        const double least = c.thickness - deepest(state);
        return geometry::closest_points(then(c.link), then(c.link + 1), tool.a, tool.b).distance_squared < least * least;
    });
}

static void set_progress(State& state, double progress) {
    std::fill(state.progress.begin(), state.progress.end(), progress);
    place_capsules(state);
}

static double way_of_step(const State& state, double left, const Motion& motion) { return std::max(0.5 * state.def.radius, left * motion.most()); }

// Tools first, by this share of what is left of their motion, then what the thread answers to first order.
static void answer(State& state, double left, double tools, const Motion& motion, TickReport& report) {
    Rod& rod = *state.rod;
    const double way = way_of_step(state, left, motion);
    if (motion.of_capsules > 0) {
        set_progress(state, 1 - left * (1 - tools));
        state.moved += largest_capsule_move(state);
    }
    look_around(state, way);
    measure_gaps(state, way);
    aim(state);
    report.contacts = std::max(report.contacts, static_cast<int>(state.rows.size()));
    find_presses(state);
    state.targets.assign(state.input.holds.begin(), state.input.holds.end());
    for (Hold& hold : state.targets) {
        const Vec3& from = hold.slides ? hold.start : state.nodes[at(hold.node)];
        hold.target = from + (hold.slides ? 1 - left * (1 - tools) : tools) * (hold.target - from);
    }
    slide(state);
    rod.find_free_step(state.targets, state.pairs, state.rolling);
    report.sweeps += solve_presses(state);
    add_changes(state);
}

/// Of a tick.
struct Left {
    double motion = 1;    ///< Share that tools have still to make.
    bool is_taut = false;  ///< They wait: they pulled as hard as any may.
};

// Where the answer would pull a link harder than any may tools wait, and the thread answers without them: one that stopped with them
// could not even give way. What would then still be pulled too hard, as by the way it bends, does stop it.
static Left step(State& state, double left, const Motion& motion, TickReport& report) {
    Rod& rod = *state.rod;
    state.before = state.nodes;
    state.capsules_before = state.capsules;
    look_at_tools(state, way_of_step(state, left, motion));
    measure_tool_gaps(state);
    constexpr double by_tools = 0.99;  // of the most pull; the rest is for what the thread does by itself
    const double most = rod.def().most_pull();
    const double daring = share_of_tools(state, left, motion), careful = careful_share(state, left, daring);
    double tools = may_dare(state) ? daring : careful;
    answer(state, left, tools, motion, report);
    if (tools > careful && is_deep(state)) answer(state, left, tools = careful, motion, report);
    const double may_pull = rod.share_within(by_tools * most);
    const bool is_taut = may_pull < 1;
    if (is_taut) answer(state, left, tools *= may_pull, motion, report);
    const double share = rod.go_by(std::min(rod.share_within(most), share_within_bounds(state)), state.before, state.bound);
    std::copy(rod.nodes().begin(), rod.nodes().end(), state.nodes.begin());
    left *= 1 - tools * share;
    set_progress(state, 1 - left);
    return {left, is_taut};
}

void elastic_tick(State& state, const Motion& motion, TickReport& report) {
    constexpr int most_steps = 8;
    const int enough = state.def.contacts_per_tick;
    Rod& rod = *state.rod;
    rod.begin({.holds = state.input.holds, .loads = state.input.loads, .turn = {}, .tolerance = {}}, state.input.seconds);
    Left left;
    int pressed = 0;
    for (int i = 0; i < most_steps && (enough == 0 || pressed < enough) && left.motion > 0 && !(i > 0 && left.is_taut); ++i) {
        left = step(state, left.motion, motion, report);
        end_step(state, report);
        pressed += static_cast<int>(state.presses.size());
    }
    rod.end();
    for (int k = 0; k < state.links(); ++k) state.tension[at(k)] = rod.tension(k);
    aim(state);  // to where they are now
}

}  // namespace sim::thread
