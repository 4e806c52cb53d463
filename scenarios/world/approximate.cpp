// Vessels whose ends an approximator holds in its clamps.
#include "scenarios/world/soft_vessel.hpp"

namespace scenarios::world {

// Pose of the approximator's jaw on this side (1 or -1), turned as the approximator is.
static Eigen::Isometry3d jaw(const Tool& tool, double side) {
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    at.linear() = tool.now.pose.rotation.toRotationMatrix();
    at.translation() =
        tool.now.pose.position + side * instruments::opening_of(tool.shape, tool.now.jaw) * at.linear().col(0);
    return at;
}

// A vessel goes with the jaw on whose side its clamps are at the start.
void SoftVessel::clamp(const Tool& tool) {
    const Vec3 to_clamp = clamps.front().target - tool.now.pose.position;
    side = (tool.now.pose.rotation * Vec3::UnitX()).dot(to_clamp) < 0 ? -1 : 1;
    to_jaw = jaw(tool, side).inverse();
}

void SoftVessel::lead_clamps(const Tool& tool) {
    carried = jaw(tool, side) * to_jaw;
    for (tissue::Hold& hold : clamps) hold.target = carried * tissue.rest().nodes[static_cast<std::size_t>(hold.node)];
}

}  // namespace scenarios::world
