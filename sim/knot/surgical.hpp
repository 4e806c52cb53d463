#pragma once
#include <vector>

#include "sim/knot/identify.hpp"

namespace sim::knot {

/// Reads throws, their order, their form and the surgeon's name of an open strand (in general position) whose type is
/// known, into `name`. Leaves it empty when the strand is not a stack of throws. `few`: the same strand, reduced().
///
/// A throw of n turns is the torus knot T(2, 2n + 1) of its hand and throws add up, so the type gives the throws; their
/// order comes from the types of stretches that grow from the middle of the loop, the form from how unevenly the two
/// strands bend (docs/knots.md).
void read_surgical(const std::vector<Vec3>& strand, const std::vector<Vec3>& few, const Identity& whole, Work& work,
                   Name& name);

}  // namespace sim::knot
