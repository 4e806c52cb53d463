#pragma once
#include <vector>

#include "sim/knot/namer.hpp"

namespace sim::knot {

struct Passage {
    int crossing = 0;
    bool over = false;
    bool operator==(const Passage&) const = default;
};

using Word = std::vector<Passage>;

/// A knot or link diagram as a signed Gauss word: per component its passages in travel order, cyclic.
/// An empty word is a circle that crosses nothing.
struct Diagram {
    std::vector<Word> words;
    std::vector<int>
        sign;  ///< By crossing; +1 right-handed: (over x under).z > 0 seen from +z. Holds unused crossings too.

    int crossings() const;
};

/// Where view number `view` looks from: the same every time, spread over the sphere, never along an axis.
Vec3 view_direction(int view);

/// Shadow of a closed polygon seen along direction number `view` (any number; the same view each time).
/// Points in general position (see reduce.hpp). Cost: n log n plus pairs that overlap along one axis.
Diagram project(const std::vector<Vec3>& polygon, int view);

/// Undoes curls (Reidemeister 1) and strands that lie wholly above one another (Reidemeister 2) until none is left.
void simplify(Diagram& diagram);

/// The factors one can see: stretches of a one-component diagram that meet only themselves. Each simplified, none
/// empty.
std::vector<Diagram> split(Diagram diagram);

}  // namespace sim::knot
