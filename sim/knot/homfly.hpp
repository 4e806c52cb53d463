#pragma once
#include <optional>

#include "sim/knot/diagram.hpp"
#include "sim/knot/polynomial.hpp"

namespace sim::knot {

/// HOMFLY polynomial P(v, z): v^-1 P(L+) - v P(L-) = z P(L0), P(unknot) = 1. Strands are oriented as listed.
/// Nothing when the work, the squared crossings of the diagrams visited, would exceed `most_work` (a million takes some
/// ten milliseconds): the bound that keeps a simulation from being held up.
/// Method: skein recursion towards descending diagrams, each diagram first freed of curls and bigons, with memory.
std::optional<Polynomial> homfly(const Diagram& diagram, long most_work = 1000000);

}  // namespace sim::knot
