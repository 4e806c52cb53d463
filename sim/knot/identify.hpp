#pragma once
#include <string>
#include <vector>

#include "sim/knot/curve.hpp"
#include "sim/knot/diagram.hpp"
#include "sim/knot/homfly.hpp"
#include "sim/knot/namer.hpp"

namespace sim::knot {

/// What a diagram is known to be.
struct Identity {
    std::vector<Factor> factors;  ///< Sorted.
    bool known = true;            ///< False: not in the table, or too much work.
    bool certain = true;
    std::vector<std::string> candidates;
    int crossings = 0;  ///< Of the types when known, else of the smallest diagram seen.

    std::string name() const;
    bool operator==(const Identity& o) const;
};

/// Names a knot diagram of one strand. Simplifies it first.
Identity identify(Diagram knot, Work& work);

/// Views tried until a diagram is small enough to be named for certain, or the work is spent: one at least.
struct Seen {
    Diagram diagram;     ///< Simplified, the fewest crossings found.
    int projected = 0;   ///< Crossings of the first view before simplification.
    bool found = false;  ///< False: no view could be used (too many crossings).
};
constexpr int most_views = 24;  ///< Bring 99 of 100 curves to their least crossings; the first does for most.
Seen best_view(Polygons polygons, Work& work, int views = most_views);

/// Whether a simplified diagram is small enough to be named for certain.
bool small_enough(Diagram diagram);

}  // namespace sim::knot
