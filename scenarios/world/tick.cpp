#include <algorithm>
#include <cassert>
#include <cmath>

#include "scenarios/world/jaws.hpp"
#include "scenarios/world/world.hpp"

namespace scenarios::world {

void World::tick(std::span<const ToolInput> inputs) {
    assert(inputs.size() == tools_.size() && "an input for each instrument");
    ++ticks_;
    move_instruments(inputs);
    fit_links();
    update_grasps();
    const sim::thread::TickReport report = move_thread();
    let_tools_wait();
    let_grasps_slip();
    move_walls();
    watch_needle();
    watch_tools_in_walls();
    measure(report);
    part_thread();
}

// A tool that had to wait follows its hand no faster than hands move in surgery (99 of 100 moments, da Vinci logs). Set
// free, it would leap otherwise, and whip the thread.
static ToolInput within_a_tick(const Tool& tool, const ToolInput& wanted, double tick_s) {
    constexpr double catching_up = 0.1;  // [m/s]
    const auto way_from = [&](const instruments::Pose& from) {
        return instruments::distance_between(from, wanted.pose, tool.shape.jaw_length);
    };
    const double behind = way_from(tool.now.pose), most = way_from(tool.asked.pose) + catching_up * tick_s;
    return behind > most ? ToolInput{instruments::between(tool.now.pose, wanted.pose, most / behind), wanted.jaw}
                         : wanted;
}

// An approximator's clamps run on screws, so it moves no faster than they turn; walls follow them.
static ToolInput speed_limited(const Tool& tool, const ToolInput& wanted, double tick_s) {
    constexpr double screw = 0.01;  // [m/s]
    const double opens =
        instruments::opening_of(tool.shape, wanted.jaw) - instruments::opening_of(tool.shape, tool.now.jaw);
    const double distance =
                     instruments::distance_between(tool.now.pose, wanted.pose, tool.shape.jaw_length) + std::abs(opens),
                 share = screw * tick_s / distance;
    if (!(share < 1)) return wanted;
    return {instruments::between(tool.now.pose, wanted.pose, share),
            tool.now.jaw + share * (wanted.jaw - tool.now.jaw)};
}

// How far a tool is behind its hand when that is told [m].
static double lag_report_threshold(const Tool& tool) {
    return 2 * tool.shape.jaw_radius;
}

// Each tool is swept from where it is to where it is asked to be: a fast tool stops at what it meets.
void World::move_instruments(std::span<const ToolInput> inputs) {
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        Tool& tool = tools_[i];
        tool.before = tool.now;
        tool.stopped = false;
        const auto wanted = instruments::usable(inputs[i], tool.shape);
        if (!wanted) {
            log(EventKind::input_dropped, tool.def.name, 0);
            continue;
        }
        ToolInput next = within_a_tick(tool, *wanted, def_.tick_s);
        if (tool.def.kind == instruments::Kind::scissors)
            next.jaw = std::max(next.jaw, shut_below);  // shut further, they would crush what they cut
        if (tool.def.kind == instruments::Kind::approximator) next = speed_limited(tool, next, def_.tick_s);
        if (std::isfinite(tool.def.pull)) next = force_limited(static_cast<int>(i), next);
        const instruments::Advance advance = tool_world_.advance(static_cast<int>(i), next);
        tool.now = advance.reached;
        tool.stopped = advance.stopped;
        tool.asked = *wanted;
        if (tool.stopped)
            report_lag(tool, advance.tool >= 0 ? tools_[static_cast<std::size_t>(advance.tool)].def.name : "a vessel");
    }
}

// Without this event a motion fails and its author never learns where.
void World::report_lag(Tool& tool, const std::string& by) {
    if (tool.held_up || tool.lag() < lag_report_threshold(tool)) return;
    tool.held_up = true;
    log(EventKind::held_up, tool.def.name + " by " + by, 1e3 * tool.lag());
}

void World::list_held() {
    held_.clear();
    for (const Tool& tool : tools_)
        for (const Grasp& grasp : tool.grasps)
            for (int k = 0; k < grasp.count(); ++k) held_.push_back(grasp.first + k);
    for (const Needle& needle : needles_) held_.insert(held_.end(), {needle.node, needle.node + 1});
}

