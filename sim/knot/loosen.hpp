#pragma once
#include "sim/knot/diagram.hpp"
#include "sim/knot/homfly.hpp"

namespace sim::knot {

/// Lays stretches elsewhere with as many crossings as before, breadth first, until simplify() takes crossings away;
/// false when none of the first 60 diagrams reached does. For what simplify() leaves.
bool loosen(Diagram& diagram, Work& work);

}  // namespace sim::knot
