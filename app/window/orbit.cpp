#include "app/window/orbit.hpp"

#include <algorithm>
#include <cmath>

#include "app/draw/camera.hpp"

namespace app::window {

using draw::Vec3;

constexpr double degree = 0.0174533;

static Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
    return Eigen::AngleAxisd(angle, axis) * v;
}

draw::Camera Orbit::from_aside() const {
    draw::Camera aside = now_;
    const Vec3 away = now_.position - now_.target, right = draw::axes_of(now_).row(0);
    aside.position = now_.target + away.norm() * (0.97 * right + 0.24 * Vec3::UnitZ()).normalized();
    return aside;
}

// Never over the top, where up would become down.
void Orbit::turn(double right, double down) {
    Vec3 away = turned(now_.position - now_.target, Vec3::UnitZ(), -0.5 * degree * right);
    const double height = std::asin(std::clamp(away.normalized().z(), -1.0, 1.0));
    const double next = std::clamp(height + 0.5 * degree * down, -80 * degree, 80 * degree);
    const Vec3 axis = away.cross(Vec3::UnitZ()).normalized();
    away = turned(away, axis, next - height);
    now_.position = now_.target + away;
}

void Orbit::shift(double right, double down, double height) {
    const Eigen::Matrix3d axes = draw::axes_of(now_);
    const double metres = 2 * draw::half_height(now_) * (now_.position - now_.target).norm() / height;
    const Vec3 by = metres * (down * axes.row(1) - right * axes.row(0)).transpose();
    now_.position += by;
    now_.target += by;
}

void Orbit::zoom(double notches) {
    constexpr double nearest = 5e-3, farthest = 0.6;  // [m]
    const Vec3 away = now_.position - now_.target;
    const double distance = std::clamp(away.norm() * std::pow(0.9, notches), nearest, farthest);
    now_.position = now_.target + distance * away.normalized();
}

void Orbit::look_from(const Vec3& towards) {
    now_.position = now_.target + (now_.position - now_.target).norm() * towards.normalized();
}

void Orbit::look_at(const Vec3& place) {
    now_.position += place - now_.target;
    now_.target = place;
}

}  // namespace app::window
