#pragma once
#include <filesystem>
#include <vector>

#include "assets/mesh.hpp"

namespace assets {

/// One piece of thread or one core.
struct Curve {
    std::vector<Vec3> vertices;  ///< [m]. At least 2; at least 3 if closed. The first is not repeated at the end.
    bool closed = false;         ///< Its last vertex is joined to its first.
};

/// Reads a curve file (.csv, .xyz, .txt): a vertex "x y z" in mm a line, separated by blanks or commas; '#' starts a
/// comment; a blank line starts the next component; a component whose last vertex repeats its first is closed.
/// Throws AssetError, "file:line: error: what": not a readable text file, a line that is not three finite numbers, no
/// vertex, a component of fewer than 2 different vertices. Cost: linear.
std::vector<Curve> load_curves(const std::filesystem::path& file);

}  // namespace assets
