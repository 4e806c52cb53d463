#include "sim/thread/ftl/substep.hpp"

#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/thread/contact/tools.hpp"
#include "sim/thread/ftl/clip.hpp"
#include "sim/thread/ftl/wraps.hpp"

namespace sim::thread::ftl {

Stepper::Stepper(const State& state)
    : relaxation_(state), leader_(state.most_links()), slide_(state.most_links()), audit_(state.most_links()) {
    kept_.reserve(state.most_links() + 1);
}

// For the length of an attempt, nodes of strands that press on each other are held where they are.
void Stepper::keep_what_presses(State& state) {
    for (const Row& row : state.rows) {
        if (row.against != Against::thread || row.distance >= row.thickness) continue;
        for (const int node : {row.link, row.link + 1, row.other, row.other + 1}) {
            if (state.inverse_mass[at(node)] == 0) continue;
            state.inverse_mass[at(node)] = 0;
            kept_.push_back(node);
        }
    }
}

void Stepper::let_go_of_kept(State& state) {
    for (const int node : kept_) state.inverse_mass[at(node)] = 1;
    kept_.clear();
}

static void begin_pushes(State& state) {
    state.last.pulled = state.pulled;
    std::fill(state.pulled.begin(), state.pulled.end(), 0.0);
    for (Row& row : state.rows) {
        row.normal_push = 0;
        row.tangent_push.setZero();
    }
}

void Stepper::begin_with(State& state, double path, Method method) {
    begin_pushes(state);
    recall_wraps(state);
    if (method == Method::drift && state.last.path > 0) {
        constexpr double going_on = 0.95;  // less drags on what slides, more lets it slide on by itself: knots untie
        const double share = going_on * std::min(4.0, path / state.last.path);
        for (std::size_t i = 0; i < state.nodes.size(); ++i) state.nodes[i] += share * state.last.drift[i];
    }
    place_held(state);
    carry_taut_spans(state);
    if (method == Method::follow_the_leader) leader_.follow(state);
    lie_on_steel(state);
}

static void begin_slide(State& state) {
    begin_pushes(state);
    std::fill(state.carried.begin(), state.carried.end(), Vec3::Zero());
    state.on_steel.clear();
    for (Row& row : state.rows) row.in_wrap = row.pressed = false;
    place_held(state);
}

double Stepper::try_method(State& state, double path, Method method, Effort effort) {
    if (method == Method::slide) {
        begin_slide(state);
        return slide_.slide_along(state, leader_, relaxation_.bends(), relaxation_.work);
    }
    if (method == Method::go_on) {
        state.nodes = state.unfinished.nodes;
        place_held(state);
    } else {
        begin_with(state, path, method);
    }
    clip(state);
    return relaxation_.relax(state, effort);
}

static double largest_move(const State& state) {
    double moved = largest_capsule_move(state);
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
        moved = std::max(moved, (state.nodes[i] - state.before[i]).norm());
    return moved;
}

static double largest_move_over_bound(const State& state) {
    double worst = 0;
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const double moved = (state.nodes[i] - state.before[i]).norm();
        if (moved > 0) worst = std::max(worst, moved / state.bound[i]);
    }
    return worst;
}

Substep Stepper::attempt(State& state, double path, Method method, Effort effort) {
    double was = worst_stretch(state, state.nodes) / stretch_tolerance;
    for (const Row& row : state.rows) was = std::max(was, over_limit(state, row));
    state.before = state.nodes;
    state.capsules_before = state.capsules;
    place_capsules(state);
    Substep result;
    if (method == Method::keep_what_presses) keep_what_presses(state);
    result.accepted = try_method(state, path, method, effort) <= std::max(1.0, was);
    let_go_of_kept(state);
    if (!result.accepted) {
        state.unfinished.nodes = state.nodes;
        state.nodes = state.before;
        state.capsules = state.capsules_before;
        aim(state);  // rows are as near as they were
        return result;
    }
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const Vec3 moved = state.nodes[i] - state.before[i];
        state.last.drift[i] = moved - state.carried[i];
        state.last.following[i] = path > 0 ? moved.norm() / path : 1;
    }
    if (path > 0) note_whether_it_slides(state);
    remember_wraps(state);
    state.last.path = path;
    const double moved = largest_move(state);
    state.moved += moved;
    state.settled = moved == 0;
    result.over_bound = largest_move_over_bound(state);
    result.pass_throughs = audit_.count_pass_throughs(state);
    return result;
}

}  // namespace sim::thread::ftl
