#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/geometry/shapes.hpp"
#include "sim/knot/namer.hpp"

namespace sim::knot {

using geometry::Vec3;

/// A polygon per component, none of whose vertices repeats its neighbour. In a closed one the last is joined to the
/// first.
using Polygons = std::vector<std::vector<Vec3>>;

/// The curve moved and scaled to the unit box about the origin, turned to a fixed general position, and every vertex
/// displaced by about 1e-9 of its size, the same way every time: afterwards no three vertices are in line and no four
/// in a plane but by chance, so that drawings on a grid need no special cases. Type-preserving when strands stay
/// further apart than 1e-8 of the curve's size. Repeated vertices are dropped.
Polygons in_general_position(const std::vector<Component>& components);

/// Splitmix64: numbers without pattern from a counter, the same on every machine.
std::uint64_t mixed(std::uint64_t counter);

/// Unit vector number i of a fixed sequence spread over the sphere.
Vec3 direction(int i);

/// Where the ends of a strand can leave without crossing anything: directions in which an end is the outermost point of
/// everything. Nothing for an end that is buried inside the hull.
struct Ways {
    std::optional<Vec3> from_first, from_last;  ///< Unit vectors from the first vertex and from the last.
};

/// The ways out of each open component; a closed one has none. Cost: up to 300 vertices of all for an end that is
/// buried, some for one that is not.
std::vector<Ways> ways_out(const Polygons& components, const std::vector<bool>& closed);

/// Whether every open end is free, so that the type is defined.
bool all_free(const std::vector<Ways>& ways, const std::vector<bool>& closed);

/// Joins the ends of each open component outside everything. An end without a way out leaves along direction(vote),
/// which may change the type: try several votes. The joining arcs of different components lie on spheres of different
/// size. `other_way`: the first open one is joined along the longer of the two great arcs. Where several components are
/// open that is another type, and the better one when its ends leave nearly opposite to each other.
Polygons close_outside(const Polygons& components, const std::vector<bool>& closed, const std::vector<Ways>& ways,
                       int vote, bool other_way = false);

/// Whether several components are open, and the ends of the first point or leave so opposite to each other (more than
/// 120 degrees) that neither way of joining them is plainly the one.
bool either_way(const Polygons& components, const std::vector<bool>& closed, const std::vector<Ways>& ways);

/// Drops vertices whose triangle with their neighbours no other edge meets, until none is left (Koniaris and
/// Muthukumar 1991; Taylor 2000). The type stays. `pinned`: of each polygon, whether its first and last vertex stay;
/// none when empty. Bounded work: about 1e7 edge tests, then it stops early.
void drop_empty_triangles(Polygons& polygons, const std::vector<bool>& pinned = {});

constexpr int most_votes = 24;  ///< Ways tried to lead out a buried end.

/// The components with fewer vertices, open ones with their ends: close_outside with any of the first `votes` votes
/// gives the types that it gave.
Polygons reduced(const Polygons& components, const std::vector<bool>& closed, const std::vector<Ways>& ways, int votes);

}  // namespace sim::knot
