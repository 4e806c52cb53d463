#include "app/hands/assist_snap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/hands/assist_wrist.hpp"

namespace app::hands {

bool glide(Led& tool, const instruments::ToolShape& shape, const Vec3& to, double seconds) {
    constexpr double clear = 0.6e-3, near_enough = 0.15e-3;
    Pose& pose = tool.at.pose;
    const Vec3 place = pose.rotation.conjugate() * (to - pose.position);
    const double half_gap = instruments::opening_of(shape, tool.at.jaw);
    Vec3 way = place + Vec3(0, 0, bite_depth);
    if (way.norm() < near_enough) return true;
    if (std::abs(place.x()) > half_gap / 2) {
        const bool is_beside = place.z() < clear;
        way = is_beside ? Vec3(0, 0, place.z() - 2 * clear) : Vec3(place.x(), 0, 0);
    }
    pose.position += pose.rotation * (std::min(1.0, Snap::speed * seconds / way.norm()) * way);
    return false;
}

void Snap::begin(Led& tool) {
    tool.waits = tool.is_open();
    left_s_ = patience_s;
}

// Jaws that lie along a strand would not take it: they turn half across at least.
void Snap::tick(Led& tool, const instruments::ToolShape& shape, const std::optional<Takeable>& lit, double seconds) {
    constexpr double across = 0.6, rate = std::numbers::pi / 2;
    if (!tool.waits) return;
    left_s_ -= seconds;
    tool.waits = lit && tool.shuts() && left_s_ > 0;
    if (!tool.waits) return;
    Quat& rotation = tool.at.pose.rotation;
    if (std::abs((rotation * Vec3::UnitY()).dot(lit->along)) < across)
        rotation = turned_towards(rotation, square_to(rotation, lit->along), rate * seconds);
    else if (glide(tool, shape, lit->at, seconds))
        tool.waits = false;
}

}  // namespace app::hands
