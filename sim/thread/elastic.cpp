#include <algorithm>

#include "sim/thread/state.hpp"

// A tick of an elastic thread: one implicit step in which the rod and all that it touches are linear, a step of Newton's method; what
// that leaves is taken up by the next tick. Where a node has used up what it may move before we look around again, the rest of the
// tick is another such step.
namespace sim::thread {

static std::size_t at(int i) { return static_cast<std::size_t>(i); }

static double longest_asked(const State& state) {
    double asked = 0;
    for (std::size_t h = 0; h < state.input.holds.size(); ++h) asked = std::max(asked, (state.input.holds[h].target - state.hold_from[h]).norm());
    for (const MovingCapsule& c : state.input.capsules) asked = std::max({asked, (c.to.a - c.from.a).norm(), (c.to.b - c.from.b).norm()});
    return asked;
}

static void look(State& state, double way) {
    look_around(state, way);
    measure_gaps(state, way);
    aim(state);
}

// The largest share of the step that leaves every node within its bound, and no contact's points farther along each other than links see
// straight.
static double share_within_bounds(const State& state) {
    constexpr double for_lengths = 0.9, for_turning = 0.3;
    const double most = for_turning * 2 * state.def.radius;
    const std::span<const Vec3> step = state.rod->step_found();
    double share = 1;
    const auto limit = [&](const Vec3& way, double to) { if (const double size = way.norm(); size * share > to) share = to / size; };
    for (std::size_t i = 0; i < step.size(); ++i) limit(step[i], for_lengths * state.bound[i]);
    for (std::size_t c = 0; c < state.presses.size(); ++c) {
        const Press& press = state.presses[c];
        if (press.push.squaredNorm() > 0 && press.row->against == Against::thread)
            limit(Eigen::Map<const Vec3>(state.apart.data() + 3 * c) - apart_of(state, *press.row), most);
    }
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

// What share of their motion that is left tools may make before we look again: none goes farther than the thread beside it leaves room
// for, or by the thread's radius where it touches.
static double share_of_tools(const State& state, double left) {
    double share = 1;
    const auto limit = [&](double way, double room) { if (way * left * share > room) share = room / (way * left); };
    for (const MovingCapsule& c : state.input.capsules)
        limit(std::max((c.to.a - c.from.a).norm(), (c.to.b - c.from.b).norm()), std::max(state.def.radius, state.reach - 2 * state.moved - state.def.radius));
    for (const Contact& c : state.contacts) {
        if (c.against != Against::capsule) continue;
        const MovingCapsule& tool = state.input.capsules[at(c.other)];
        limit((tool.to.a - tool.from.a + c.place * (tool.to.b - tool.to.a - tool.from.b + tool.from.a)).norm(), std::max(state.def.radius, c.gap - c.thickness));
    }
    return share;
}

static void set_progress(State& state, double progress) {
    std::fill(state.progress.begin(), state.progress.end(), progress);
    place_capsules(state);
}

// Tools first, as far as they may go, then the thread, and what it holds with it. Returns what is left of the tick's motion.
static double step(State& state, double left, double asked, TickReport& report) {
    Rod& rod = *state.rod;
    const double way = std::max(0.5 * state.def.radius, left * asked);
    state.before = state.nodes;
    state.capsules_before = state.capsules;
    look(state, way);
    const double tools = share_of_tools(state, left);
    if (!state.capsules.empty()) {
        set_progress(state, 1 - left * (1 - tools));
        state.moved += largest_capsule_move(state);
        look(state, way);
    }
    report.contacts = std::max(report.contacts, static_cast<int>(state.rows.size()));
    find_presses(state);
    state.targets.assign(state.input.holds.begin(), state.input.holds.end());
    for (Hold& hold : state.targets) hold.target = state.nodes[at(hold.node)] + tools * (hold.target - state.nodes[at(hold.node)]);
    rod.find_free_step(state.targets, state.pairs, state.touching);
    report.iterations += solve_presses(state);
    add_changes(state);
    const double share = rod.go_by(share_within_bounds(state), state.before, state.bound);
    std::copy(rod.nodes().begin(), rod.nodes().end(), state.nodes.begin());
    left *= 1 - tools * share;
    set_progress(state, 1 - left);
    return left;
}

TickReport elastic_tick(State& state, const TickInput& input) {
    TickReport report;
    constexpr int most_steps = 8;
    const double asked = longest_asked(state);
    state.rod->begin({.holds = input.holds, .loads = input.loads, .turn = {}, .tolerance = {}}, input.seconds);
    double left = 1;
    for (int i = 0; i < most_steps && left > 0 && !(i > 0 && state.rod->is_taut()); ++i) {
        left = step(state, left, asked, report);
        end_step(state, report);
    }
    state.rod->end();
    report.fraction = 1 - left;
    for (int k = 0; k < state.links(); ++k) state.tension[at(k)] = state.rod->tension(k);
    report.stretch_max = worst_stretch(state, state.nodes);
    aim(state);
    for (const Row& row : state.rows)
        if (row.against == Against::thread) report.separation_min = std::min(report.separation_min, row.distance / (2 * state.def.radius));
    return report;
}

}  // namespace sim::thread
