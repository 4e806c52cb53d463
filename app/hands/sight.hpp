#pragma once
#include <algorithm>

#include "instruments/tool.hpp"

namespace app::hands {

using instruments::Pose;
using instruments::ToolInput;
using sim::geometry::Quat;
using sim::geometry::Vec3;

/// How the person sees the scene: a pinhole camera.
struct Sight {
    Vec3 eye = Vec3(0, 0, 0.1);      ///< Where it is [m], world.
    Quat turned = Quat::Identity();  ///< From its axes (right, up, back) to the world's, unit.
    double pixels = 1000;            ///< Of a metre that lies across, one metre before the eye.

    /// How far before the eye a point is [m], along the camera's axis.
    double depth(const Vec3& point) const { return (turned.conjugate() * (eye - point)).z(); }
    /// What one pixel is at a point's depth [m]; never less than at 1 mm.
    double metres_per_pixel(const Vec3& point) const { return std::max(depth(point), 1e-3) / pixels; }
    /// Where a point of the world is in the picture: right and up from its middle [pixels], and its depth [m].
    Vec3 project(const Vec3& point) const;
};

/// The sight of a camera at `eye` that looks at `target` [m], for a picture of this height [pixels] and field of view,
/// from its lower to its upper edge [rad]. `up` need only not lie along the line of sight.
Sight look_at(const Vec3& eye, const Vec3& target, const Vec3& up, double field_of_view, double height);

/// What a hand does in a moment, as the camera sees it: the same for all devices.
struct Step {
    Vec3 move = Vec3::Zero();  ///< Right, up, and towards the eye along the line of sight [m].
    Vec3 turn = Vec3::Zero();  ///< About the camera's axes (right, up, back), a rotation vector [rad].
    double roll = 0;           ///< About the tool's shaft, from handle to tip [rad].
};

/// Where a tool is after a step of its hand. `scale` multiplies moves alone; turns are about its jaws. A step that does
/// nothing changes no bit.
Pose moved(const Pose& tool, const Step& step, const Sight& sight, double scale);

}  // namespace app::hands
