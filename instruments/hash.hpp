#pragma once
#include "instruments/tool.hpp"
#include "sim/geometry/hash.hpp"

namespace instruments {

/// Adds position, rotation and opening.
inline void add_to(sim::geometry::Hash& hash, const ToolInput& input) {
    hash.add(input.pose.position, input.pose.rotation.coeffs(), input.jaw);
}

}  // namespace instruments
