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
    std::vector<Factor> factors;          ///< The prime factors, sorted.
    bool known = true;                    ///< Whether the type is in the table and was found with the work allowed.
    bool certain = true;                  ///< Whether only one type of the table is left.
    std::vector<std::string> candidates;  ///< Names of the types that are left when not certain.
    int crossings = 0;  ///< Least crossings of the type when known, else of the smallest diagram seen.

    /// The factors' names joined by '#', "0_1" without any, "unknown" when not known.
    std::string name() const;
    /// Whether both are known and have the same name, or neither is known and they have as many factors.
    bool operator==(const Identity& o) const;
};

/// Names a knot diagram of one strand. Simplifies it first.
Identity identify(Diagram knot, Work& work);

/// What views of a curve showed.
struct Seen {
    Diagram diagram;     ///< Simplified, the fewest crossings found.
    int projected = 0;   ///< Crossings of the first view before simplification.
    bool found = false;  ///< Whether any view could be used; none can with too many crossings.
};
/// So many views bring 99 of 100 curves to their least crossings; the first does for most.
constexpr int most_views = 24;
/// Tries views, `views` at most and one at least, until a diagram is small enough to be named for certain or the work
/// is spent.
Seen best_view(Polygons polygons, Work& work, int views = most_views);

/// Whether a simplified diagram is small enough to be named for certain.
bool small_enough(Diagram diagram);

}  // namespace sim::knot
