#pragma once
#include "sim/geometry/vec.hpp"

namespace sim::geometry {

/// All points within `radius` of the segment a-b.
struct Capsule {
    Vec3 a, b;      ///< Ends of the segment [m], world frame.
    double radius;  ///< [m], at least 0.
};

/// A flat piece of a surface.
struct Triangle {
    Vec3 a, b, c;  ///< Corners [m], counter-clockwise seen from outside.
};

/// An axis-aligned box; empty when low > high.
struct Box {
    Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);  ///< Least and largest coordinates [m].

    /// Grows the box until it holds a point [m].
    void include(const Vec3& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    /// Grows the box until it holds another.
    void include(const Box& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    /// The box with `margin` [m] more on every side.
    Box grown(double margin) const { return {low - Vec3::Constant(margin), high + Vec3::Constant(margin)}; }
    /// Whether the two share a point, their sides included.
    bool overlaps(const Box& o) const {
        return (low.array() <= o.high.array()).all() && (o.low.array() <= high.array()).all();
    }
};

}  // namespace sim::geometry
