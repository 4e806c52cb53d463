#pragma once
#include <algorithm>

#include "instruments/tool.hpp"

namespace scenarios::world {

using sim::geometry::Vec3;

/// The room between the jaws, in the tool's frame: between their axes across x, as wide as a jaw across y, from the hinge to the tip along z.
struct JawRoom {
    instruments::Capsule plus, minus;

    JawRoom(const instruments::ToolShape& shape, double jaw) {
        const auto parts = instruments::parts_at(shape, {}, jaw);
        plus = parts[instruments::jaw_plus];
        minus = parts[instruments::jaw_minus];
        if (plus.a.z() > plus.b.z()) std::swap(plus.a, plus.b);
        if (minus.a.z() > minus.b.z()) std::swap(minus.a, minus.b);
    }
    double axis_x(const instruments::Capsule& jaw, double z) const {
        const double t = std::clamp((z - jaw.a.z()) / (jaw.b.z() - jaw.a.z()), 0.0, 1.0);
        return jaw.a.x() + t * (jaw.b.x() - jaw.a.x());
    }
    bool holds(const Vec3& p, double reach_y) const {
        if (p.z() < plus.a.z() || p.z() > plus.b.z() + plus.radius) return false;
        return std::abs(p.y()) <= reach_y && p.x() <= axis_x(plus, p.z()) && p.x() >= axis_x(minus, p.z());
    }
    /// Half of the gap between the jaws' surfaces at z; not negative.
    double half_gap(double z) const { return std::max(0.0, axis_x(plus, z) - plus.radius); }
};

}  // namespace scenarios::world
