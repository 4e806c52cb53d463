#pragma once
#include <cstdint>
#include <vector>

#include "sim/geometry/shapes.hpp"
#include "sim/knot/namer.hpp"

namespace sim::knot {

using geometry::Vec3;

/// A closed polygon per component: the last vertex is joined to the first, none repeats its neighbour.
using Polygons = std::vector<std::vector<Vec3>>;

/// The curve moved and scaled to the unit box about the origin, turned to a fixed general position, and every vertex
/// displaced by about 1e-9 of its size, the same way every time: afterwards no three vertices are in line and no four
/// in a plane but by chance, so that drawings on a grid need no special cases. Type-preserving when strands stay
/// further apart than 1e-8 of the curve's size. Repeated vertices are dropped.
std::vector<std::vector<Vec3>> in_general_position(const std::vector<Component>& components);

/// Splitmix64: numbers without pattern from a counter, the same on every machine.
std::uint64_t mixed(std::uint64_t counter);

/// Unit vector number i of a fixed sequence spread over the sphere.
Vec3 direction(int i);

struct Closed {
    Polygons polygons;
    bool ends_free = true;  ///< Every open end lies on the hull of everything, so that the type is defined.
};

/// Joins the ends of each open component outside everything. An end that is extreme in some direction leaves along it;
/// an end that is not (a buried end) leaves along direction(vote), which may change the type: try several votes.
/// The joining arcs of different components lie on spheres of different size.
Closed close_outside(const std::vector<std::vector<Vec3>>& components, const std::vector<bool>& closed, int vote);

/// Drops vertices whose triangle with their neighbours no other edge meets, until none is left (Koniaris and
/// Muthukumar 1991; Taylor 2000). The type stays. Bounded work: about 1e7 edge tests, then it stops early.
void drop_empty_triangles(Polygons& polygons);

}  // namespace sim::knot
