#include "app/hands/assist_wrist.hpp"

#include <algorithm>
#include <numbers>

#include "sim/geometry/portable_math.hpp"

namespace app::hands {

Quat square_to(const Quat& rotation, const Vec3& along) {
    const Vec3 hinge = rotation * Vec3::UnitY();
    return (sim::geometry::rotation_between(hinge, hinge.dot(along) < 0 ? Vec3(-along) : along) * rotation)
        .normalized();
}

Quat rolled_across(const Quat& rotation, const Vec3& along) {
    constexpr double nearly = 0.2;
    const Vec3 shaft = rotation * Vec3::UnitZ(), across = along - along.dot(shaft) * shaft;
    return across.norm() < nearly ? rotation : square_to(rotation, across.normalized());
}

void Wrist::turn(const Step& step, const Sight& sight) {
    keep(moved({Vec3::Zero(), sight.turned * home_}, {Vec3::Zero(), step.turn, step.roll}, sight, 1).rotation, sight);
}

void Wrist::tick(Led& tool, const std::optional<Takeable>& near, const Sight& sight, double seconds) const {
    constexpr double rate = std::numbers::pi / 2, all_within = 2e-3;
    const Quat home = sight.turned * home_;
    Quat wanted = home;
    if (near && tool.is_open()) {
        const double share = std::clamp((reach - near->distance) / (reach - all_within), 0.0, 1.0);
        wanted = sim::geometry::portable_slerp(home, rolled_across(home, near->along), share);
    }
    tool.at.pose.rotation = turned_towards(tool.at.pose.rotation, wanted, rate * seconds);
}

}  // namespace app::hands
