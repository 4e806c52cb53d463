#include "sim/thread/elastic/mover.hpp"

#include <algorithm>

#include "sim/geometry/at.hpp"
#include "sim/thread/contact/gaps.hpp"
#include "sim/thread/contact/rows.hpp"
#include "sim/thread/elastic/sleep.hpp"

// A tick of an elastic thread: one implicit step in which the rod and all that it touches are linear, a step of
// Newton's method; what that leaves is taken up by the next tick. Where a node has used up what it may move before we
// look around again, the rest of the tick is another such step.
namespace sim::thread::elastic {

template <class T>
static void erase(std::vector<T>& values, std::size_t first, std::size_t past) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(first),
                 values.begin() + static_cast<std::ptrdiff_t>(past));
}

Mover::Mover(const ThreadDef& def, std::vector<Vec3> nodes, std::span<const int> cuts)
    : state_(def, std::move(nodes), cuts),
      detection_(state_.most_links()),
      audit_(state_.most_links()),
      finder_(state_.most_links()),
      solver_(state_.most_links()) {
    set_.contacts.reserve(2 * state_.most_links());
}

// How much nearer the step may bring what a contact is of: no point of a link goes farther than one of its ends.
static double nearing(std::span<const Vec3> step, const Contact& c) {
    const Vec3 &a = step[at(c.link)], &b = step[at(c.link + 1)];
    if (c.against != Against::thread) return std::max(a.norm(), b.norm());
    const Vec3 &from = step[at(c.other)], &to = step[at(c.other + 1)];
    return std::max({(a - from).norm(), (a - to).norm(), (b - from).norm(), (b - to).norm()});
}

// The largest share of the step that leaves every node within its bound, no contact's points farther along each other
// than links see straight, and what was too far to push, or for a row, just touching.
double Mover::share_within_bounds() const {
    const State& state = state_;
    constexpr double for_lengths = 0.9, for_turning = 0.3;
    const double most = for_turning * 2 * state.def.radius;
    const std::span<const Vec3> step = state.rod.step_found();
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
    for (std::size_t c = 0; c < set_.contacts.size(); ++c) {
        const ContactConstraint& contact = set_.contacts[c];
        if (contact.push.squaredNorm() > 0 && contact.row->against == Against::thread)
            limit((set_.apart_of(c) - contact::apart_of(state, *contact.row)).norm(), most);
    }
    for (const Row& row : state.rows)
        if (is_far(state, row)) limit(-displacement_of(state, row).dot(row.normal), row.distance - row.target);
    return share;
}

// Ends a step: what moved since `before` is known to pass through nothing by its bounds, and checked.
void Mover::end_step(TickReport& report) {
    State& state = state_;
    double moved = largest_capsule_move(state);
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const double move = (state.nodes[i] - state.before[i]).norm();
        moved = std::max(moved, move);
        if (move > 0) report.step_over_bound = std::max(report.step_over_bound, move / state.bound[i]);
    }
    state.moved += moved;
    report.pass_throughs += audit_.count_pass_throughs(state);
    ++report.substeps;
    state.pressed.clear();
    for (const ContactConstraint& contact : set_.contacts) {
        if (contact.push.squaredNorm() == 0) continue;
        Row& row = state.pressed.emplace_back(*contact.row);
        row.normal_push = contact.push.dot(row.normal);
        row.tangent_push = contact.push - row.normal_push * row.normal;
        row.began = contact.began;
    }
}

// What the pushes have become since the rod's step was found.
void Mover::add_changes() {
    State& state = state_;
    forces_.assign(state.nodes.size(), Vec3::Zero());
    for (const ContactConstraint& contact : set_.contacts)
        for (int k = 0; k < contact.pair.nodes; ++k)
            forces_[at(contact.pair.node[at(k)])] += contact.pair.weight[at(k)] * (contact.push - contact.pair.force);
    if (!set_.contacts.empty()) state.rod.add_forces(forces_);
}

void Mover::set_progress(double progress) {
    State& state = state_;
    std::fill(state.progress.begin(), state.progress.end(), progress);
    place_capsules(state);
}

static double path_of_step(const State& state, double left, const Motion& motion) {
    return std::max(0.5 * state.def.radius, left * motion.most());
}

// Tools first, by this share of what is left of their motion, then the thread's response to first order.
void Mover::respond(double left, double tools, const Motion& motion, TickReport& report) {
    State& state = state_;
    Rod& rod = state.rod;
    const double path = path_of_step(state, left, motion);
    if (motion.of_capsules > 0) {
        set_progress(1 - left * (1 - tools));
        state.moved += largest_capsule_move(state);
    }
    detection_.look_around(state, path);
    measure_gaps(state, path);
    contact::aim(state);
    report.contacts = std::max(report.contacts, static_cast<int>(state.rows.size()));
    finder_.find(state, set_.contacts);
    targets_.assign(state.input.holds.begin(), state.input.holds.end());
    for (Hold& hold : targets_) {
        if (state.asleep[at(hold.node)]) hold.slides = false, hold.target = state.nodes[at(hold.node)];
        const Vec3& from = hold.slides ? hold.start : state.nodes[at(hold.node)];
        hold.target = from + (hold.slides ? 1 - left * (1 - tools) : tools) * (hold.target - from);
    }
    slide_aside(state, targets_);
    rod.find_free_step(targets_, finder_.pairs(), finder_.rolling());
    report.sweeps += solver_.solve(state, set_);
    add_changes();
}

