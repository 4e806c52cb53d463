#include <cstring>

#include "sim/thread/state.hpp"

namespace sim::thread {

namespace {

Vec3 mix(const Vec3& a, const Vec3& b, double t) { return a + t * (b - a); }

bool is_finite(const TickInput& input) {
    for (const Hold& hold : input.holds)
        if (!hold.target.allFinite()) return false;
    for (const MovingCapsule& c : input.capsules)
        if (!(c.from.a.allFinite() && c.from.b.allFinite() && c.to.a.allFinite() && c.to.b.allFinite())) return false;
    return true;
}

void place_capsules(State& state, std::vector<Capsule>& capsules, double progress) {
    capsules.resize(state.input.capsules.size());
    for (std::size_t c = 0; c < capsules.size(); ++c) {
        const MovingCapsule& moving = state.input.capsules[c];
        capsules[c] = {mix(moving.from.a, moving.to.a, progress), mix(moving.from.b, moving.to.b, progress), moving.from.radius};
    }
}

void begin(State& state, const TickInput& input) {
    state.input = input;
    state.progress = 0;
    std::fill(state.inverse_mass.begin(), state.inverse_mass.end(), 1.0);
    state.hold_from.clear();
    for (const Hold& hold : input.holds) {
        state.inverse_mass[static_cast<std::size_t>(hold.node)] = 0;
        state.hold_from.push_back(state.nodes[static_cast<std::size_t>(hold.node)]);
    }
    place_capsules(state, state.capsules, 0);
}

// The longest way any held node, and any tool part near the thread, is asked to go in this tick [m].
struct Motion {
    double of_holds = 0, of_capsules = 0;
    double most() const { return std::max(of_holds, of_capsules); }
};

Motion motion_asked(const State& state) {
    Motion motion;
    for (std::size_t h = 0; h < state.hold_from.size(); ++h)
        motion.of_holds = std::max(motion.of_holds, (state.input.holds[h].target - state.hold_from[h]).norm());
    for (const MovingCapsule& c : state.input.capsules)
        motion.of_capsules = std::max({motion.of_capsules, (c.to.a - c.from.a).norm(), (c.to.b - c.from.b).norm()});
    return motion;
}

// No node leaves its bound, whatever stage moved it.
void clip(State& state) {
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const Vec3 moved = state.nodes[i] - state.before[i];
        const double distance2 = moved.squaredNorm(), bound = state.bound[i];
        if (distance2 > bound * bound) state.nodes[i] = state.before[i] + bound / std::sqrt(distance2) * moved;
    }
}

struct Violation {
    double stretch, overlap;
    /// 1 where the tolerance is just used up.
    double size() const { return std::max(stretch / stretch_tolerance, overlap / overlap_tolerance); }
};

Violation violation(const State& state) { return {worst_stretch(state), worst_overlap(state)}; }

// Contacts and lengths in turn until neither is violated. Lengths come last: they converge at once where they can.
void relax(State& state) {
    constexpr int most_passes = 24;  // a knot being tightened takes 5 to 15; what needs more is jammed
    for (int pass = 0; pass < most_passes; ++pass) {
        const double overlap = resolve_contacts(state);
        limit_bends(state);
        const double stretch = solve_lengths(state);
        clip(state);
        if (pass > 0 && overlap < 0.5 * overlap_tolerance && stretch < 0.5) break;
    }
    for (int pass = 0; pass < 3 && solve_lengths(state) > 0.1 * stretch_tolerance; ++pass) clip(state);
    clip(state);
}

struct Substep {
    bool accepted = false;
    double over_bound = 0;
    int pass_throughs = 0;
};

// Moves tools and held nodes on to `progress` and lets the thread follow. Undone unless the result is within tolerance
// or better than what was there: so a thread that cannot follow stays as it is and the tools wait.
Substep attempt(State& state, double progress) {
    const double was = violation(state).size();
    state.before = state.nodes;
    state.capsules_before = state.capsules;
    place_capsules(state, state.capsules, progress);
    follow_leader(state, progress);
    clip(state);
    relax(state);

    Substep result;
    const double is = violation(state).size();
    result.accepted = is <= 1 || is < was;
    if (!result.accepted) {
        state.nodes = state.before;
        state.capsules = state.capsules_before;
        return result;
    }
    double moved = 0;
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const double distance = (state.nodes[i] - state.before[i]).norm();
        moved = std::max(moved, distance);
        if (distance > 0) result.over_bound = std::max(result.over_bound, distance / state.bound[i]);
    }
    for (std::size_t c = 0; c < state.capsules.size(); ++c)
        moved = std::max({moved, (state.capsules[c].a - state.capsules_before[c].a).norm(),
                          (state.capsules[c].b - state.capsules_before[c].b).norm()});
    state.moved += moved;
    state.settled = moved == 0;
    result.pass_throughs = audit(state);
    return result;
}

// Share of the whole tick's motion that one substep may make: no held node farther than its own bound, no tool part near
// the thread farther than the thread's radius.
double admissible_share(const State& state, const Motion& motion) {
    double share = 1;
    double least_bound = state.reach;
    for (const double bound : state.bound) least_bound = std::min(least_bound, bound);
    // Followers move no farther than their leader while links keep their length; a third is left for what contacts add.
    constexpr double for_leading = 0.7;
    if (motion.of_holds > 0) share = std::min(share, for_leading * least_bound / motion.of_holds);
    bool near_tool = false;
    for (const int k : state.active) near_tool |= state.contacts[static_cast<std::size_t>(k)].against == Against::capsule;
    if (near_tool && motion.of_capsules > 0) share = std::min(share, state.def.radius / motion.of_capsules);
    return share;
}

}  // namespace

TickReport tick(State& state, const TickInput& input) {
    TickReport report;
    if (!is_finite(input)) {
        report.not_finite = true;
        report.fraction = 0;
        return report;
    }
    begin(state, input);
    const Motion motion = motion_asked(state);
    const double touching = 2 * state.def.radius;
    const auto look_around = [&] { detect(state, touching + 2 * std::max(touching, motion.most())); };
    if (motion.most() > 0 || !state.settled) {
        look_around();
        constexpr int most_substeps = 64, most_refusals = 2;  // what is left after them is lag, not a late tick
        int refusals = 0;
        do {
            if (2 * state.moved > state.reach - touching) look_around();
            measure_gaps(state);
            report.contacts = std::max(report.contacts, static_cast<int>(state.active.size()));
            const double share = admissible_share(state, motion) * state.trust;
            const double next = motion.most() > 0 ? std::min(1.0, state.progress + share) : 1.0;
            const Substep step = attempt(state, next);
            ++report.substeps;
            report.pass_throughs += step.pass_throughs;
            report.step_over_bound = std::max(report.step_over_bound, step.over_bound);
            if (step.accepted) {
                state.progress = next;
                state.trust = std::min(1.0, 2 * state.trust);
            } else {
                constexpr double least_trust = 1.0 / 64;
                state.trust = std::max(least_trust, state.trust / 4);
                state.settled = motion.most() == 0;  // nothing better can be found and nothing asks for more
                ++refusals;
            }
        } while (state.progress < 1 && motion.most() > 0 && report.substeps < most_substeps && refusals < most_refusals);
        report.fraction = motion.most() > 0 ? state.progress : 1;
    }
    estimate_tension(state);
    report.stretch_max = worst_stretch(state);
    for (const Contact& c : state.contacts)
        if (c.against == Against::thread) report.separation_min = std::min(report.separation_min, c.gap / c.thickness);
    return report;
}

}  // namespace sim::thread
