#pragma once
#include <array>
#include <filesystem>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/geometry/shapes.hpp"

namespace assets {

using sim::geometry::Vec3;

/// A surface of triangles.
struct Mesh {
    std::vector<Vec3> vertices;                 ///< Corners [m].
    std::vector<std::array<int, 3>> triangles;  ///< Numbers of their corners, counter-clockwise seen from outside.
    std::vector<std::string> mended = {};  ///< What was put right when it was read, a phrase each: "lost 1 sliver".

    /// The triangles by their corners' places [m].
    std::vector<sim::geometry::Triangle> soup() const;
};

/// What is wrong with a file, in one line for its author: "file: what is wrong, what would be right".
struct AssetError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads a triangle mesh (.obj, .ply, .stl, in any case) written in mm; polygons are split, equal corners become one
/// vertex, texture and the like are ignored. It may be open (a board) or closed (a vessel).
/// Mended, and told in Mesh::mended: one that faces inwards, with each rim drawn together, is turned around (sheets may
/// face either way); slivers, triangles no higher than 1e-5 of the mesh's size, are taken out.
/// Throws AssetError: missing, a directory, not readable as a mesh, cut off, no triangle with an area, a corner that is
/// not finite, larger than 1 m or smaller than 0.1 mm, a corner that does not exist, a triangle given twice, an edge of
/// three triangles, neighbours that face opposite ways. Cost: n log n.
Mesh load_mesh(const std::filesystem::path& file);

/// Closed tube (outer and inner wall, end rings) along x, centred at the origin. [m]
/// `around` (at least 3) sides, `along` (at least 1) rings of them; 0 < wall < outer_diameter / 2. The same bits
/// everywhere.
Mesh make_tube(double outer_diameter, double wall, double length, int around, int along);

/// Writes a mesh as .obj text in mm, to the nanometre; `comment` is its first line.
void write_obj(const Mesh& mesh, const std::string& comment, std::ostream& out);

/// Volume inside a closed mesh [m^3]; negative if it faces inwards.
double volume(const Mesh& mesh);

}  // namespace assets
