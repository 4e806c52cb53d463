#pragma once
#include <array>

#include "instruments/tool.hpp"
#include "sim/geometry/arc.hpp"

namespace instruments {

using sim::geometry::Arc;

/// The same arc seen from a tool, and one seen from a tool in the world.
Arc into_tool(const Arc& needle, const Pose& tool);
Arc out_of_tool(const Arc& needle, const Pose& tool);

/// Bending moment [N m] beyond which a needle of this wire, by its radius [m], stays bent: yield times the section's
/// modulus, pi r^3 / 4. Hard-drawn stainless steel gives way at some 1.8 GPa (from memory).
double yield_moment(double wire);

/// Straight ones, the first of which ends round at the tail; their middles are off the arc by a fourteenth of the
/// wire's thickness at most.
constexpr int needle_parts = 16;
std::array<Capsule, needle_parts> parts_of(const Arc& needle);

}  // namespace instruments
