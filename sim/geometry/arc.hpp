#pragma once
#include "sim/geometry/portable_math.hpp"

namespace sim::geometry {

/// A needle's shape: wire of round section bent to a circle's arc, from its tail, where the thread is, to its tip.
/// World frame.
struct Arc {
    Vec3 centre = Vec3::Zero();    ///< Centre of the circle [m].
    Vec3 to_tail = Vec3::UnitX();  ///< Direction from the centre to the tail, unit.
    Vec3 onwards = Vec3::UnitY();  ///< Direction in which the wire leaves its tail, unit, perpendicular to to_tail.
    double radius = 3.95e-3;       ///< Radius of the circle, to the middle of the wire [m].
    double angle = 2.356;          ///< Angle from tail to tip [rad], below a whole turn.
    double wire = 0.1e-3;          ///< Radius of the wire's section [m].

    /// Length of the wire along the circle [m].
    double length() const { return radius * angle; }
    /// The middle of the wire [m], `along` metres from the tail.
    Vec3 at(double along) const {
        const SinCos turn = portable_sin_cos(along / radius);
        return centre + radius * (turn.cos * to_tail + turn.sin * onwards);
    }
    /// Direction of the wire towards the tip, unit, `along` metres from the tail.
    Vec3 tangent(double along) const {
        const SinCos turn = portable_sin_cos(along / radius);
        return turn.cos * onwards - turn.sin * to_tail;
    }
    /// The same needle with its tail further back along the circle by `by` [m].
    Arc longer(double by) const {
        const SinCos turn = portable_sin_cos(by / radius);
        Arc arc = *this;
        arc.to_tail = turn.cos * to_tail - turn.sin * onwards;
        arc.onwards = turn.sin * to_tail + turn.cos * onwards;
        arc.angle += by / radius;
        return arc;
    }
    /// The middle of the wire at the tail [m].
    Vec3 tail() const { return centre + radius * to_tail; }
    /// The middle of the wire at the tip [m].
    Vec3 tip() const { return at(length()); }
};

}  // namespace sim::geometry
