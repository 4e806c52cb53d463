#include <algorithm>
#include <cmath>

#include "sim/thread/stages.hpp"

namespace sim::thread {

namespace {

bool is_finite(const TickInput& input) {
    for (const Hold& hold : input.holds)
        if (!hold.target.allFinite()) return false;
    for (const MovingCapsule& c : input.capsules)
        if (!(c.from.a.allFinite() && c.from.b.allFinite() && c.to.a.allFinite() && c.to.b.allFinite())) return false;
    return std::all_of(input.loads.begin(), input.loads.end(), [](const Vec3& load) { return load.allFinite(); });
}

// Tools are numbered from 0; what nobody holds is -1.
std::size_t group_of(int owner) {
    return static_cast<std::size_t>(owner + 1);
}

std::size_t groups_of(const TickInput& input) {
    std::size_t groups = 1;
    for (const int owner : input.hold_owners) groups = std::max(groups, group_of(owner) + 1);
    for (const MovingCapsule& c : input.capsules) groups = std::max(groups, group_of(c.owner) + 1);
    return groups;
}

void forget_unfinished(State& state) {
    state.unfinished.pace = -1;
    state.unfinished.tries = 0;
}

void begin(State& state, const TickInput& input) {
    state.input = input;
    state.progress.assign(groups_of(input), 0);
    if (state.paces.size() != state.progress.size() + 1) {
        state.paces.assign(state.progress.size() + 1, {});
        forget_unfinished(state);
    }
    for (Pace& pace : state.paces) pace.refused.reserve(input.holds.size() + 2 * input.capsules.size());
    state.work = 0;
    state.wasted = 0;
    std::fill(state.inverse_mass.begin(), state.inverse_mass.end(), 1.0);
    state.hold_from.clear();
    for (const Hold& hold : input.holds) {
        state.inverse_mass[static_cast<std::size_t>(hold.node)] = 0;
        state.hold_from.push_back(state.nodes[static_cast<std::size_t>(hold.node)]);
    }
    // Tools go on from where they stopped; should one have leapt, what was known of its surroundings is out of date.
    state.capsules_before = state.capsules;
    place_capsules(state);
    if (state.capsules.size() == state.capsules_before.size()) state.moved += largest_capsule_move(state);
    state.moved += input.surface_moved;
}

// Which tools move: one group, or all.
struct Movers {
    std::size_t first, last;  ///< Groups first to last - 1.
    std::size_t pace;         ///< Of State::paces.
    bool include(int owner) const { return group_of(owner) >= first && group_of(owner) < last; }
};

// Into `asked`: the ways that these tools would have what they hold, then their own ends, go in this tick.
void collect_asked(State& state, const Movers& movers) {
    state.asked.clear();
    for (std::size_t h = 0; h < state.hold_from.size(); ++h)
        if (movers.include(state.input.hold_owners[h]))
            state.asked.push_back(state.input.holds[h].target - state.hold_from[h]);
    state.asked_of_holds = state.asked.size();
    for (const MovingCapsule& c : state.input.capsules)
        if (movers.include(c.owner)) state.asked.insert(state.asked.end(), {c.to.a - c.from.a, c.to.b - c.from.b});
}

Motion longest_asked(const State& state) {
    Motion motion;
    for (std::size_t i = 0; i < state.asked.size(); ++i) {
        double& longest = i < state.asked_of_holds ? motion.of_holds : motion.of_capsules;
        longest = std::max(longest, state.asked[i].norm());
    }
    return motion;
}

constexpr double least_trust = 1.0 / 64;  // the share of its motion that a jammed thread is still asked to make

// Share of the whole tick's motion that one substep may make: no node farther than its own bound, no tool part into the
// thread by more than the thread's radius. A node is expected to go as far as in the last substep, for slack stays
// slack; no farther than its leader while links keep their length, and by a quarter of that at least: it may come to be
// pulled.
double admissible_share(const State& state, const Movers& movers, const Motion& motion) {
    constexpr double for_following = 0.7;  // of the bound; the rest is for what contacts add
    constexpr double round_steel =
        0.25;  // of a link: who leaves or comes to lie on steel in this substep is not known yet
    // Tools that only push may be faster than what is held; the last substep's way was of the fastest.
    const auto expected = [&](std::size_t node) {
        return std::clamp(state.following[node] * motion.most(), 0.25 * motion.of_holds, motion.of_holds);
    };
    double share = 1;
    for (std::size_t i = 0; i < state.bound.size() && motion.of_holds > 0; ++i)
        share = std::min(share, for_following * state.bound[i] / expected(i));
    for (std::size_t k = 0; k < state.wraps.size() && motion.of_holds > 0; ++k)
        if (state.wraps[k].presses) share = std::min(share, round_steel * state.rest[k] / expected(k));
    if (const double unseen = unseen_room(state); motion.of_capsules * share > unseen)
        share = unseen / motion.of_capsules;
    for (const Contact& c : state.contacts)
        if (c.against == Against::capsule &&
            movers.include(state.input.capsules[static_cast<std::size_t>(c.other)].owner))
            share = std::min(share, share_beside(state, c));
    return share;
}

// A hand that trembles or pulls harder asks for the same, one that turns or stops does not. What stands still but for
// rounding points anywhere.
bool is_much_the_same(const State& state, const std::vector<Vec3>& refused) {
    constexpr double turn = 0.25;  // [rad]
    const double still = 1e-3 * state.def.radius;
    const auto direction = [&](const Vec3& way) -> Vec3 {
        return way.norm() > still ? way.stableNormalized() : Vec3::Zero();
    };
    return std::equal(
        state.asked.begin(), state.asked.end(), refused.begin(), refused.end(),
        [&](const Vec3& a, const Vec3& b) { return (direction(a) - direction(b)).squaredNorm() <= turn * turn; });
}

bool waits(const State& state, Pace& pace, const Motion& motion) {
    if (pace.waits == 0 || motion.most() == 0) return false;
    if (!is_much_the_same(state, pace.refused)) {
        pace.waits = pace.jams_in_a_row = 0;
        pace.stuck = false;
        return false;
    }
    --pace.waits;
    return true;
}

// What is jammed is tried again after 1, 3, 7 ... ticks, a second at last: nothing has changed meanwhile.
void trust_less(Pace& pace) {
    constexpr int longest = 10;
    ++pace.refused_in_a_row;
    if (pace.trust <= least_trust) pace.waits = (1 << std::min(++pace.jams_in_a_row, longest)) - 1;
    pace.trust = std::max(least_trust, pace.trust / 4);
}

// A hard step costs the same however short it is, so it too may become longer; slower, for a refused one quarters it
// again.
void trust_more(Pace& pace, bool was_easy) {
    pace.refused_in_a_row = pace.jams_in_a_row = 0;
    pace.trust = std::min(1.0, (was_easy ? 2 : 1.25) * pace.trust);
}

// The thread has moved: what it refused a while ago it may grant now.
void wake(State& state) {
    constexpr int longest = 31;  // [ticks]
    for (Pace& pace : state.paces) {
        pace.waits = std::min(pace.waits, longest);
        pace.stuck = false;
    }
}

// What was refused before is tried the other way; what is drawn taut over walls, where a shorter step is likelier to
// help, each fourth time.
Answer next_answer(const State& state, const Pace& pace) {
    const bool second = pace.refused_in_a_row % 2 != 0, fourth = pace.refused_in_a_row % 4 == 3;
    if (!may_slide(state)) return second ? Answer::follow_the_leader : Answer::drift;
    return (state.slides ? !fourth : second) ? Answer::slide : Answer::drift;
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

// Steps so short are worked at for several ticks.
bool creeps(const Pace& pace) {
    return pace.trust < 0.125;
}

Effort effort(const Pace& pace, Answer answer) {
    constexpr int passes = 8;
    if (answer == Answer::keep_what_presses) return {passes, 0};
    return {passes, creeps(pace) ? 1 : 2};
}

// A step that is refused is dared shorter, unless one goes on with it in the next tick.
void learn_from_refusal(State& state, const Movers& movers, double share) {
    constexpr int most_tries = 12;  // [ticks] that a knot may hold up hands which it does not let pass in the end
    Unfinished& unfinished = state.unfinished;
    Pace& pace = state.paces[movers.pace];
    pace.refused = state.asked;
    unfinished.share = share;
    // Begun afresh, because what is around has moved, it is still the same jam.
    if (creeps(pace) && !state.rows.empty() && ++unfinished.tries < most_tries) {
        unfinished.pace = static_cast<int>(movers.pace);
    } else {
        forget_unfinished(state);
        trust_less(pace);
    }
}

// Share of its motion that the least advanced of these tools has made in this tick.
double progress_of(const State& state, const Movers& movers) {
    return *std::min_element(state.progress.data() + movers.first, state.progress.data() + movers.last);
}

// Moves tools and held nodes on by a share of the tick's motion and lets the thread answer. While a jam waits only the
// slack around it does: that is easily found, and says nothing of how far to trust.
bool substep(State& state, const Movers& movers, const Motion& motion, bool jammed, TickReport& report) {
    constexpr int work_of_looking = 6, easy_work = 12;
    Pace& pace = state.paces[movers.pace];
    const bool is_known = !look_around(state, motion.most()) && state.unfinished.pace == static_cast<int>(movers.pace);
    if (!is_known) {
        state.unfinished.pace = -1;
        // Jammed, what hands ask for grows and grows; what a short step does not reach need not be looked at.
        measure_gaps(state, creeps(pace) ? std::min(motion.most(), 0.5 * state.def.radius) : motion.most());
        state.work += work_of_looking;
    }
    report.contacts = std::max(report.contacts, static_cast<int>(state.rows.size()));
    if (is_at_rest(state, motion)) {
        forget_unfinished(state);  // what was asked for then is asked for no more
        return false;
    }
    // Steps alike, no short one last: each says how the thread goes on in the next.
    const auto step_share = [&] {
        const double left = 1 - progress_of(state, movers),
                     most = admissible_share(state, movers, motion) * (jammed ? 1 : pace.trust);
        return motion.most() > 0 ? left / std::ceil(left / most) : 1;
    };
    const Answer answer = jammed ? Answer::keep_what_presses : is_known ? Answer::go_on : next_answer(state, pace);
    double share = is_known ? state.unfinished.share : step_share();
    if (answer == Answer::slide) share = std::min(share, share_of_slide(state, motion.most()));
    const int work_before = state.work;
    state.progress_before = state.progress;
    for (std::size_t g = movers.first; g < movers.last; ++g)
        state.progress[g] = std::min(1.0, state.progress[g] + share);
    const Substep step = attempt(state, share * motion.most(), answer, effort(pace, answer));
    if (step.accepted) {
        forget_unfinished(state);
        if (!jammed) trust_more(pace, !is_known && state.work - work_before <= easy_work);
        if (!state.settled) wake(state);
    } else {
        state.progress = state.progress_before;
        state.wasted += state.work - work_before;
        if (!jammed) learn_from_refusal(state, movers, share);
    }
    ++report.substeps;
    report.pass_throughs += step.pass_throughs;
    report.step_over_bound = std::max(report.step_over_bound, step.over_bound);
    return step.accepted;
}

// Substep by substep until these tools are where they are asked to be, the thread is jammed, or the tick has cost what
// it may: what is left then is lag, not a late tick.
void move(State& state, const Movers& movers, int may_cost, TickReport& report) {
    constexpr int most_wasted = 10;  // a tick solves contacts and lengths together once in vain, not more
    collect_asked(state, movers);
    const Motion motion = longest_asked(state);
    Pace& pace = state.paces[movers.pace];
    if (motion.most() == 0 && state.settled) {
        std::fill(state.progress.data() + movers.first, state.progress.data() + movers.last, 1.0);
        return;
    }
    const bool jammed = waits(state, pace, motion);
    if (jammed && pace.stuck) return;
    while (progress_of(state, movers) < 1 && state.work < may_cost && state.wasted < most_wasted) {
        const bool accepted = substep(state, movers, motion, jammed, report);
        if (jammed && !accepted) {
            pace.stuck = true;
            return;
        }
        if (motion.most() > 0 || accepted || state.unfinished.pace == static_cast<int>(movers.pace)) continue;
        state.settled = true;  // nothing better can be found and nothing asks for more
        std::fill(state.progress.data() + movers.first, state.progress.data() + movers.last, 1.0);
    }
}

// Tools and thread together, or one tool after the other.
void follow_tools(State& state, TickReport& report) {
    // What all together could not do each tool may still do alone: one that gives way must not wait for one that pulls.
    // But what is unfinished is finished first.
    const std::size_t groups = state.progress.size();
    const auto movers_of = [&](int pace) {
        const auto p = static_cast<std::size_t>(pace);
        return pace == 0 ? Movers{0, groups, 0} : Movers{p - 1, p, p};
    };
    if (const int pace = state.unfinished.pace; pace >= 0) {
        collect_asked(state, movers_of(pace));
        if (!is_much_the_same(state, state.paces[static_cast<std::size_t>(pace)].refused)) forget_unfinished(state);
    }
    const bool goes_well = groups == 1 || state.paces[0].trust > 0.25;
    for (int pace = 0; pace <= (groups > 1 ? static_cast<int>(groups) : 0); ++pace)
        if (state.unfinished.pace < 0 || state.unfinished.pace == pace)
            move(state, movers_of(pace), pace > 0 || goes_well ? most_work : most_work / 2, report);
}

}  // namespace

double unseen_room(const State& state) {
    return std::max(state.def.radius, state.reach - 2 * state.moved - state.def.radius);
}

double share_beside(const State& state, const Contact& c) {
    const MovingCapsule& tool = state.input.capsules[static_cast<std::size_t>(c.other)];
    const double way = (tool.to.a - tool.from.a + c.place * (tool.to.b - tool.to.a - tool.from.b + tool.from.a)).norm();
    return std::max(state.def.radius, c.gap - c.thickness) / way;
}

TickReport tick(State& state, const TickInput& input) {
    TickReport report;
    if (!is_finite(input)) {
        report.not_finite = true;
        report.fraction = 0;
        state.progress.assign(groups_of(input), 0);
        return report;
    }
    begin(state, input);
    if (input.surface_moved > 0) {
        wake(state);
        state.settled = false;
    }
    if (state.rod) {
        collect_asked(state, {0, state.progress.size(), 0});
        elastic_tick(state, longest_asked(state), report);
    } else {
        follow_tools(state, report);
        estimate_tension(state);
    }
    find_surface_forces(state);
    report.fraction = *std::min_element(state.progress.begin(), state.progress.end());
    report.stretch_max = worst_stretch(state, state.nodes);
    for (const Row& row : state.rows)
        if (row.against == Against::thread)
            report.separation_min = std::min(report.separation_min, row.distance / (2 * state.def.radius));
    return report;
}

}  // namespace sim::thread
