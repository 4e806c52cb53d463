#pragma once
#include <optional>

#include "sim/knot/diagram.hpp"
#include "sim/knot/polynomial.hpp"

namespace sim::knot {

/// What a name may cost, in squared crossings of the diagrams visited: some tens of milliseconds in all.
struct Work {
    long left = 200000;
    void spend_on(const Diagram& diagram) { left -= static_cast<long>(diagram.crossings()) * diagram.crossings(); }
    bool is_spent() const { return left < 0; }
};

/// HOMFLY polynomial P(v, z): v^-1 P(L+) - v P(L-) = z P(L0), P(unknot) = 1. Strands are oriented as listed.
/// Nothing when that would take more work than is left: the bound that keeps a simulation from being held up.
/// Method: skein recursion towards descending diagrams, each diagram first freed of curls and bigons, with memory.
std::optional<Polynomial> homfly(const Diagram& diagram, Work& work);

}  // namespace sim::knot
