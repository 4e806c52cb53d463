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

double largest_capsule_move(const State& state) {
    double moved = 0;
    for (std::size_t c = 0; c < state.capsules.size(); ++c)
        moved = std::max({moved, (state.capsules[c].a - state.capsules_before[c].a).norm(),
                          (state.capsules[c].b - state.capsules_before[c].b).norm()});
    return moved;
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
    // Tools go on from where they stopped; should one have leapt, what was known of its surroundings is out of date.
    state.capsules_before = state.capsules;
    place_capsules(state, state.capsules, 0);
    if (state.capsules.size() == state.capsules_before.size()) state.moved += largest_capsule_move(state);
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

constexpr double least_trust = 1.0 / 64;  // the share of its motion that a jammed thread is still asked to make

struct Substep {
    bool accepted = false;
    double over_bound = 0;
    int pass_throughs = 0;
};

// How the thread answers when held nodes move. Least motion first: all nodes together move as little as the lengths
// allow, so slack is taken up before anything is dragged (plain Follow-The-Leader drags the far end of a slack thread as
// if it were taut). A taut thread that must slide round things is found quickly only by letting it follow its leader.
enum class Answer { drift, follow_the_leader };

double try_answer(State& state, double progress, double way, Answer answer) {
    std::fill(state.pulled.begin(), state.pulled.end(), 0.0);
    for (Row& row : state.rows) {
        row.normal_push = 0;
        row.tangent_push.setZero();
    }
    if (answer == Answer::drift && state.drift_way > 0) {
        const double share = 0.9 * std::min(2.0, way / state.drift_way);
        for (std::size_t i = 0; i < state.nodes.size(); ++i) state.nodes[i] += share * state.drift[i];
    }
    place_held(state, progress);
    if (answer == Answer::follow_the_leader) follow_leader(state);
    clip(state);
    return relax(state);
}

double largest_move(const State& state) {
    double moved = largest_capsule_move(state);
    for (std::size_t i = 0; i < state.nodes.size(); ++i) moved = std::max(moved, (state.nodes[i] - state.before[i]).norm());
    return moved;
}

double largest_move_over_bound(const State& state) {
    double worst = 0;
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const double moved = (state.nodes[i] - state.before[i]).norm();
        if (moved > 0) worst = std::max(worst, moved / state.bound[i]);
    }
    return worst;
}

// Moves tools and held nodes on to `progress` and lets the thread answer. Undone unless the result is within tolerance
// or no worse than what was there: so a thread that cannot follow stays as it is and the tools wait.
Substep attempt(State& state, double progress, double way) {
    double was = worst_stretch(state, state.nodes) / stretch_tolerance;
    for (const Row& row : state.rows) was = std::max(was, over_limit(row.against, row.thickness, row.distance));
    state.before = state.nodes;
    state.capsules_before = state.capsules;
    place_capsules(state, state.capsules, progress);
    Substep result;
    for (const Answer answer : {Answer::drift, Answer::follow_the_leader}) {
        // A thread that is jammed takes them in turn, tick by tick: what did not help a moment ago hardly helps now.
        if (state.trust <= least_trust && state.refused % 2 != static_cast<int>(answer)) continue;
        const double is = try_answer(state, progress, way, answer);
        result.accepted = is <= std::max(1.0, was);
        if (result.accepted) break;
        state.nodes = state.before;
    }
    if (!result.accepted) {
        state.capsules = state.capsules_before;
        aim(state);  // rows are as near as they were
        return result;
    }
    for (std::size_t i = 0; i < state.nodes.size(); ++i) state.drift[i] = state.nodes[i] - state.before[i];
    state.drift_way = way;
    const double moved = largest_move(state);
    state.moved += moved;
    state.settled = moved == 0;
    result.over_bound = largest_move_over_bound(state);
    result.pass_throughs = audit(state);
    return result;
}

// Share of the whole tick's motion that one substep may make: no held node farther than its own bound, no tool part into
// the thread by more than the thread's radius.
double admissible_share(const State& state, const Motion& motion) {
    double share = 1;
    double least_bound = state.reach;
    for (const double bound : state.bound) least_bound = std::min(least_bound, bound);
    // Followers move no farther than their leader while links keep their length; a third is left for what contacts add.
    constexpr double for_leading = 0.7;
    if (motion.of_holds > 0) share = std::min(share, for_leading * least_bound / motion.of_holds);
    // A tool part that was out of reach may come as near as its reach, no nearer, before we look again.
    const double unseen = std::max(state.def.radius, state.reach - 2 * state.moved - state.def.radius);
    if (motion.of_capsules * share > unseen) share = unseen / motion.of_capsules;
    for (const Contact& c : state.contacts) {
        if (c.against != Against::capsule) continue;
        const MovingCapsule& tool = state.input.capsules[static_cast<std::size_t>(c.other)];
        const double way = mix(tool.to.a - tool.from.a, tool.to.b - tool.from.b, c.place).norm();
        const double room = std::max(state.def.radius, c.gap - c.thickness);
        if (way * share > room) share = room / way;
    }
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
    if (motion.most() > 0 || !state.settled) {
        constexpr int most_substeps = 64, most_refusals = 1;  // what is left after them is lag, not a late tick
        int refusals = 0;
        do {
            look_around(state, motion.most());
            measure_gaps(state);
            report.contacts = std::max(report.contacts, static_cast<int>(state.rows.size()));
            const double share = admissible_share(state, motion) * state.trust;
            const double next = motion.most() > 0 ? std::min(1.0, state.progress + share) : 1.0;
            const Substep step = attempt(state, next, (next - state.progress) * motion.most());
            ++report.substeps;
            report.pass_throughs += step.pass_throughs;
            report.step_over_bound = std::max(report.step_over_bound, step.over_bound);
            if (step.accepted) {
                state.progress = next;
                state.trust = std::min(1.0, 2 * state.trust);
            } else {
                ++state.refused;
                state.trust = std::max(least_trust, state.trust / 4);
                state.settled = motion.most() == 0;  // nothing better can be found and nothing asks for more
                ++refusals;
            }
        } while (state.progress < 1 && motion.most() > 0 && report.substeps < most_substeps && refusals < most_refusals);
        report.fraction = motion.most() > 0 ? state.progress : 1;
    }
    estimate_tension(state);
    report.stretch_max = worst_stretch(state, state.nodes);
    for (const Row& row : state.rows)
        if (row.against == Against::thread) report.separation_min = std::min(report.separation_min, row.distance / row.thickness);
    return report;
}

}  // namespace sim::thread
