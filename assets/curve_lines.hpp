#pragma once
#include "assets/curve.hpp"

namespace assets {

/// The lines of an .obj, or the vertices of a .ply without faces and edges in their order, through assimp. Vertices
/// [m]. Throws AssetError.
std::vector<CurveComponent> read_lines(const std::filesystem::path& file);

}  // namespace assets
