#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/thread/elastic/advance.hpp"
#include "sim/thread/elastic/press.hpp"

// A tick of an elastic thread: one implicit step in which the rod and all that it touches are linear, a step of
// Newton's method; what that leaves is taken up by the next tick. Where a node has used up what it may move before we
// look around again, the rest of the tick is another such step.
namespace sim::thread {

// How much nearer the step may bring what a contact is of: no point of a link goes farther than one of its ends.
static double nearing(std::span<const Vec3> step, const Contact& c) {
    const Vec3 &a = step[at(c.link)], &b = step[at(c.link + 1)];
    if (c.against != Against::thread) return std::max(a.norm(), b.norm());
    const Vec3 &from = step[at(c.other)], &to = step[at(c.other + 1)];
    return std::max({(a - from).norm(), (a - to).norm(), (b - from).norm(), (b - to).norm()});
}

// The largest share of the step that leaves every node within its bound, no contact's points farther along each other
// than links see straight, and what was too far to push, or for a row, just touching.
static double share_within_bounds(const State& state) {
    constexpr double for_lengths = 0.9, for_turning = 0.3;
    const double most = for_turning * 2 * state.def.radius;
    const std::span<const Vec3> step = state.rod->step_found();
    double share = 1;
    const auto limit = [&](double size, double to) {
        if (size > to) share = std::min(share, to / size);
    };
    double largest = 0;
    for (std::size_t i = 0; i < step.size(); ++i) {
        const double size = step[i].norm();
        largest = std::max(largest, size);
        limit(size, for_lengths * state.bound[i]);
    }
    for (const Contact& c : state.contacts)
        if (const double room = c.gap - c.thickness; room >= closing(state) && 2 * largest > room)
            limit(nearing(step, c), room);
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
        row.began = press.began;
    }
}

// What the pushes have become since the rod's step was found.
static void add_changes(State& state) {
    state.forces.assign(state.nodes.size(), Vec3::Zero());
    for (const Press& press : state.presses)
        for (int k = 0; k < press.pair.nodes; ++k)
            state.forces[at(press.pair.node[at(k)])] += press.pair.weight[at(k)] * (press.push - press.pair.force);
    if (!state.presses.empty()) state.rod->add_forces(state.forces);
}

static void set_progress(State& state, double progress) {
    std::fill(state.progress.begin(), state.progress.end(), progress);
    place_capsules(state);
}

static double way_of_step(const State& state, double left, const Motion& motion) {
    return std::max(0.5 * state.def.radius, left * motion.most());
}

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
        if (state.asleep[at(hold.node)]) hold.slides = false, hold.target = state.nodes[at(hold.node)];
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
    double motion = 1;     ///< Share that tools have still to make.
    bool is_taut = false;  ///< They wait: they pulled as hard as any may.
};

// Where the answer would pull a link harder than any may tools wait, and the thread answers without them: one that
// stopped with them could not even give way. What would then still be pulled too hard, as by the way it bends, does
// stop it.
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
    const double share =
        rod.go_by(std::min(rod.share_within(most), share_within_bounds(state)), state.before, state.bound);
    std::copy(rod.nodes().begin(), rod.nodes().end(), state.nodes.begin());
    left *= 1 - tools * share;
    set_progress(state, 1 - left);
    return {left, is_taut};
}

void elastic_tick(State& state, const Motion& motion, TickReport& report) {
    constexpr int most_steps = 8;
    const int enough = state.def.contacts_per_tick;
    Rod& rod = *state.rod;
    wake_what_is_moved(state);
    hold_what_sleeps(state);
    for (Row& row : state.pressed) row.began = row.push();
    rod.begin(
        {.holds = state.input.holds, .loads = state.input.loads, .turn = {}, .tolerance = {}, .asleep = state.asleep},
        state.input.seconds);
    Left left;
    int pressed = 0;
    for (int i = 0; i < most_steps && (enough == 0 || pressed < enough) && left.motion > 0 && !(i > 0 && left.is_taut);
         ++i) {
        left = step(state, left.motion, motion, report);
        end_step(state, report);
        pressed += static_cast<int>(state.presses.size());
    }
    rod.end();
    for (int k = 0; k < state.links(); ++k) state.tension[at(k)] = rod.tension(k);
    aim(state);  // to where they are now
    watch_over_pieces(state);
}

}  // namespace sim::thread
