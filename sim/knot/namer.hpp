#pragma once
#include <string>
#include <vector>

#include "sim/geometry/vec.hpp"

namespace sim::knot {

using geometry::Vec3;

struct Factor {
    std::string name;     ///< Prime, as listed in the table: "3_1".
    bool mirror = false;  ///< The mirror image of the listing.
    int crossings = 0;
};

/// One throw read along the thread from the loop outwards: `turns` turns of one hand.
struct Throw {
    int turns = 1;
    bool right_handed = true;
};

struct Name {
    std::string knot = "0_1";  ///< "3_1#m3_1": factors sorted and joined by '#'; "unknown" if not in the table.
    std::vector<Factor> factors;
    std::string surgical;  ///< "square", "granny", "surgeon's", "overhand", "slip", ... or empty.
    std::string throws;    ///< Tera and Aberg: "1=1", "2=1", "1x1", or empty.
    int crossings_projected = 0, crossings_reduced = 0;
    bool certain = true;
    std::vector<std::string> candidates;  ///< What remains when not certain.
};

/// Names the knot in an open curve (its ends joined outside its convex hull) or a closed one.
/// Vertices in order, any unit, at least two, finite. Scale, rotation and translation do not matter.
Name name_knot(const std::vector<Vec3>& curve, bool closed = false);

}  // namespace sim::knot
