#include "app/draw/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app::draw {

// 30 degrees: a lens long enough that near tools do not loom over the thread.
constexpr double field_of_view = 0.524;
const Vec3 towards_eye = Vec3(0, -0.78, 0.62).normalized();

static Camera seen_from(const Vec3& towards, const Vec3& point, double radius) {
    return {point + radius / std::sin(field_of_view / 2) * towards, point, Vec3::UnitZ(), field_of_view};
}

// A mirror image of the usual way where that would look through what lies below.
Camera close_view(const Vec3& point, double radius, const Vec3& outwards) {
    Camera camera = seen_from(towards_eye - 2 * std::min(0.0, towards_eye.dot(outwards)) * outwards, point, radius);
    camera.cut_off = 1 - 1.5 * std::sin(field_of_view / 2);
    return camera;
}

// 18.5 mm up and down are 25 mm to either side, with room to spare, in a picture of 3 to 2.
Camera default_view() {
    return seen_from(towards_eye, Vec3::Zero(), 18.5e-3);
}

// In the camera's axes a point p is within the right edge when p.x + t p.z <= c.x + t c.z, c the eye and t the tangent
// of half the field; so the edges are each tight for one point, and the eye stands where the tighter pair meets.
Camera view_of(const std::vector<Vec3>& points, double aspect) {
    Camera camera{towards_eye, Vec3::Zero(), Vec3::UnitZ(), field_of_view};
    if (points.empty()) return default_view();
    const Eigen::Matrix3d axes = axes_of(camera);
    const double up = half_height(camera), across = up * aspect;
    Eigen::Vector4d edge = Eigen::Vector4d::Constant(-std::numeric_limits<double>::infinity());
    Vec3 mean = Vec3::Zero();
    for (const Vec3& point : points) {
        const Vec3 p = axes * point;
        edge = edge.cwiseMax(
            Eigen::Vector4d(p.x() + across * p.z(), -p.x() + across * p.z(), p.y() + up * p.z(), -p.y() + up * p.z()));
        mean += p / static_cast<double>(points.size());
    }
    const double back = std::max((edge[0] + edge[1]) / (2 * across), (edge[2] + edge[3]) / (2 * up));
    const Vec3 eye((edge[0] - edge[1]) / 2, (edge[2] - edge[3]) / 2, back);
    camera.position = axes.transpose() * eye;
    camera.target = axes.transpose() * Vec3(eye.x(), eye.y(), mean.z());
    return camera;
}

Eigen::Matrix3d axes_of(const Camera& camera) {
    const Vec3 back = (camera.position - camera.target).normalized();
    const Vec3 right = camera.up.cross(back).normalized();
    Eigen::Matrix3d axes;
    axes << right.transpose(), back.cross(right).transpose(), back.transpose();
    return axes;
}

double half_height(const Camera& camera) {
    return std::tan(camera.field_of_view / 2);
}

double near_plane(const Camera& camera) {
    return (camera.position - camera.target).norm() * camera.cut_off;
}
double far_plane(const Camera& camera) {
    return (camera.position - camera.target).norm() * 50;
}

Eigen::Matrix4d clip_from_world(const Camera& camera, double aspect) {
    const double near = near_plane(camera), far = far_plane(camera), scale = 1 / half_height(camera);
    Eigen::Matrix4d clip = Eigen::Matrix4d::Zero(), view = Eigen::Matrix4d::Identity();
    clip(0, 0) = scale / aspect;
    clip(1, 1) = scale;
    clip(2, 2) = -(far + near) / (far - near);
    clip(2, 3) = -2 * far * near / (far - near);
    clip(3, 2) = -1;
    view.topLeftCorner<3, 3>() = axes_of(camera);
    view.topRightCorner<3, 1>() = -axes_of(camera) * camera.position;
    return clip * view;
}

Vec3 project(const Picture& picture, const Vec3& point) {
    const Vec3 p = axes_of(picture.camera) * (point - picture.camera.position);
    const double pixels = picture.height / (2 * half_height(picture.camera) * -p.z());
    return {picture.width / 2.0 + p.x() * pixels, picture.height / 2.0 - p.y() * pixels, -p.z()};
}

}  // namespace app::draw
