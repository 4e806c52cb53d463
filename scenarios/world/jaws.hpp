#pragma once
#include <algorithm>
#include <cmath>

#include "instruments/tool.hpp"

// What jaws close on. Private to scenarios/world.
namespace scenarios::world {

using sim::geometry::Vec3;

/// A point of the world [m] in the frame of a tool.
inline Vec3 in_tool(const instruments::ToolInput& tool, const Vec3& world_point) {
    return tool.pose.rotation.conjugate() * (world_point - tool.pose.position);
}

// Between the two, jaws keep what they hold and do not close on more, so that a trembling hand does not chatter.
constexpr double shut_below = 0.25;  ///< Jaws count as shut below this opening (0 to 1).
constexpr double open_above = 0.40;  ///< Jaws count as open above this opening (0 to 1).

//// The room between the jaws, in the tool's frame: between their axes across x, as wide as a jaw across y, from the
/// hinge to the tip along z.
struct JawRoom {
    instruments::Capsule plus;   ///< The jaw towards +x, from hinge to tip [m].
    instruments::Capsule minus;  ///< The jaw towards -x, from hinge to tip [m].

    /// Of a tool of this shape whose jaws are open by `jaw` (0 to 1).
    JawRoom(const instruments::ToolShape& shape, double jaw) {
        const auto parts = instruments::parts_at(shape, {}, jaw);
        plus = parts[instruments::jaw_plus];
        minus = parts[instruments::jaw_minus];
        if (plus.a.z() > plus.b.z()) std::swap(plus.a, plus.b);
        if (minus.a.z() > minus.b.z()) std::swap(minus.a, minus.b);
    }
    /// Where a strand from a to b meets the middle plane y = 0, 0..1 from a.
    static double crossing(const Vec3& a, const Vec3& b) { return a.y() / (a.y() - b.y()); }
    /// Whether a strand from a to b goes through the room from one side to the other.
    bool is_passed_by(const Vec3& a, const Vec3& b) const {
        if ((a.y() < 0) == (b.y() < 0)) return false;
        Vec3 p = a + crossing(a, b) * (b - a);
        p.y() = 0;  // interpolation leaves a rounding error there
        return holds(p, 0);
    }
    /// Where a jaw's axis is at height z, across x [m].
    double axis_x(const instruments::Capsule& jaw, double z) const {
        const double t = std::clamp((z - jaw.a.z()) / (jaw.b.z() - jaw.a.z()), 0.0, 1.0);
        return jaw.a.x() + t * (jaw.b.x() - jaw.a.x());
    }
    /// Whether a point is between the jaws and within `reach_y` [m] of their middle plane.
    bool holds(const Vec3& p, double reach_y) const {
        if (p.z() < plus.a.z() || p.z() > plus.b.z() + plus.radius) return false;
        return std::abs(p.y()) <= reach_y && p.x() <= axis_x(plus, p.z()) && p.x() >= axis_x(minus, p.z());
    }
    /// Half of the gap between the jaws' surfaces at z; not negative.
    double half_gap(double z) const { return std::max(0.0, axis_x(plus, z) - plus.radius); }
};

}  // namespace scenarios::world
