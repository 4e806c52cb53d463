#pragma once
#include <optional>
#include <span>
#include <string>

#include "tissue/mesh.hpp"

namespace tissue {

/// A surface that becomes a wall: its outside stays where it is, the inside follows.
struct WallDef {
    double thickness = 0.5e-3;  ///< How far the inside is from the outside, above 0 [m].
    int through = 2;            ///< Cells through the wall, at least 1.
};

/// A wall, or the first thing wrong with its surface, in words for its author.
struct Wall {
    Mesh mesh;                           ///< Whole where there is no problem.
    std::optional<std::string> problem;  ///< One line; none for a good surface.
};

/// A wall from `triangles` of `vertices` [m], counter-clockwise seen from outside; closed, or open with rims, which
/// become Side::cut. Each is extruded inwards along the normals of its vertices into prisms of three tetrahedra, a cell
/// each. Node `through` of a vertex is the vertex itself, those before it are further in. A problem is: a corner that
/// does not exist or is not finite, a vertex of no triangle, a triangle without area, an edge of more than two
/// triangles, neighbours that face opposite ways, parts that meet in a vertex alone, more than one piece, a wall too
/// thick for where its surface curves inwards, or one that goes through itself. Cost: n log n, where no more than a few
/// are near each other.
Wall make_wall(std::span<const Vec3> vertices, std::span<const std::array<int, 3>> triangles, const WallDef& def);

}  // namespace tissue
