#pragma once
#include <array>

#include "instruments/tool.hpp"
#include "sim/geometry/arc.hpp"

namespace instruments {

using sim::geometry::Arc;

/// An arc in the world's frame, given in the frame of a tool with this pose.
Arc into_tool(const Arc& needle, const Pose& tool);
/// An arc in the frame of a tool with this pose, given in the world's frame.
Arc out_of_tool(const Arc& needle, const Pose& tool);

/// Bending moment [N m] beyond which a needle whose wire has this radius [m] stays bent: yield stress times the
/// section's modulus, pi r^3 / 4. Hard-drawn stainless steel yields at some 1.8 GPa (from memory).
double yield_moment(double wire);

constexpr int needle_parts = 16;  ///< How many capsules stand for a needle.

/// The needle as straight capsules, from its tail, where the first ends round, to its tip [m]; their middles are off
/// the arc by a fourteenth of the wire's thickness at most.
std::array<Capsule, needle_parts> parts_of(const Arc& needle);

}  // namespace instruments