// Where the response would pull a link harder than any may tools wait, and the thread responds without them: one that
// stopped with them could not even give way. What would then still be pulled too hard, as by the way it bends, does
// stop it.
Mover::Left Mover::step(double left, const Motion& motion, TickReport& report) {
    State& state = state_;
    Rod& rod = state.rod;
    state.before = state.nodes;
    state.capsules_before = state.capsules;
    detection_.look_at_tools(state, path_of_step(state, left, motion));
    measure_tool_gaps(state);
    constexpr double by_tools = 0.99;  // of the most pull; the rest is for what the thread does by itself
    const double most = rod.def().most_pull();
    const double daring = advance_.share_of_tools(state, left, motion), careful = careful_share(state, left, daring);
    double tools = may_dare(state) ? daring : careful;
    respond(left, tools, motion, report);
    if (tools > careful && is_deep(state)) respond(left, tools = careful, motion, report);
    const double may_pull = rod.share_within(by_tools * most);
    const bool is_taut = may_pull < 1;
    if (is_taut) respond(left, tools *= may_pull, motion, report);
    const double share = rod.go_by(std::min(rod.share_within(most), share_within_bounds()), state.before, state.bound);
    std::copy(rod.nodes().begin(), rod.nodes().end(), state.nodes.begin());
    left *= 1 - tools * share;
    set_progress(1 - left);
    return {left, is_taut};
}

void Mover::tick(TickReport& report) {
    State& state = state_;
    constexpr int most_steps = 8;
    const int enough = state.def.contacts_per_tick;
    Rod& rod = state.rod;
    const Motion motion = longest_asked(state);
    wake_what_is_moved(state, stirred_);
    elastic::hold_what_sleeps(state);
    for (Row& row : state.pressed) row.began = row.push();
    rod.begin(
        {.holds = state.input.holds, .loads = state.input.loads, .turn = {}, .tolerance = {}, .asleep = state.asleep},
        state.input.seconds);
    Left left;
    int pressed = 0;
    for (int i = 0; i < most_steps && (enough == 0 || pressed < enough) && left.motion > 0 && !(i > 0 && left.is_taut);
         ++i) {
        left = step(left.motion, motion, report);
        end_step(report);
        pressed += static_cast<int>(set_.contacts.size());
    }
    rod.end();
    for (int k = 0; k < state.links(); ++k) state.tension[at(k)] = rod.tension(k);
    contact::aim(state);  // to where they are now
    watch_over_pieces(state);
}

void Mover::find_surface_forces() {
    State& state = state_;
    state.surface_forces.clear();
    if (!state.input.surface) return;
    const auto force_of = [](const Row& row) -> SurfaceForce { return {row.other, row.fixed, -row.push(), row.link}; };
    for (const Row& row : state.pressed) {
        if (row.against != Against::surface) continue;
        state.surface_forces.push_back(force_of(row));
        state.surface_forces.back().deeper = compliance_of_wall(state, row) * (row.began - row.push());
    }
    for (const SleepingContact& contact : state.sleeping) {
        if (contact.row.against != Against::surface) continue;
        state.surface_forces.push_back(force_of(contact.row));
        state.surface_forces.back().asleep = contact.wall;
    }
}

void Mover::split(std::size_t link, double share) {
    const auto place = static_cast<std::ptrdiff_t>(link) + 1;
    const Vec3 between = (1 - share) * state_.watched[link] + share * state_.watched[link + 1];
    state_.watched.insert(state_.watched.begin() + place, between);
    state_.asleep.insert(state_.asleep.begin() + place, char(state_.asleep[link]));
    state_.rod.split(link, share);
    const int parted = static_cast<int>(link);
    for_all_pressed(state_, [&](Row& row) {
        if (row.link > parted || (row.link == parted && row.s > share)) ++row.link;
        if (row.against == Against::thread && (row.other > parted || (row.other == parted && row.t > share)))
            ++row.other;
    });
}

void Mover::join_at(std::size_t node) {
    erase(state_.watched, node, node + 1);
    erase(state_.asleep, node, node + 1);
    state_.rod.join_at(node);
    const int joined = static_cast<int>(node);
    for_all_pressed(state_, [&](Row& row) {
        if (row.link >= joined) --row.link;
        if (row.against == Against::thread && row.other >= joined) --row.other;
    });
}

void Mover::leave_out(std::size_t first, std::size_t second) {
    const int from = static_cast<int>(first), to = static_cast<int>(second), fewer = to - from - 1;
    erase(state_.watched, first + 1, second);
    erase(state_.asleep, first + 1, second);
    state_.rod.leave_out(first, second);
    const auto is_gone = [&](int link) { return link >= from && link < to; };
    std::erase_if(state_.pressed, [&](const Row& row) {
        return is_gone(row.link) || (row.against == Against::thread && is_gone(row.other));
    });
    for_all_pressed(state_, [&](Row& row) {
        if (row.link >= to) row.link -= fewer;
        if (row.against == Against::thread && row.other >= to) row.other -= fewer;
    });
}

void Mover::renew() {
    state_.size_for_links();
    state_.rod.resize();
}

void Mover::hold_what_sleeps() {
    elastic::hold_what_sleeps(state_);
}

void Mover::wake_at(std::size_t link) {
    wake(state_, static_cast<int>(link));
}

}  // namespace sim::thread::elastic
