#pragma once
#include <cstdint>
#include <vector>

namespace sim::knot {

/// coefficient * v^v z^z
struct Term {
    int v, z;
    std::int64_t coefficient;
    bool operator==(const Term&) const = default;
    bool before(const Term& o) const { return v != o.v ? v < o.v : z < o.z; }
};

/// Laurent polynomial in v and z: terms ascending in (v, z), none zero, so that equal polynomials compare equal.
using Polynomial = std::vector<Term>;

Polynomial sum(const Polynomial& a, const Polynomial& b);
Polynomial product(const Polynomial& a, const Polynomial& b);
/// factor * p
Polynomial scaled(const Polynomial& p, Term factor);
/// HOMFLY of the mirror image: v -> 1/v, z -> -z.
Polynomial mirrored(const Polynomial& p);
/// HOMFLY of n circles: ((1/v - v) / z)^(n-1).
Polynomial unlink(int n);

}  // namespace sim::knot
