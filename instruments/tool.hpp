#pragma once
#include <array>
#include <string>

#include "sim/geometry/shapes.hpp"

namespace instruments {

using sim::geometry::Capsule;
using sim::geometry::Quat;
using sim::geometry::Vec3;

/// An approximator holds vessels by clamps on arms from the tips of its jaws; closing it brings them together. The arms
/// are not simulated: they meet nothing.
enum class Kind { forceps, needle_holder, scissors, approximator };

/// Frame of a tool: origin midway between the closed jaw tips, +z from the handle towards the tips, the jaws open
/// along +-x, the hinge turns about y.
struct Pose {
    Vec3 position = Vec3::Zero();      ///< [m], world.
    Quat rotation = Quat::Identity();  ///< Tool to world, unit.
};

/// What a device, a motion file or a recording says of one tool at one tick.
struct ToolInput {
    Pose pose;
    double jaw = 1.0;  ///< 0 closed to 1 open.
};

/// Real dimensions of one kind of tool; every collision part is a capsule (a Bullet capsule's radius is its margin, so
/// no hidden margin is left to choose).
struct ToolShape {
    double shaft_radius, shaft_length;  ///< [m]
    double jaw_radius, jaw_length;      ///< [m], hinge to tip.
    double jaw_opening;                 ///< Full angle between the jaws when open [rad].
    double grip_force;                  ///< Largest thread tension the closed jaws hold [N]; 0: blades, which cut.
};

const ToolShape& shape_of(Kind kind);

enum Part : int { shaft = 0, jaw_plus = 1, jaw_minus = 2 };
constexpr int part_count = 3;

/// How far the jaws' tips are from the tool's z axis beyond a radius, at an opening of `jaw` (0..1) [m].
double opening_of(const ToolShape& shape, double jaw);

/// The tool's parts in the world frame at a pose with its jaws at `jaw` (0..1). Pure; no allocation.
std::array<Capsule, part_count> parts_at(const ToolShape& shape, const Pose& pose, double jaw);

/// How far what is within `arm` [m] of a pose's origin is at most from where it is in another pose [m]; a turn counts
/// by its chord.
double way_between(const Pose& from, const Pose& to, double arm);

/// Pose between two: position linear, rotation slerp (portable). t in [0, 1].
Pose between(const Pose& from, const Pose& to, double t);

}  // namespace instruments
