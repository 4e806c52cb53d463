#include "instruments/tool.hpp"

#include "sim/geometry/portable_math.hpp"

namespace instruments {

// Fine anastomosis forceps: 0.8 mm across the closed tips, tips 5 mm apart when open (2 * 11.8 mm * sin(0.2135)).
// Needle holder of Castroviejo's pattern: 1.2 mm across the closed tips, 20 degrees open.
// Grip: thread tension = 2 * friction * clamp force; a locked needle holder clamps several times harder than fingers.
constexpr ToolShape forceps_shape{1.5e-3, 80e-3, 0.2e-3, 12e-3, 0.427, 1.0};
constexpr ToolShape needle_holder_shape{1.6e-3, 80e-3, 0.3e-3, 10e-3, 0.349, 4.0};
// Spring microscissors of Vannas' pattern: blades of 6 mm that end in tips 0.2 mm across, 25 degrees open.
constexpr ToolShape scissors_shape{1.5e-3, 80e-3, 0.1e-3, 6e-3, 0.436, 0.0};
// Double clamp after Acland: a rail of 5 mm, on which a screw brings the clamps together.
constexpr ToolShape approximator_shape{1.5e-3, 30e-3, 0.4e-3, 20e-3, 0.256, 0.0};

const ToolShape& shape_of(Kind kind) {
    if (kind == Kind::approximator) return approximator_shape;
    if (kind == Kind::scissors) return scissors_shape;
    return kind == Kind::forceps ? forceps_shape : needle_holder_shape;
}

double opening_of(const ToolShape& shape, double jaw) {
    return (shape.jaw_length - shape.jaw_radius) * sim::geometry::portable_sin_cos(0.5 * shape.jaw_opening * jaw).sin;
}

std::array<Capsule, part_count> parts_at(const ToolShape& shape, const Pose& pose, double jaw) {
    const auto world = [&](double x, double z) -> Vec3 { return pose.position + pose.rotation * Vec3(x, 0, z); };
    const auto [sin, cos] = sim::geometry::portable_sin_cos(0.5 * shape.jaw_opening * jaw);

    // Each jaw turns about its own base, one radius off the axis: closed, the jaws touch along their whole length, and
    // at no opening do they overlap. The tip's centre is a radius short of the tip.
    const double r = shape.jaw_radius, hinge = -shape.jaw_length, reach = shape.jaw_length - r;
    const auto jaw_at = [&](double side) -> Capsule {
        return {world(side * r, hinge), world(side * (r + reach * sin), hinge + reach * cos), r};
    };
    // The shaft ends in a hemisphere that fills the root of the jaws: no thread can slip behind the hinge.
    const double front = hinge - shape.shaft_radius;
    return {Capsule{world(0, front - shape.shaft_length), world(0, front), shape.shaft_radius}, jaw_at(1), jaw_at(-1)};
}

double distance_between(const Pose& from, const Pose& to, double arm) {
    const double turn = 2 * (from.rotation.conjugate() * to.rotation).vec().norm();
    return (to.position - from.position).norm() + turn * arm;
}

Pose between(const Pose& from, const Pose& to, double t) {
    if (t <= 0) return from;
    if (t >= 1) return to;  // to the last bit, so that a motion that was not stopped ends where it was asked to
    return {from.position + t * (to.position - from.position),
            sim::geometry::portable_slerp(from.rotation, to.rotation, t)};
}

}  // namespace instruments
