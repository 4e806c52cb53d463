#pragma once
#include <optional>
#include <vector>

#include "sim/knot/diagram.hpp"

namespace sim::knot {

struct Term {
    int v = 0, z = 0;
    long long coefficient = 0;
    auto operator<=>(const Term&) const = default;
};

/// Sorted by (v, z); no zero coefficients.
using Polynomial = std::vector<Term>;

/// HOMFLY polynomial P(v, z): P/v of the positive crossing minus v P of the negative one is z P of the smoothed one,
/// and P of a circle is 1. Right-handed trefoil: 2 v^2 + v^2 z^2 - v^4. Nothing if `budget` skein steps do not suffice.
/// Source: the skein recursion to descending diagrams [LickorishMillett1987].
std::optional<Polynomial> homfly(const Diagram& diagram, int budget);

/// P of the mirror image: v becomes 1/v and z becomes -z.
Polynomial mirror(const Polynomial& polynomial);

}  // namespace sim::knot
