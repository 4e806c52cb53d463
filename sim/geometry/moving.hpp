#pragma once
#include "sim/geometry/shapes.hpp"

// What moves a thread or a rod during one tick: nodes that somebody holds, and parts of tools.
namespace sim::geometry {

/// A node held by somebody, and where it should be at the end of the tick.
struct Hold {
    int node;                   ///< Counted along the thread from 0.
    Vec3 target;                ///< Where the node should be at the end of the tick [m].
    Vec3 wanted = target;       ///< Where its tool would have it in the end [m]; what it lacks of that is tension.
    bool slides = false;        ///< Elastic: whether the node goes to `start` first, even if tools wait.
    Vec3 start = Vec3::Zero();  ///< Elastic, where it slides: where its tool has it as the tick begins [m].
};

/// A tool part during one tick: end points move linearly, the radius is that of `from`.
struct MovingCapsule {
    Capsule from, to;  ///< Where the part is as the tick begins and as it ends.
    int owner = 0;     ///< Number of its tool; a link with both nodes held by the same owner is not tested against it.
};

}  // namespace sim::geometry
