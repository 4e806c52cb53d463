#pragma once
#include <filesystem>
#include <istream>
#include <vector>

#include "assets/mesh.hpp"

namespace assets {

/// One strand of a curve file.
struct CurveComponent {
    std::vector<Vec3> vertices;  ///< [m]. A closed one does not repeat its first vertex at the end.
    std::vector<int> lines;      ///< Line of the file each vertex stands on; 0 where the format has none (.ply).
    bool closed = false;         ///< Its last vertex is joined to its first.
};

/// What a curve file holds.
struct Curve {
    std::filesystem::path file;              ///< As it was named, for messages.
    std::vector<CurveComponent> components;  ///< At least one; each of at least two vertices in different places.

    /// "file:12" or, without line numbers, "file: vertex 12": where an error in a vertex is to be looked for.
    std::string place(int component, int vertex) const;
};

/// Vertices a curve file may have: far beyond any thread, and read in well under a second.
inline constexpr int most_curve_vertices = 200000;

/// Reads a curve written in mm; endings of names in any case. `.csv`, `.xyz`, `.txt` (any other ending too): one vertex
/// `x y z` a line, blanks or commas between, `#` starts a comment, an empty line starts the next component, a last
/// vertex equal to the first closes it.
/// `.obj`: its `l` elements, joined where they share a vertex, in whatever order they stand; `.ply`: its vertices in
/// order, when it has neither faces nor edges.
/// Throws AssetError "file:line:column: error: what is wrong, what would be right".
Curve load_curve(const std::filesystem::path& file);

/// The same of text that comes from anywhere; `name` stands for the file in errors.
Curve read_curve(std::istream& in, const std::filesystem::path& name);

}  // namespace assets
