#include "sim/thread/ftl/step_control.hpp"

#include <algorithm>

// The step bound is a guarantee, found anew for every substep; within it a trust region is learnt:
// quartered when a substep is refused, doubled when one was easy.
namespace sim::thread::ftl {

void Asked::collect(const State& state, const Movers& movers) {
    displacements.clear();
    for (std::size_t h = 0; h < state.hold_from.size(); ++h)
        if (movers.include(state.input.hold_owners[h]))
            displacements.push_back(state.input.holds[h].target - state.hold_from[h]);
    const std::size_t of_holds = displacements.size();
    for (const MovingCapsule& c : state.input.capsules)
        if (movers.include(c.owner)) displacements.insert(displacements.end(), {c.to.a - c.from.a, c.to.b - c.from.b});
    motion = {};
    for (std::size_t i = 0; i < displacements.size(); ++i) {
        double& longest = i < of_holds ? motion.of_holds : motion.of_capsules;
        longest = std::max(longest, displacements[i].norm());
    }
}

// What stands still but for rounding points anywhere.
bool Asked::is_much_the_same(const State& state, const std::vector<Vec3>& refused) const {
    constexpr double turn = 0.25;  // [rad]
    const double still = 1e-3 * state.def.radius;
    const auto direction = [&](const Vec3& displacement) -> Vec3 {
        return displacement.norm() > still ? displacement.stableNormalized() : Vec3::Zero();
    };
    return std::equal(
        displacements.begin(), displacements.end(), refused.begin(), refused.end(),
        [&](const Vec3& a, const Vec3& b) { return (direction(a) - direction(b)).squaredNorm() <= turn * turn; });
}

// A node is expected to go as far as in the last substep, for slack stays slack; no farther than its leader while links
// keep their length, and by a quarter of that at least: it may come to be pulled.
double admissible_share(const State& state, const Movers& movers, const Motion& motion) {
    constexpr double for_following = 0.7;  // of the bound; the rest is for what contacts add
    constexpr double round_steel =
        0.25;  // of a link: who leaves or comes to lie on steel in this substep is not known yet
    // Tools that only push may be faster than what is held; the last substep's path was of the fastest.
    const auto expected = [&](std::size_t node) {
        return std::clamp(state.last.following[node] * motion.most(), 0.25 * motion.of_holds, motion.of_holds);
    };
    double share = 1;
    for (std::size_t i = 0; i < state.bound.size() && motion.of_holds > 0; ++i)
        share = std::min(share, for_following * state.bound[i] / expected(i));
    for (std::size_t k = 0; k < state.last.wraps.size() && motion.of_holds > 0; ++k)
        if (state.last.wraps[k].presses) share = std::min(share, round_steel * state.rest_length[k] / expected(k));
    if (const double unseen = unseen_room(state); motion.of_capsules * share > unseen)
        share = unseen / motion.of_capsules;
    for (const Contact& c : state.contacts)
        if (c.against == Against::capsule &&
            movers.include(state.input.capsules[static_cast<std::size_t>(c.other)].owner))
            share = std::min(share, share_beside(state, c));
    return share;
}

bool waits(const State& state, StepControl& step_control, const Asked& asked) {
    if (step_control.waits == 0 || asked.motion.most() == 0) return false;
    if (!asked.is_much_the_same(state, step_control.refused)) {
        step_control.waits = step_control.jams_in_a_row = 0;
        step_control.stuck = false;
        return false;
    }
    --step_control.waits;
    return true;
}

void shorten_steps(StepControl& step_control) {
    constexpr double least_region = 1.0 / 64;  // the share of its motion that a jammed thread is still asked to make
    constexpr int longest = 10;
    ++step_control.refused_in_a_row;
    if (step_control.trust_region <= least_region)
        step_control.waits = (1 << std::min(++step_control.jams_in_a_row, longest)) - 1;
    step_control.trust_region = std::max(least_region, step_control.trust_region / 4);
}

void lengthen_steps(StepControl& step_control, bool was_easy) {
    step_control.refused_in_a_row = step_control.jams_in_a_row = 0;
    step_control.trust_region = std::min(1.0, (was_easy ? 2 : 1.25) * step_control.trust_region);
}

void wake(State& state) {
    constexpr int longest = 31;  // [ticks]
    for (StepControl& step_control : state.step_controls) {
        step_control.waits = std::min(step_control.waits, longest);
        step_control.stuck = false;
    }
}

}  // namespace sim::thread::ftl