// Puts links where they are needed; whoever holds nodes finds them again by their new numbers.
void World::fit_links() {
    list_held();
    if (!thread_.fit_links(held_)) return;
    std::size_t next = 0;
    for (Tool& tool : tools_)
        for (Grasp& grasp : tool.grasps) {
            grasp.first = held_[next];
            next += static_cast<std::size_t>(grasp.count());
        }
    for (Needle& needle : needles_) needle.node = held_[next], next += 2;
}

// Grasped nodes go where their tool goes. What they lack of where it is commanded to be, with nothing but thread
// holding it back, is tension.
sim::thread::TickReport World::move_thread() {
    holds_.clear();
    hold_owners_.clear();
    capsules_.clear();
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        const Tool& tool = tools_[i];
        const instruments::Pose &start = tool.before.pose, &next = tool.now.pose,
                                &wanted = tool.stopped ? next : tool.asked.pose;
        for (const Grasp& grasp : tool.grasps)
            for (int k = 0; k < grasp.count(); ++k) {
                const Vec3& anchor = grasp.anchor[static_cast<std::size_t>(k)];
                const auto led_by = [&](const instruments::Pose& pose) -> Vec3 {
                    return pose.position + pose.rotation * anchor;
                };
                holds_.push_back({grasp.first + k, led_by(next), led_by(wanted), true, led_by(start)});
                hold_owners_.push_back(static_cast<int>(i));
            }
        const auto from = instruments::parts_at(tool.shape, tool.before.pose, tool.before.jaw);
        const auto to = instruments::parts_at(tool.shape, tool.now.pose, tool.now.jaw);
        for (std::size_t part = 0; part < from.size(); ++part)
            capsules_.push_back({from[part], to[part], static_cast<int>(i)});
    }
    swages_.clear();
    for (Needle& needle : needles_) {
        hold_thread_on(needle);
        swages_.push_back(needle.node);
    }
    return thread_.tick({.holds = holds_,
                         .hold_owners = hold_owners_,
                         .capsules = capsules_,
                         .surface = &walls_.tree(),
                         .seconds = def_.tick_s,
                         .surface_moved = walls_.moved(),
                         .sheathed = swages_,
                         .soft_from = walls_.soft_from(),
                         .soft_compliance = wall_compliance});
}

// When the thread is taut a tool waits: it goes only as far as the thread let it. An elastic thread lets all tools wait
// for one.
void World::let_tools_wait() {
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        Tool& tool = tools_[i];
        const double share = thread_.progress(static_cast<int>(i));
        if (share < 1) {
            tool.now = {instruments::between(tool.before.pose, tool.now.pose, share),
                        tool.before.jaw + share * (tool.now.jaw - tool.before.jaw)};
            tool_world_.set_pose(static_cast<int>(i), tool.now);
            if (!tool.stopped) report_lag(tool, "the thread");
            for (Needle& needle : needles_)
                if (needle.holder.tool == static_cast<int>(i)) needle.now = needle.led_by(tool.now.pose);
        }
        // A tool that stays about as far behind as is told must not be told again and again.
        constexpr double caught_up = 0.5;
        if (tool.lag() < caught_up * lag_report_threshold(tool)) tool.held_up = false;
    }
}

// How much of the thread's pressure on walls counts. By `ftl` a tension is an estimate from lag: the part that thread
// and jaws would not bear does not exist.
double World::trusted_share() const {
    if (is_elastic()) return 1;
    const double tension = *std::max_element(thread_.tension().begin(), thread_.tension().end()),
                 most = std::min(most_pull(), def_.thread.break_force);
    return tension <= most ? 1 : most / tension;
}

// Walls feel one needle at a time: they turn to the one that was taken last once they hold the one before no longer.
void World::move_walls() {
    if (in_use_ != taken_ && !walls_.hold_needle()) in_use_ = taken_;
    if (vessels().empty()) return;
    walls_.tick({.thread = thread_,
                 .tools = tools_,
                 .needle = needles_.empty() ? nullptr : &needle_in_use(),
                 .trusted_share = trusted_share(),
                 .tick = ticks_,
                 .tick_s = def_.tick_s},
                events_);
}

}  // namespace scenarios::world
