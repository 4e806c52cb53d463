#pragma once
#include "assets/curve.hpp"

namespace assets {

/// The strands that the `l` elements of an .obj make, each with its vertices [m] in the order they are passed in.
/// Edges that share a vertex, by its number or its place, are joined in whatever order and direction they stand.
/// Throws AssetError: no line, a face, a vertex that does not exist, one where more than two edges meet.
std::vector<CurveComponent> read_obj_lines(const std::filesystem::path& file);

/// The vertices of a .ply without faces and edges, in their order: one strand, through assimp. Throws AssetError.
std::vector<CurveComponent> read_ply_points(const std::filesystem::path& file);

}  // namespace assets
