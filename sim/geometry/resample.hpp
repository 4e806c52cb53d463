#pragma once
#include <span>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace sim::geometry {

/// Resamples a path to `links` links of equal length along it; the last node is the path's end. Path of at least 2
/// points. O(points + links).
std::vector<Vec3> resample(std::span<const Vec3> path, int links);

}  // namespace sim::geometry
