#pragma once
#include <string>
#include <vector>

#include "sim/knot/colour.hpp"
#include "sim/knot/homfly.hpp"

namespace sim::knot {

/// A type of at most 10 crossings, prime or composite.
struct Entry {
    std::vector<Factor> factors;
    int crossings = 0;
    Colours colours, reverse_colours;
    std::string name() const;
};

/// Factors sorted by number and joined by '#': "3_1#m3_1". No factors: "0_1".
std::string joined_name(std::vector<Factor> factors);

/// By crossings, then number, the listed image before its mirror.
void sort_factors(std::vector<Factor>& factors);

/// All types of at most 10 crossings with this polynomial, the unknot too; amphichiral knots once, others by hand.
const std::vector<Entry>& types_with(const Polynomial& homfly);

}  // namespace sim::knot
