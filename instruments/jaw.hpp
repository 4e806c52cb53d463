#pragma once
#include <optional>

#include "instruments/tool.hpp"

namespace instruments {

/// The room between a tool's jaws, in the tool's frame: |x| below a half width that grows from hinge to tip, |y| below
/// the jaws' radius. Its sides are the jaws' centre lines, so that what touches a closed jaw's inner face is inside.
struct JawGap {
    double hinge_z, tip_z;  ///< [m]
    double hinge_half_width, tip_half_width;
    double half_depth;
};

JawGap jaw_gap(const ToolShape& shape, double jaw);

/// Whether a point in the world is between the jaws. No errors, no allocation.
bool between_jaws(const ToolShape& shape, const Pose& pose, double jaw, const Vec3& point);

/// Where a straight piece a-b in the world runs between the jaws: the place in [0, 1] of the middle of what is inside;
/// none if it misses. A thread's links may be longer than a jaw is deep, so its nodes alone would slip through.
std::optional<double> between_jaws(const ToolShape& shape, const Pose& pose, double jaw, const Vec3& a, const Vec3& b);

/// How far along the jaws a point in the world is: 0 at the hinge, 1 at the tips; outside [0, 1] beyond them.
double jaw_station(const ToolShape& shape, const Pose& pose, const Vec3& point);

}  // namespace instruments
