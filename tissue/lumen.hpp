#pragma once
#include <optional>

#include "tissue/rim.hpp"
#include "tissue/skin.hpp"

namespace tissue {

/// Area of what a plane cuts out of the lumen within these inner faces [m^2], or nothing where its outline does not
/// close. Several outlines count together.
std::optional<double> section_area(std::span<const Face> inner, std::span<const Vec3> nodes, const Vec3& point,
                                   const Vec3& normal);

/// A vessel's axis as it points away from a cut.
struct Axis {
    Vec3 rest;  ///< At rest, unit.
    Vec3 now;   ///< As the wall within a diameter of the cut carries it along, by the affine map that fits best; unit.
};
/// The axis at the cut with this inner rim, of a vessel whose `axis` (unit, either way) is known at rest. `nodes`: the
/// wall's now [m].
Axis axis_at(const Rim& inner, const Mesh& rest, std::span<const Vec3> nodes, const Vec3& axis);

/// Least area of the lumen next to a cut over what it is there at rest: of its inner rim, and of sections across the
/// axis up to a diameter from there, a sixteenth of that apart. Sections that do not close are left out, as next to a
/// slanted cut. The rim needs to have an area.
double lumen_ratio(const Rim& inner, const Mesh& rest, std::span<const Vec3> nodes, const Vec3& axis);

/// How deep a point is in the lumen of either of two vessels whose ends meet: its distance to the nearest of both skins
/// where that is an inner side which looks at it, and 0 elsewhere or beyond `reach` [m]. Off an open end it counts as
/// long as it is not further beyond than above the wall.
double depth_in_lumen(const Vec3& point, const Skin& a, const Skin& b, double reach);

}  // namespace tissue
