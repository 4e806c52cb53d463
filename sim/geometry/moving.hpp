#pragma once
#include "sim/geometry/shapes.hpp"

// What moves a thread or a rod during one tick: nodes that somebody holds, and parts of tools.
namespace sim::geometry {

/// A node held by somebody, and where it should be at the end of the tick.
struct Hold {
    int node;
    Vec3 target;           ///< [m]
    Vec3 wanted = target;  ///< Where its tool would have it in the end [m]; what it lacks of that is tension.
    bool slides = false;   ///< Elastic: to `start`, where its tool has it as the tick begins [m], even if tools wait.
    Vec3 start = Vec3::Zero();
};

/// A tool part during one tick: end points move linearly, the radius is that of `from`.
struct MovingCapsule {
    Capsule from, to;
    int owner = 0;  ///< Which tool; a link with both nodes held by the same owner is not tested against it.
};

}  // namespace sim::geometry
