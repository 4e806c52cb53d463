#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim/knot/reading.hpp"

namespace sim::knot {

/// Those of the factors that are throws: a throw of n turns is the torus knot T(2, 2n + 1) of its hand, n up to 4.
std::vector<Throw> throws_of(const std::vector<Factor>& factors);

/// Two throws or more, from the loop outwards; nothing where they do not lie on one loop, or that cannot be told.
std::optional<std::vector<Throw>> in_order(const std::vector<Throw>& throws, std::vector<Reading> views,
                                           const Identity& whole);

/// Tera and Aberg: turns joined by '=' between throws of opposite hands, 'x' between equal ones.
std::string notation(const std::vector<Throw>& throws);

/// Trimbos: half hitches on a straight post, joined by '=' where they are the same and 'x' where they are mirror
/// images.
std::string half_hitches(const std::vector<Throw>& throws);

/// Of throws in Tera and Aberg's notation: "square", "granny" ...; "throws" for those without a name.
std::string surgeons_name(const std::string& throws);

}  // namespace sim::knot
