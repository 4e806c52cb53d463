#pragma once
#include <optional>

#include "sim/knot/diagram.hpp"
#include "sim/knot/polynomial.hpp"

namespace sim::knot {

/// What a name may cost: some tens of milliseconds in all. Measured: a diagram visited in the skein costs by the square
/// of its crossings, one that is simplified a hundredth of their cube.
struct Work {
    double left = 200000;  ///< What may still be spent; negative: it is spent.
    /// Pays for a visit of a diagram in the skein.
    void spend_on_skein(const Diagram& diagram) { left -= 1.0 * diagram.crossings() * diagram.crossings(); }
    /// Pays for a diagram's simplify().
    void spend_on_simplifying(const Diagram& diagram) {
        left -= 0.01 * diagram.crossings() * diagram.crossings() * diagram.crossings();
    }
    /// Whether more was spent than there was.
    bool is_spent() const { return left < 0; }
};

/// HOMFLY polynomial P(v, z): v^-1 P(L+) - v P(L-) = z P(L0), P(unknot) = 1. Strands are oriented as listed.
/// Nothing when that would take more work than is left: the bound that keeps a simulation from being held up.
/// Method: skein recursion towards descending diagrams, each diagram first freed of curls and bigons, with memory.
std::optional<Polynomial> homfly(const Diagram& diagram, Work& work);

}  // namespace sim::knot
