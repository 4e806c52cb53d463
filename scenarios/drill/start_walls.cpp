#include "scenarios/drill/start_walls.hpp"

#include <cmath>

#include "sim/geometry/portable_math.hpp"

namespace scenarios::drill {

namespace {

using world::Vec3;
using world::VesselDef;

// As far from its middle as all of the tube's round goes: an oblique cut takes from one side what it leaves on the
// other [m].
double whole_half(const VesselDef& vessel) {
    const auto [sin, cos] = sim::geometry::portable_sin_cos(vessel.cut_angle / 180 * EIGEN_PI);
    return vessel.length / 2 - vessel.diameter / 2 * cos / sin;
}

bool is_in(const Vec3& point, const VesselDef& vessel, double margin) {
    const Vec3 from = point - vessel.centre;
    const double along = from.dot(vessel.axis), out = (from - along * vessel.axis).norm(), outer = vessel.diameter / 2;
    return std::abs(along) < whole_half(vessel) && out < outer + margin && out > outer - vessel.wall - margin;
}

// The cylinder of a of that radius.
bool lies_in(const VesselDef& a, double radius, const VesselDef& b) {
    constexpr int around = 32, a_diameter = 8;
    const double half = whole_half(a);
    const Vec3 x = a.axis.unitOrthogonal(), y = a.axis.cross(x);
    const int steps = 1 + static_cast<int>(2 * half / a.diameter * a_diameter);
    for (int i = 0; i <= steps; ++i)
        for (int k = 0; k < around; ++k) {
            const auto [sin, cos] = sim::geometry::portable_sin_cos(2 * EIGEN_PI * k / around);
            if (is_in(a.centre + half * (2.0 * i / steps - 1) * a.axis + radius * (cos * x + sin * y), b, 0))
                return true;
        }
    return false;
}

}  // namespace

bool is_in_wall(const sim::geometry::Arc& needle, const VesselDef& vessel) {
    if (!vessel.mesh_file.empty()) return false;
    const int steps = 1 + static_cast<int>(needle.length() / needle.wire);  // none is stepped over that it goes through
    for (int i = 0; i <= steps; ++i)
        if (is_in(needle.at(needle.length() * i / steps), vessel, needle.wire)) return true;
    return false;
}

bool are_in_each_other(const VesselDef& a, const VesselDef& b) {
    const auto outside_or_middle = [](const VesselDef& of, const VesselDef& in) {
        return lies_in(of, of.diameter / 2, in) || lies_in(of, (of.diameter - of.wall) / 2, in);
    };
    return a.mesh_file.empty() && b.mesh_file.empty() && (outside_or_middle(a, b) || outside_or_middle(b, a));
}

}  // namespace scenarios::drill
