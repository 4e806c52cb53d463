#include "sim/thread/ftl/mover.hpp"

#include <algorithm>
#include <cmath>

#include "sim/geometry/at.hpp"
#include "sim/thread/contact/gaps.hpp"
#include "sim/thread/contact/rows.hpp"

// A tick by Follow-The-Leader [Brown2004]: substeps, each so short that no node can pass through anything, each taken
// whole or not at all. Tools go on together, then what they could not do together one by one; where the thread cannot
// follow they wait, and what is left is lag. Chosen because it has no stiffness to resolve: its cost is passes over
// links and contacts, bounded per tick, and an inextensible thread is followed at any speed of the hands.
namespace sim::thread::ftl {

namespace {

constexpr int most_work = 54;  // of a tick, in passes: what is left then is lag

void forget_unfinished(State& state) {
    state.unfinished.step_control = -1;
    state.unfinished.tries = 0;
}

// What was refused before is tried the other way; what is drawn taut over walls, where a shorter step is likelier to
// help, each fourth time.
Method next_method(const State& state, const StepControl& step_control) {
    const bool second = step_control.refused_in_a_row % 2 != 0, fourth = step_control.refused_in_a_row % 4 == 3;
    if (!may_slide(state)) return second ? Method::follow_the_leader : Method::drift;
    return (state.slides ? !fourth : second) ? Method::slide : Method::drift;
}

// Nothing is asked for, and all is as good as passes make it.
bool is_at_rest(const State& state, const Motion& motion) {
    if (motion.most() > 0 || worst_stretch(state, state.nodes) > stretch_tolerance) return false;
    // A wall that has come into the thread leaves it so little room that no single step is worth one: what counts is
    // how deep it lies.
    const auto is_deep = [&](const Row& row) {
        return row.against == Against::surface && over_limit(state, row) > 0.5;
    };
    return std::all_of(state.rows.begin(), state.rows.end(),
                       [&](const Row& row) { return over_goal(state, row, row.distance) < 1 && !is_deep(row); });
}

Effort effort(const StepControl& step_control, Method method) {
    constexpr int passes = 8;
    if (method == Method::keep_what_presses) return {passes, 0};
    return {passes, creeps(step_control) ? 1 : 2};
}

template <class T>
void erase(std::vector<T>& values, std::size_t first, std::size_t past) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(first),
                 values.begin() + static_cast<std::ptrdiff_t>(past));
}

}  // namespace

Mover::Mover(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts)
    : state_(def, std::move(nodes), cuts),
      detection_(state_.most_links()),
      stepper_(state_),
      tension_(state_.most_links()) {}

void Mover::begin() {
    State& state = state_;
    if (state.step_controls.size() != state.progress.size() + 1) {
        state.step_controls.assign(state.progress.size() + 1, {});
        forget_unfinished(state);
    }
    for (StepControl& step_control : state.step_controls)
        step_control.refused.reserve(state.input.holds.size() + 2 * state.input.capsules.size());
    stepper_.work() = 0;
    wasted_ = 0;
    if (state.input.surface_moved > 0) {
        wake(state);
        state.settled = false;
    }
}

void Mover::tick(TickReport& report) {
    begin();
    follow_tools(report);
    tension_.find(state_);
}

// Share of its motion that the least advanced of these tools has made in this tick.
double Mover::progress_of(const Movers& movers) const {
    return *std::min_element(state_.progress.data() + movers.first, state_.progress.data() + movers.past);
}

void Mover::set_progress(const Movers& movers, double progress) {
    std::fill(state_.progress.data() + movers.first, state_.progress.data() + movers.past, progress);
}

// A step that is refused is dared shorter, unless one goes on with it in the next tick.
void Mover::learn_from_refusal(const Movers& movers, double share) {
    constexpr int most_tries = 12;  // [ticks] that a knot may hold up hands which it does not let pass in the end
    Unfinished& unfinished = state_.unfinished;
    StepControl& step_control = state_.step_controls[movers.step_control];
    step_control.refused = asked_.displacements;
    unfinished.share = share;
    // Begun afresh, because what is around has moved, it is still the same jam.
    if (creeps(step_control) && !state_.rows.empty() && ++unfinished.tries < most_tries) {
        unfinished.step_control = static_cast<int>(movers.step_control);
    } else {
        forget_unfinished(state_);
        shorten_steps(step_control);
    }
}

