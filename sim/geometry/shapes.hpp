#pragma once
#include "sim/geometry/vec.hpp"

namespace sim::geometry {

/// All points within `radius` of the segment a-b. World frame, [m].
struct Capsule {
    Vec3 a, b;
    double radius;
};

struct Triangle {
    Vec3 a, b, c;  ///< Counter-clockwise seen from outside. [m]
};

/// Axis-aligned box; empty when low > high.
struct Box {
    Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);

    void include(const Vec3& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    void include(const Box& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    Box grown(double margin) const { return {low - Vec3::Constant(margin), high + Vec3::Constant(margin)}; }
    bool overlaps(const Box& o) const {
        return (low.array() <= o.high.array()).all() && (o.low.array() <= high.array()).all();
    }
};

}  // namespace sim::geometry
