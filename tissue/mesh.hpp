#pragma once
#include <array>
#include <span>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace tissue {

using sim::geometry::Vec3;

/// Which part of a wall's surface a face belongs to.
enum class Side { outer, inner, cut, far_end };

/// A triangle of a wall's surface.
struct Face {
    std::array<int, 3> nodes;  ///< Counter-clockwise seen from outside the wall.
    Side side;                 ///< Which part of the surface it belongs to.
};

/// Four nodes.
using Tetrahedron = std::array<int, 4>;

/// A wall of tetrahedra, as it is when nothing pulls at it.
struct Mesh {
    std::vector<Vec3> nodes;              ///< Where they are at rest [m].
    std::vector<Tetrahedron> tetrahedra;  ///< Of positive volume().
    /// Cell c is tetrahedra cells[c] to cells[c + 1] - 1: one hexahedron of a tube, one prism of a wall. A cell keeps
    /// its volume as a whole, for a linear tetrahedron that keeps its own can hardly move (it locks).
    std::vector<int> cells{0};
    std::vector<Face> faces;  ///< All of the surface.
};

/// Volume of a tetrahedron [m^3]; negative when it is turned inside out.
inline double volume(const Tetrahedron& tet, std::span<const Vec3> nodes) {
    const auto at = [&](std::size_t k) -> const Vec3& { return nodes[static_cast<std::size_t>(tet[k])]; };
    return (at(1) - at(0)).dot((at(2) - at(0)).cross(at(3) - at(0))) / 6;
}

/// Whether a point [m] is in any of these tetrahedra. 15 us for 2300 that it is next to, 1 us where it is not in the
/// box about all nodes.
bool is_in_wall(std::span<const Tetrahedron> tetrahedra, std::span<const Vec3> nodes, const Vec3& point);

/// A point that moves with the wall.
struct MaterialPoint {
    int tetrahedron = 0;                                    ///< Which it is in.
    std::array<double, 4> weights{0.25, 0.25, 0.25, 0.25};  ///< Barycentric, of its corners; their sum is 1.
};

/// Where a point of the wall is when the mesh has its nodes here [m].
inline Vec3 position(const MaterialPoint& point, const Mesh& mesh, std::span<const Vec3> nodes) {
    const Tetrahedron& tet = mesh.tetrahedra[static_cast<std::size_t>(point.tetrahedron)];
    Vec3 at = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) at += point.weights[k] * nodes[static_cast<std::size_t>(tet[k])];
    return at;
}

}  // namespace tissue
