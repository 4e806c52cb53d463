#pragma once
#include <span>
#include <string>

#include "sim/geometry/arc.hpp"

namespace scenarios::drill {

/// A curved needle as makers sell it: a part of a circle, its length along the curve, its wire. Values of reference C2,
/// of a taper point.
struct NeedleCode {
    const char* name;  ///< As drill files have it.
    double circle;     ///< Share of a whole circle that the curve makes, 0..1.
    double length;     ///< Length along the curve [m].
    double wire;       ///< Diameter of the wire [m].
};

/// All needles that a drill file may name.
std::span<const NeedleCode> needle_codes();
/// The needle of that name, which must be one of needle_codes().
const NeedleCode& needle_named(const std::string& name);

/// A needle of that code from its tail, towards where its tip is, bulging to one side of the line between. `towards`
/// and `bulge`: any lengths but zero, not parallel.
sim::geometry::Arc needle_at(const NeedleCode& code, const sim::geometry::Vec3& tail,
                             const sim::geometry::Vec3& towards, const sim::geometry::Vec3& bulge);

}  // namespace scenarios::drill
