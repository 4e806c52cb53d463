#pragma once
#include <cstdint>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace bench::lab {

using sim::geometry::Vec3;

/// How hands pull the two throws of a square or granny knot together: by its tails, so that it lies flat, or one strand
/// alone, by its tail and its side of the loop, so that the other capsizes into half hitches round it.
enum class Pull { tails, one_strand };

/// The thread in the end [m]. `seed` draws knot, friction, links, speed and, for one strand, which and which way.
std::vector<Vec3> pulled(Pull how, std::uint64_t seed);

}  // namespace bench::lab
