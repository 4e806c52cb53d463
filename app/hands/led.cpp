#include "app/hands/led.hpp"

#include "sim/geometry/portable_math.hpp"

namespace app::hands {

Quat rotation_of(const Vec3& turn) {
    const double angle = turn.norm();
    if (angle == 0) return Quat::Identity();
    const auto [sin, cos] = sim::geometry::portable_sin_cos(angle / 2);
    const Vec3 part = sin / angle * turn;
    return {cos, part.x(), part.y(), part.z()};
}

Quat turned_towards(const Quat& from, const Quat& to, double most) {
    constexpr double rounding = 1e-9;  // [rad] between a rotation and the same by way of the camera and back
    const double angle = from.angularDistance(to);
    if (angle < rounding) return from;
    return angle <= most ? to : sim::geometry::portable_slerp(from, to, most / angle);
}

}  // namespace app::hands
