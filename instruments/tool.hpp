#pragma once
#include <array>
#include <string>

#include "sim/geometry/shapes.hpp"

namespace instruments {

using sim::geometry::Capsule;
using sim::geometry::Quat;
using sim::geometry::Vec3;

/// What a tool is. An approximator holds vessels by clamps on arms from the tips of its jaws; closing it brings them
/// together. The arms are not simulated: they meet nothing.
enum class Kind { forceps, needle_holder, scissors, approximator };

/// Where a tool is, as the pose of its frame: origin midway between the closed jaw tips, +z from the handle towards the
/// tips, the jaws open along +-x, the hinge turns about y.
struct Pose {
    Vec3 position = Vec3::Zero();      ///< Of the frame's origin in the world [m].
    Quat rotation = Quat::Identity();  ///< From the tool's frame to the world's, unit.
};

/// What a device, a motion file or a recording says of one tool at one tick.
struct ToolInput {
    Pose pose;         ///< Where it should be.
    double jaw = 1.0;  ///< How far it is open, 0 closed to 1 open.
};

/// Real dimensions of one kind of tool; every collision part is a capsule (a Bullet capsule's radius is its margin, so
/// no hidden margin is left to choose).
struct ToolShape {
    double shaft_radius;  ///< [m]
    double shaft_length;  ///< Behind the hinge [m].
    double jaw_radius;    ///< [m]
    double jaw_length;    ///< From hinge to tip [m].
    double jaw_opening;   ///< Full angle between the jaws when open, up to 2 pi / 3 [rad].
    double grip_force;    ///< Largest thread tension that the closed jaws hold [N]; 0: blades, which cut.
};

/// The dimensions of one kind.
const ToolShape& shape_of(Kind kind);

/// Collision parts of a tool, as indices.
enum Part : int { shaft = 0, jaw_plus = 1, jaw_minus = 2 };
constexpr int part_count = 3;  ///< How many parts a tool has.

/// How far the jaws' tips are from the tool's z axis beyond a radius, at an opening of `jaw` (0..1) [m].
double opening_of(const ToolShape& shape, double jaw);

/// The tool's parts in the world frame at a pose with its jaws at `jaw` (0..1). Pure; no allocation.
std::array<Capsule, part_count> parts_at(const ToolShape& shape, const Pose& pose, double jaw);

/// How far apart a point within `arm` [m] of a tool's origin is in two poses at most [m]; a turn counts by its chord.
double distance_between(const Pose& from, const Pose& to, double arm);

/// The pose between two: position linear, rotation slerp (portable). `t` from 0 to 1; beyond, the pose at that end.
Pose between(const Pose& from, const Pose& to, double t);

}  // namespace instruments
