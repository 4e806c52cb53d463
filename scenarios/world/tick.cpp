#include <cmath>

#include "scenarios/world/jaws.hpp"
#include "scenarios/world/world.hpp"

namespace scenarios::world {

void World::tick(std::span<const ToolInput> inputs) {
    ++ticks_;
    move_instruments(inputs);
    fit_links();
    update_grasps();
    const sim::thread::TickReport report = move_thread();
    let_tools_wait();
    let_grasps_slip();
    move_vessels();
    watch_needle();
    measure(report);
    part_thread();
}

// A tool that had to wait comes after its hand no faster than hands move in surgery (99 of 100 moments, da Vinci logs):
// set free, it would else leap, and whip the thread.
static ToolInput within_a_tick(const Tool& tool, const ToolInput& wanted, double tick_s) {
    constexpr double catching_up = 0.1;  // [m/s]
    const auto way_from = [&](const instruments::Pose& from) {
        return instruments::way_between(from, wanted.pose, tool.shape.jaw_length);
    };
    const double behind = way_from(tool.now.pose), most = way_from(tool.asked.pose) + catching_up * tick_s;
    return behind > most ? ToolInput{instruments::between(tool.now.pose, wanted.pose, most / behind), wanted.jaw}
                         : wanted;
}

// Its clamps run on screws, and walls come after them.
static ToolInput by_screw(const Tool& tool, const ToolInput& wanted, double tick_s) {
    constexpr double screw = 0.01;  // [m/s]
    const double opens =
        instruments::opening_of(tool.shape, wanted.jaw) - instruments::opening_of(tool.shape, tool.now.jaw);
    const double way = instruments::way_between(tool.now.pose, wanted.pose, tool.shape.jaw_length) + std::abs(opens),
                 share = screw * tick_s / way;
    if (!(share < 1)) return wanted;
    return {instruments::between(tool.now.pose, wanted.pose, share),
            tool.now.jaw + share * (wanted.jaw - tool.now.jaw)};
}

static double told_behind(const Tool& tool) {
    return 2 * tool.shape.jaw_radius;
}

// Swept from where each tool is to where it is asked to be: a fast tool stops at what it meets.
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
            next.jaw = std::max(next.jaw, shut_below);  // or they would crush what they cut
        if (tool.def.kind == instruments::Kind::approximator) next = by_screw(tool, next, def_.tick_s);
        if (std::isfinite(tool.def.pull)) next = by_feel(static_cast<int>(i), next);
        const instruments::Advance advance = tool_world_.advance(static_cast<int>(i), next);
        tool.now = advance.reached;
        tool.stopped = advance.stopped;
        tool.asked = *wanted;
        if (tool.stopped)
            tell_what_holds_up(
                tool, advance.tool >= 0 ? tools_[static_cast<std::size_t>(advance.tool)].def.name : "a vessel");
    }
}

// Or a motion fails, and its author does not learn where.
void World::tell_what_holds_up(Tool& tool, const std::string& by) {
    if (tool.held_up || tool.lag() < told_behind(tool)) return;
    tool.held_up = true;
    log(EventKind::held_up, tool.def.name + " by " + by, 1e3 * tool.lag());
}

void World::list_held() {
    held_.clear();
    for (const Tool& tool : tools_)
        for (const Grasp& grasp : tool.grasps)
            for (int k = 0; k < grasp.count; ++k) held_.push_back(grasp.first + k);
    for (const Needle& needle : needles_) held_.insert(held_.end(), {needle.node, needle.node + 1});
}

// Links where they are needed; what is held is found again by its new numbers.
void World::fit_links() {
    list_held();
    if (!thread_.fit_links(held_)) return;
    std::size_t next = 0;
    for (Tool& tool : tools_)
        for (Grasp& grasp : tool.grasps) {
            grasp.first = held_[next];
            next += static_cast<std::size_t>(grasp.count);
        }
    for (Needle& needle : needles_) needle.node = held_[next], next += 2;
}

// Grasped nodes go where their tool goes; what they lack of where it is commanded to be, with nothing but thread in its
// way, is tension.
sim::thread::TickReport World::move_thread() {
    holds_.clear();
    hold_owners_.clear();
    capsules_.clear();
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        const Tool& tool = tools_[i];
        const instruments::Pose &start = tool.before.pose, &next = tool.now.pose,
                                &wanted = tool.stopped ? next : tool.asked.pose;
        for (const Grasp& grasp : tool.grasps)
            for (int k = 0; k < grasp.count; ++k) {
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
    return thread_.tick({holds_,
                         hold_owners_,
                         capsules_,
                         &wall_.tree(),
                         def_.tick_s,
                         {},
                         wall_moved_,
                         swages_,
                         vessels_.empty() ? wall_.size() : vessels_.front().first,
                         wall_gives});
}

// When the thread is taut a tool waits: it goes only as far as the thread let it. An elastic one lets all wait for one.
void World::let_tools_wait() {
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        Tool& tool = tools_[i];
        const double share = thread_.progress(static_cast<int>(i));
        if (share < 1) {
            tool.now = {instruments::between(tool.before.pose, tool.now.pose, share),
                        tool.before.jaw + share * (tool.now.jaw - tool.before.jaw)};
            tool_world_.set_pose(static_cast<int>(i), tool.now);
            if (!tool.stopped) tell_what_holds_up(tool, "the thread");
            for (Needle& needle : needles_)
                if (needle.holder.tool == static_cast<int>(i)) needle.now = needle.led_by(tool.now.pose);
        }
        constexpr double caught_up = 0.5;  // or one that stays as far behind as is told is told again and again
        if (tool.lag() < caught_up * told_behind(tool)) tool.held_up = false;
    }
}

}  // namespace scenarios::world
