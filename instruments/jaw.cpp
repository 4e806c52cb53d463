#include "instruments/jaw.hpp"

#include <algorithm>
#include <array>

namespace instruments {

JawGap jaw_gap(const ToolShape& shape, double jaw) {
    const Capsule side = parts_at(shape, {}, jaw)[jaw_plus];
    return {side.a.z(), side.b.z(), side.a.x(), side.b.x(), shape.jaw_radius};
}

static Vec3 to_tool(const Pose& pose, const Vec3& point) {
    return pose.rotation.conjugate() * (point - pose.position);
}

// How far inside each of the six faces a point of the tool's frame is; negative outside.
static std::array<double, 6> depths(const JawGap& gap, const Vec3& p) {
    const double slope = (gap.tip_half_width - gap.hinge_half_width) / (gap.tip_z - gap.hinge_z);
    const double half_width = gap.hinge_half_width + slope * (p.z() - gap.hinge_z);
    return {p.z() - gap.hinge_z, gap.tip_z - p.z(),      half_width - p.x(),
            half_width + p.x(),  gap.half_depth - p.y(), gap.half_depth + p.y()};
}

bool between_jaws(const ToolShape& shape, const Pose& pose, double jaw, const Vec3& point) {
    return between_jaws(shape, pose, jaw, point, point).has_value();
}

std::optional<double> between_jaws(const ToolShape& shape, const Pose& pose, double jaw, const Vec3& a, const Vec3& b) {
    const JawGap gap = jaw_gap(shape, jaw);
    const auto at_a = depths(gap, to_tool(pose, a)), at_b = depths(gap, to_tool(pose, b));
    double enter = 0, leave = 1;
    for (std::size_t i = 0; i < at_a.size(); ++i) {  // depth is linear along the piece: clip it at each face
        if (at_a[i] < 0 && at_b[i] < 0) return {};
        const double cross = at_a[i] / (at_a[i] - at_b[i]);
        if (at_a[i] < 0) enter = std::max(enter, cross);
        if (at_b[i] < 0) leave = std::min(leave, cross);
    }
    if (enter > leave) return {};
    return 0.5 * (enter + leave);
}

double jaw_station(const ToolShape& shape, const Pose& pose, const Vec3& point) {
    return (to_tool(pose, point).z() + shape.jaw_length) / shape.jaw_length;
}

}  // namespace instruments
