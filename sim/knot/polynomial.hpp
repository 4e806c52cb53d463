#pragma once
#include <cstdint>
#include <vector>

namespace sim::knot {

/// One term, `coefficient` times v to the power of `v` and z to the power of `z`.
struct Term {
    int v, z;                  ///< Exponents; either may be negative.
    std::int64_t coefficient;  ///< Any whole number; zero in no Polynomial.
    bool operator==(const Term&) const = default;
    /// Whether it stands before another in a Polynomial.
    bool before(const Term& o) const { return v != o.v ? v < o.v : z < o.z; }
};

/// Laurent polynomial in v and z: terms ascending in (v, z), none zero, so that equal polynomials compare equal.
using Polynomial = std::vector<Term>;

/// The sum a + b.
Polynomial sum(const Polynomial& a, const Polynomial& b);
/// The product a b. O(terms of a times terms of b).
Polynomial product(const Polynomial& a, const Polynomial& b);
/// The product of a single term and p.
Polynomial scaled(const Polynomial& p, Term factor);
/// The HOMFLY polynomial of the mirror image: v becomes 1/v, z becomes -z.
Polynomial mirrored(const Polynomial& p);
/// The HOMFLY polynomial of n circles apart: ((1/v - v) / z)^(n-1).
Polynomial unlink(int n);

}  // namespace sim::knot
