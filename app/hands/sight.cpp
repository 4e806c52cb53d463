#include "app/hands/sight.hpp"

#include <cmath>

#include "app/hands/led.hpp"

namespace app::hands {

Vec3 Sight::project(const Vec3& point) const {
    const Vec3 seen = turned.conjugate() * (point - eye);
    return {pixels * seen.x() / -seen.z(), pixels * seen.y() / -seen.z(), -seen.z()};
}

Sight look_at(const Vec3& eye, const Vec3& target, const Vec3& up, double field_of_view, double height) {
    const Vec3 back = (eye - target).normalized(), right = up.cross(back).normalized();
    Eigen::Matrix3d axes;
    axes << right, back.cross(right), back;
    return {eye, Quat(axes), height / (2 * std::tan(field_of_view / 2))};
}

Pose moved(const Pose& tool, const Step& step, const Sight& sight, double scale) {
    Pose next = tool;
    if (!step.move.isZero(0)) {
        const Vec3 across(step.move.x(), step.move.y(), 0);
        const Vec3 sightline = (sight.eye - tool.position).normalized();
        next.position += scale * (sight.turned * across + step.move.z() * sightline);
    }
    if (!step.turn.isZero(0)) next.rotation = (rotation_of(sight.turned * step.turn) * next.rotation).normalized();
    if (step.roll != 0) next.rotation = (next.rotation * rotation_of({0, 0, step.roll})).normalized();
    return next;
}

}  // namespace app::hands
