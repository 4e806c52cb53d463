#include "scenarios/world/world.hpp"

namespace scenarios::world {

void World::tick(std::span<const ToolInput> inputs) {
    ++ticks_;
    move_instruments(inputs);
    update_grasps();
    const sim::thread::TickReport report = move_thread();
    let_tools_wait(report.fraction);
    let_grasps_slip();
    measure(report);
}

// Swept from where each tool is to where it is asked to be: a fast tool stops at what it meets.
void World::move_instruments(std::span<const ToolInput> inputs) {
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        Tool& tool = tools_[i];
        tool.before = tool.now;
        const instruments::Advance advance = bench_.advance(static_cast<int>(i), inputs[i]);
        tool.now = advance.reached;
        if (advance.input_dropped)
            log("input_dropped", tool.def.name, 0);
        else
            tool.asked = advance.asked;
    }
}

// Grasped nodes are asked to where the commanded tool would have them: what cannot be reached is lag and tension.
sim::thread::TickReport World::move_thread() {
    holds_.clear();
    hold_owners_.clear();
    capsules_.clear();
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        const Tool& tool = tools_[i];
        for (const Grasp& grasp : tool.grasps)
            for (int k = 0; k < grasp.count; ++k) {
                const Vec3& anchor = grasp.anchor[static_cast<std::size_t>(k)];
                holds_.push_back({grasp.first + k, tool.now.pose.position + tool.now.pose.rotation * anchor});
                hold_owners_.push_back(static_cast<int>(i));
            }
        const auto from = instruments::parts_at(tool.shape, tool.before.pose, tool.before.jaw);
        const auto to = instruments::parts_at(tool.shape, tool.now.pose, tool.now.jaw);
        for (std::size_t part = 0; part < from.size(); ++part) capsules_.push_back({from[part], to[part], static_cast<int>(i)});
    }
    return thread_.tick({holds_, hold_owners_, capsules_, &surface_});
}

// When the thread is taut the tool waits: it goes only as far as the thread let it.
void World::let_tools_wait(double fraction) {
    if (fraction >= 1) return;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        Tool& tool = tools_[i];
        tool.now = {instruments::between(tool.before.pose, tool.now.pose, fraction),
                    tool.before.jaw + fraction * (tool.now.jaw - tool.before.jaw)};
        bench_.set_pose(static_cast<int>(i), tool.now);
    }
}

}  // namespace scenarios::world
