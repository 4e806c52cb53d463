#pragma once
#include <string>
#include <vector>

#include "sim/knot/namer.hpp"
#include "sim/knot/polynomial.hpp"

namespace sim::knot {

/// A knot type of at most 10 crossings: prime or composite, one of its two mirror images.
struct KnownKnot {
    std::vector<Factor> factors;              ///< The prime factors, sorted; none for the unknot.
    int crossings = 0;                        ///< The least crossings of the type, 0 to 10.
    Polynomial homfly;                        ///< The type's HOMFLY polynomial.
    std::vector<std::vector<int>> psl27, a5;  ///< Possible colouring vectors, by the direction of each factor.
};

/// A prime two-component link of at most 9 crossings, one of its two mirror images.
struct KnownLink {
    std::string name;                           ///< With the prefix m for the mirror image of the listing.
    int crossings = 0;                          ///< The least crossings of the type, 2 to 9.
    Polynomial homfly, homfly_second_reversed;  ///< As listed, and with the second strand traversed backwards.
};

/// All types with this polynomial. The table is read once, at first use.
std::vector<const KnownKnot*> knots_with(const Polynomial& homfly);

/// HOMFLY of one prime of the table.
const Polynomial& listed_homfly(const Factor& factor);

/// All links of the table, which is read once, at first use.
const std::vector<KnownLink>& known_links();

/// "m3_1": the table's name with the prefix of the mirror image.
std::string name_of(const Factor& factor);
/// Factors sorted (by crossings, index, mirror last) and joined by '#'; "0_1" for none.
std::string name_of(std::vector<Factor> factors);
/// `all` less each of `taken` once, as far as it is there.
std::vector<Factor> taken_from(std::vector<Factor> all, const std::vector<Factor>& taken);
/// Sorts factors by crossings, then by index, a listing before its mirror image.
void sort_factors(std::vector<Factor>& factors);

}  // namespace sim::knot
