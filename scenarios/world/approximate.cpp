#include "scenarios/world/world.hpp"

namespace scenarios::world {

// Where an approximator's jaw that a vessel goes with has its tip, in the approximator's own axes.
static Vec3 tip(const Tool& tool, const SoftVessel& vessel) {
    return {vessel.side * instruments::opening_of(tool.shape, tool.now.jaw), 0, 0};
}

// A vessel goes with the jaw on whose side its clamps are at the start.
void World::clamp(SoftVessel& vessel) {
    if (vessel.held_by < 0) return;
    const Tool& tool = tools_[static_cast<std::size_t>(vessel.held_by)];
    const Eigen::Matrix3d axes = tool.now.pose.rotation.toRotationMatrix();
    vessel.side = axes.col(0).dot(vessel.clamps.front().target - tool.now.pose.position) < 0 ? -1 : 1;
    for (const tissue::Hold& hold : vessel.clamps) vessel.led_at.push_back(axes.transpose() * (hold.target - tool.now.pose.position) - tip(tool, vessel));
}

void World::lead_clamps(SoftVessel& vessel) {
    if (vessel.held_by < 0) return;
    const Tool& tool = tools_[static_cast<std::size_t>(vessel.held_by)];
    for (std::size_t i = 0; i < vessel.clamps.size(); ++i)
        vessel.clamps[i].target = tool.now.pose.position + tool.now.pose.rotation * (vessel.led_at[i] + tip(tool, vessel));
}

}  // namespace scenarios::world
