#pragma once
#include <optional>
#include <vector>

#include "sim/knot/namer.hpp"

namespace sim::knot {

/// The same curve about the origin, largest extent 1, repeated vertices dropped and every vertex moved by up to 1e-8:
/// far less than any clearance of a thread, far more than rounding, so that no three vertices stay in line and no four
/// in a plane. Deterministic.
std::vector<Vec3> general_position(const std::vector<Vec3>& curve);

/// A direction in which vertex `end` of the curve lies farther out than every other; none if it is buried. Cost: 6 n.
std::optional<Vec3> outward(const std::vector<Vec3>& curve, size_t end);

/// Joins the ends of an open curve far outside: each leaves along its own direction.
std::vector<Vec3> join_ends(std::vector<Vec3> curve, const Vec3& first, const Vec3& last);

/// Drops vertices of a closed polygon whose triangle no other edge pierces, until none is left to drop: the knot stays
/// the same. [KoniarisMuthukumar1991, Taylor2000]. Cost: about n^2 box tests.
std::vector<Vec3> drop_free_vertices(std::vector<Vec3> polygon);

}  // namespace sim::knot
