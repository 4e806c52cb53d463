#pragma once
#include "assets/mesh.hpp"

namespace assets {

/// Takes slivers out of a mesh, triangles that are no higher than `tolerance` [m], and leaves no hole where they were.
/// Corners nearer than that along an edge become one. A triangle that lies along its longest edge goes by a flip of
/// that edge, or alone where the edge is on a rim. Vertices that no triangle has any more are left out.
/// Returns how many slivers there were. Cost: n log n.
int take_out_slivers(Mesh& mesh, double tolerance);

}  // namespace assets
