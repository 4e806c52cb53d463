#pragma once
#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/geometry/shapes.hpp"

namespace assets {

using sim::geometry::Vec3;

struct Mesh {
    std::vector<Vec3> vertices;                 ///< [m]
    std::vector<std::array<int, 3>> triangles;  ///< Counter-clockwise seen from outside.

    std::vector<sim::geometry::Triangle> soup() const;
};

/// What is wrong with a file, in one line for its author: "file: what is wrong, what would be right".
struct AssetError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads a triangle mesh (.obj, .ply, .stl) written in mm. Throws AssetError: missing, a directory, no triangles,
/// non-finite vertices, larger than 1 m, degenerate or inverted ...
Mesh load_mesh(const std::filesystem::path& file);

/// Closed tube (outer and inner wall, end rings) along x, centred at the origin. [m]
Mesh make_tube(double outer_diameter, double wall, double length, int around, int along);

}  // namespace assets
