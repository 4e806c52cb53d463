#pragma once
#include <optional>
#include <vector>

#include "sim/knot/diagram.hpp"

namespace sim::knot {

/// The group that a diagram is coloured by.
enum class Group {
    psl27,  ///< PSL(2,7), of order 168.
    a5,     ///< A5, the even permutations of five things, of order 60.
};

/// Colouring vector of a knot diagram: entry k counts the homomorphisms of the knot group to the group that send the
/// base meridian to a fixed x (order 7 in PSL(2,7), order 3 in A5) and the longitude to x^k. Multiplicative under
/// connected sum (as polynomials in x); the reversed knot may have another vector.
/// Nothing when more than a million partial colourings would have to be tried.
/// Source: Eisermann, Knot colouring polynomials, arXiv 0707.3895.
std::optional<std::vector<int>> colouring_vector(const Diagram& knot, Group group);

}  // namespace sim::knot
