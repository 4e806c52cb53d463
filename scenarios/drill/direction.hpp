#pragma once
#include <cmath>

#include "sim/geometry/vec.hpp"

namespace scenarios::drill {

/// Whether a vector, of whatever length, can be made a unit one: its squared length neither underflows nor overflows.
inline bool has_direction(const sim::geometry::Vec3& v) {
    return std::isnormal(v.squaredNorm());
}

}  // namespace scenarios::drill
