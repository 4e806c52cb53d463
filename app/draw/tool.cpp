#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/draw/surface.hpp"

namespace app::draw {
namespace {

using instruments::Kind;
using instruments::ToolShape;
using sim::geometry::Capsule;

/// A solid along +z: at height z an outline of half widths x and y; sharper is squarer (2 is an ellipse).
struct Slice {
    double z, minus_x, plus_x, y;
};

std::vector<Vec3> outline(const Slice& slice, double sharpness, int around) {
    std::vector<Vec3> points;
    for (int k = 0; k < around; ++k) {
        const double angle = 2 * std::numbers::pi * k / around, c = std::cos(angle), s = std::sin(angle);
        const auto power = [&](double x) { return std::copysign(std::pow(std::abs(x), 2 / sharpness), x); };
        points.emplace_back(power(c) * (c < 0 ? slice.minus_x : slice.plus_x), power(s) * slice.y, slice.z);
    }
    return points;
}

assets::Mesh solid(const std::vector<Slice>& slices, double first_z, double last_z, double sharpness, bool fine) {
    std::vector<std::vector<Vec3>> rings;
    for (const Slice& slice : slices) rings.push_back(outline(slice, sharpness, fine ? 32 : 12));
    return loft({0, 0, first_z}, rings, {0, 0, last_z});
}

/// Outer surface of the round shaft: front hemisphere true to its capsule, grooves for the fingers, a rounded end.
assets::Mesh shaft_of(const ToolShape& shape, bool fine) {
    const double r = shape.shaft_radius, length = shape.shaft_length;
    std::vector<Slice> slices;
    const auto add = [&](double z, double radius) { slices.push_back({z, radius, radius, radius}); };
    const int cap = fine ? 8 : 3, steps = fine ? 8 : 2;  // of a quarter turn; of a groove
    for (int i = cap - 1; i > 0; --i)
        add(-r * std::sin(std::numbers::pi / 2 * i / cap), r * std::cos(std::numbers::pi / 2 * i / cap));
    add(0, r);
    const double pitch = 0.8 * r, first = 0.18 * length;
    for (int groove = 0; groove < 12; ++groove)
        for (int i = 0; i <= steps; ++i)
            add(first + pitch * (groove + 0.8 * i / steps),
                r * (1 - 0.1 * std::pow(std::sin(std::numbers::pi * i / steps), 2)));
    for (int i = 0; i < cap; ++i)
        add(length + r * std::sin(std::numbers::pi / 2 * i / cap), r * std::cos(std::numbers::pi / 2 * i / cap));
    // Built from the tail forwards, so that +z is the way the tool points.
    for (Slice& slice : slices) slice.z = -slice.z;
    std::reverse(slices.begin(), slices.end());
    return solid(slices, -length - r, r, 2, fine);
}

/// Jaw from a little inside the shaft (z < 0) to its tip, its mate on the -x side.
assets::Mesh jaw_of(const ToolShape& shape, double root, double sharpness, bool fine) {
    const double r = shape.jaw_radius, reach = shape.jaw_length - r;
    std::vector<Slice> slices;
    for (int i = -2; i <= 24; i += fine ? 1 : 4) {
        const double s = i / 24.0, extra = root * std::pow(1 - std::max(s, 0.0), 2.5);
        slices.push_back({s * reach, r, r * (1 + extra), r * (1 + extra)});
    }
    const int cap = fine ? 6 : 2;
    if (!fine) slices.push_back({reach, r, r, r});
    for (int i = 1; i < cap; ++i) {
        const double c = r * std::cos(std::numbers::pi / 2 * i / cap);
        slices.push_back({reach + r * std::sin(std::numbers::pi / 2 * i / cap), c, c, c});
    }
    return solid(slices, slices.front().z, reach + r, sharpness, fine);
}

assets::Mesh pin_of(const ToolShape& shape, bool fine) {
    const double r = shape.shaft_radius, half = 0.98 * r, radius = 0.3 * r, chamfer = 0.06 * r;
    const auto slice = [](double z, double width) { return Slice{z, width, width, width}; };
    return solid({slice(-half, radius - chamfer), slice(chamfer - half, radius), slice(half - chamfer, radius),
                  slice(half, radius - chamfer)},
                 -half, half, 2, fine);
}

/// Frame of a capsule: from a, z towards b, y the tool's, x outwards.
Eigen::Isometry3d frame(const Vec3& origin, const Capsule& capsule, const Vec3& y) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    const Vec3 z = (capsule.b - capsule.a).normalized();
    pose.linear() << y.cross(z), y, z;
    pose.translation() = origin;
    return pose;
}

}  // namespace

assets::Mesh tool_part(Kind kind, ToolPart part, bool fine) {
    const ToolShape& shape = instruments::shape_of(kind);
    const bool slim = kind == Kind::forceps;
    switch (part) {
        case ToolPart::shaft:
            return shaft_of(shape, fine);
        case ToolPart::pin:
            return pin_of(shape, fine);
        case ToolPart::jaw:
            return jaw_of(shape, slim ? 1.6 : 1.2, slim ? 2.6 : 3.2, fine);
    }
    return {};
}

std::vector<PlacedPart> placed_parts(const ToolPicture& picture) {
    const ToolShape& shape = instruments::shape_of(picture.kind);
    const auto parts = instruments::parts_at(shape, picture.pose, picture.jaw);
    const Vec3 y = picture.pose.rotation * Vec3::UnitY();
    const Capsule &shaft = parts[instruments::shaft], &plus = parts[instruments::jaw_plus],
                  &minus = parts[instruments::jaw_minus];
    const Eigen::AngleAxisd half_turn(std::numbers::pi, Vec3::UnitZ()), upright(std::numbers::pi / 2, Vec3::UnitX());
    const Eigen::Isometry3d front = frame(shaft.b, shaft, y);
    return {{ToolPart::shaft, front},
            {ToolPart::pin, front * Eigen::Translation3d(0, 0, 0.45 * shape.shaft_radius) * upright},
            {ToolPart::jaw, frame(plus.a, plus, y)},
            {ToolPart::jaw, frame(minus.a, minus, y) * half_turn}};
}

}  // namespace app::draw