// Moves tools and held nodes on by a share of the tick's motion and lets the thread respond. While a jam waits only the
// slack around it does: that is easily found, and says nothing of the trust region.
bool Mover::substep(const Movers& movers, bool jammed, TickReport& report) {
    constexpr int work_of_looking = 6, easy_work = 12;
    State& state = state_;
    const Motion& motion = asked_.motion;
    int& work = stepper_.work();
    StepControl& step_control = state.step_controls[movers.step_control];
    const bool is_known = !detection_.look_around(state, motion.most()) &&
                          state.unfinished.step_control == static_cast<int>(movers.step_control);
    if (!is_known) {
        state.unfinished.step_control = -1;
        // Jammed, what hands ask for grows and grows; what a short step does not reach need not be looked at.
        measure_gaps(state, creeps(step_control) ? std::min(motion.most(), 0.5 * state.def.radius) : motion.most());
        state.on_steel.clear();
        work += work_of_looking;
    }
    report.contacts = std::max(report.contacts, static_cast<int>(state.rows.size()));
    if (is_at_rest(state, motion)) {
        forget_unfinished(state);  // what was asked for then is asked for no more
        return false;
    }
    // Steps alike, no short one last: each says how the thread goes on in the next.
    const auto step_share = [&] {
        const double left = 1 - progress_of(movers),
                     most = admissible_share(state, movers, motion) * (jammed ? 1 : step_control.trust_region);
        return motion.most() > 0 ? left / std::ceil(left / most) : 1;
    };
    const Method method = jammed     ? Method::keep_what_presses
                          : is_known ? Method::go_on
                                     : next_method(state, step_control);
    double share = is_known ? state.unfinished.share : step_share();
    if (method == Method::slide) share = std::min(share, share_of_slide(state, motion.most()));
    const int work_before = work;
    progress_before_ = state.progress;
    for (std::size_t g = movers.first; g < movers.past; ++g)
        state.progress[g] = std::min(1.0, state.progress[g] + share);
    const Substep step = stepper_.attempt(state, share * motion.most(), method, effort(step_control, method));
    if (step.accepted) {
        forget_unfinished(state);
        if (!jammed) lengthen_steps(step_control, !is_known && work - work_before <= easy_work);
        if (!state.settled) wake(state);
    } else {
        state.progress = progress_before_;
        wasted_ += work - work_before;
        if (!jammed) learn_from_refusal(movers, share);
    }
    ++report.substeps;
    report.pass_throughs += step.pass_throughs;
    report.step_over_bound = std::max(report.step_over_bound, step.over_bound);
    return step.accepted;
}

// Substep by substep until these tools are where they are asked to be, the thread is jammed, or the tick has cost what
// it may: what is left then is lag, not a late tick.
void Mover::move(const Movers& movers, int may_cost, TickReport& report) {
    constexpr int most_wasted = 10;  // a tick solves contacts and lengths together once in vain, not more
    asked_.collect(state_, movers);
    const double most_asked = asked_.motion.most();
    StepControl& step_control = state_.step_controls[movers.step_control];
    if (most_asked == 0 && state_.settled) {
        set_progress(movers, 1);
        return;
    }
    const bool jammed = waits(state_, step_control, asked_);
    if (jammed && step_control.stuck) return;
    while (progress_of(movers) < 1 && stepper_.work() < may_cost && wasted_ < most_wasted) {
        const bool accepted = substep(movers, jammed, report);
        if (jammed && !accepted) {
            step_control.stuck = true;
            return;
        }
        if (most_asked > 0 || accepted || state_.unfinished.step_control == static_cast<int>(movers.step_control))
            continue;
        state_.settled = true;  // nothing better can be found and nothing asks for more
        set_progress(movers, 1);
    }
}

// Tools and thread together, or one tool after the other.
void Mover::follow_tools(TickReport& report) {
    // What all together could not do each tool may still do alone: one that gives way must not wait for one that pulls.
    // But what is unfinished is finished first.
    const std::size_t groups = state_.progress.size();
    const auto movers_of = [&](int step_control) {
        const auto p = static_cast<std::size_t>(step_control);
        return step_control == 0 ? Movers{0, groups, 0} : Movers{p - 1, p, p};
    };
    if (const int step_control = state_.unfinished.step_control; step_control >= 0) {
        asked_.collect(state_, movers_of(step_control));
        if (!asked_.is_much_the_same(state_, state_.step_controls[static_cast<std::size_t>(step_control)].refused))
            forget_unfinished(state_);
    }
    const bool goes_well = groups == 1 || state_.step_controls[0].trust_region > 0.25;
    for (int step_control = 0; step_control <= (groups > 1 ? static_cast<int>(groups) : 0); ++step_control)
        if (state_.unfinished.step_control < 0 || state_.unfinished.step_control == step_control)
            move(movers_of(step_control), step_control > 0 || goes_well ? most_work : most_work / 2, report);
}

void Mover::find_surface_forces() {
    State& state = state_;
    state.surface_forces.clear();
    if (!state.input.surface) return;
    for (int i = 1; i < state.links(); ++i) {
        const double before = state.tension[at(i - 1)], after = state.tension[at(i)];
        if (before == 0 && after == 0) continue;
        const Vec3& node = state.nodes[at(i)];
        const auto towards = [&](int other) { return Vec3((state.nodes[at(other)] - node).normalized()); };
        const Row* nearest = nullptr;
        for (const Row& row : state.rows)
            if (row.against == Against::surface && (row.link == i || row.link == i - 1) &&
                (!nearest || row.distance < nearest->distance))
                nearest = &row;
        if (nearest && nearest->distance < 1.5 * nearest->thickness)
            state.surface_forces.push_back(
                {nearest->other, nearest->fixed, before * towards(i - 1) + after * towards(i + 1), i});
    }
}

void Mover::split(std::size_t link, double share) {
    const auto insert_between = [&](auto& values) {
        const typename std::decay_t<decltype(values)>::value_type between =
            (1 - share) * values[link] + share * values[link + 1];
        values.insert(values.begin() + static_cast<std::ptrdiff_t>(link) + 1, between);
    };
    insert_between(state_.last.drift);
    insert_between(state_.last.following);
}

void Mover::join_at(std::size_t node) {
    erase(state_.last.drift, node, node + 1);
    erase(state_.last.following, node, node + 1);
}

void Mover::leave_out(std::size_t first, std::size_t second) {
    erase(state_.last.drift, first + 1, second);
    erase(state_.last.following, first + 1, second);
}

void Mover::renew() {
    state_.size_for_links();
    stepper_.resize(state_);
    state_.settled = false;
}

void Mover::forget_jams() {
    forget_unfinished(state_);
    for (StepControl& step_control : state_.step_controls) step_control = {.refused = std::move(step_control.refused)};
}

}  // namespace sim::thread::ftl
