#pragma once
#include <vector>

#include "sim/knot/diagram.hpp"

namespace sim::knot {

/// Entry k counts the homomorphisms of the knot group to PSL(2,7) that send the base meridian to a fixed x of order 7
/// and the longitude to x^k [Eisermann2007, arXiv 0707.3895]. Right-handed trefoil: 1 7 0 0 0 0 0. Tells apart what
/// HOMFLY confuses up to 10 crossings, the two hands of 10_48 excepted. Depends on the direction of travel for some
/// knots.
using Colours = std::vector<int>;

/// One component. Cost: 24 to the number of bridges less one.
Colours colours(const Diagram& knot);

}  // namespace sim::knot
