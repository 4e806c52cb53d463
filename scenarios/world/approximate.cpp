#include "scenarios/world/world.hpp"

namespace scenarios::world {

// Where an approximator's jaw is that a vessel goes with: turned as the approximator is.
static Eigen::Isometry3d jaw(const Tool& tool, double side) {
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    at.linear() = tool.now.pose.rotation.toRotationMatrix();
    at.translation() =
        tool.now.pose.position + side * instruments::opening_of(tool.shape, tool.now.jaw) * at.linear().col(0);
    return at;
}

// A vessel goes with the jaw on whose side its clamps are at the start.
void World::clamp(SoftVessel& vessel) {
    if (vessel.held_by < 0) return;
    const Tool& tool = tools_[static_cast<std::size_t>(vessel.held_by)];
    const Vec3 to_clamp = vessel.clamps.front().target - tool.now.pose.position;
    vessel.side = (tool.now.pose.rotation * Vec3::UnitX()).dot(to_clamp) < 0 ? -1 : 1;
    vessel.to_jaw = jaw(tool, vessel.side).inverse();
}

void World::lead_clamps(SoftVessel& vessel) {
    if (vessel.held_by < 0) return;
    vessel.carried = jaw(tools_[static_cast<std::size_t>(vessel.held_by)], vessel.side) * vessel.to_jaw;
    for (tissue::Hold& hold : vessel.clamps)
        hold.target = vessel.carried * vessel.tissue.rest().nodes[static_cast<std::size_t>(hold.node)];
}

}  // namespace scenarios::world
