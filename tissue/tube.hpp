#pragma once
#include <optional>
#include <string>

#include "tissue/mesh.hpp"

namespace tissue {

/// One end of a cut vessel, by numbers. Along x from its cut, whose centre is the origin, to its far end at x = length.
struct TubeDef {
    double diameter = 4e-3;  ///< Outer [m].
    double wall = 0.5e-3;    ///< [m], below half of the diameter.
    double length = 8e-3;    ///< Along the axis [m].
    /// Between cut and axis [degrees], 45 to 90; slanted, the cut leans towards the far end where y > 0.
    double cut_angle = 90;
    int around = 16;            ///< Cells around, even, at least 6.
    int through = 2;            ///< Cells through the wall, at least 1.
    int near = 8;               ///< Equal cells along the axis next to the cut, at least 1.
    double near_length = 4e-3;  ///< How far they reach from the cut [m].
    int far = 4;                ///< Cells from there to the far end, each longer than the last by the same factor.
};

/// The first thing wrong with `def`, in words for its author; nothing when there is such a tube.
std::optional<std::string> problem_with(const TubeDef& def);

/// A tube of cells of six tetrahedra each, mirrored from cell to cell, so that a tube has no sense of turning. Corners
/// lie so far out that the tube's sections have the area of the ring between two circles, and its volume is the
/// cylinder's. The same bits everywhere.
Mesh make_tube(const TubeDef& def);

/// A box of so many cubes of `edge` [m] each way from the origin; all of its surface counts as outer.
Mesh make_box(std::array<int, 3> counts, double edge);

}  // namespace tissue
