#pragma once
#include <cstddef>
#include <vector>

namespace sim::knot {

/// One passage of a strand through a crossing.
struct Passage {
    int crossing;  ///< Number of the crossing, from 0.
    bool over;     ///< Whether the strand passes over.
    bool operator==(const Passage&) const = default;
};

/// A link diagram on the sphere as its signed Gauss code: per component the passages met on one tour of it.
/// Every crossing occurs once over and once under. A component without passages is a circle apart.
/// Sign: +1 when (over x under) points to the viewer, so the right-handed trefoil has three positive crossings.
struct Diagram {
    std::vector<std::vector<Passage>> strands;  ///< Per component, its passages in order.
    std::vector<int> sign;                      ///< Per crossing, +1 or -1.

    /// The number of crossings.
    int crossings() const { return static_cast<int>(sign.size()); }
};

/// A place in a Gauss code.
struct Place {
    int strand = -1, index = -1;  ///< The component, and the passage on it, both from 0.
};
/// Where each crossing is met.
struct Places {
    std::vector<Place> over, under;  ///< Per crossing, its passage over and its passage under.
};
/// Finds where each crossing of a diagram is met. O(crossings).
Places places(const Diagram& diagram);

/// The diagram without the crossings marked `gone`, the others numbered anew.
Diagram without(const Diagram& diagram, const std::vector<char>& gone);

/// Makes Reidemeister moves 1 and 2 that remove crossings, until none is left.
void remove_curls_and_bigons(Diagram& diagram);

/// Does remove_curls_and_bigons, and every over (under) stretch that has a shorter way over (under) the rest takes it.
/// At most `most` crossings are accepted; larger diagrams only lose curls and bigons.
void simplify(Diagram& diagram, int most = 150);

/// True when over and under alternate along every strand and no crossing cuts the diagram in two: then no diagram of
/// this link has fewer crossings (Kauffman, Murasugi, Thistlethwaite 1987).
bool reduced_alternating(const Diagram& diagram);

/// A part of a diagram that no crossing connects with the rest.
struct Piece {
    Diagram diagram;           ///< The part alone, its crossings numbered anew.
    std::vector<int> strands;  ///< Numbers that its strands have in the whole diagram.
};
/// The pieces of a diagram; together they have all its strands.
std::vector<Piece> split_pieces(const Diagram& diagram);

/// A visible summand: a stretch of one strand that holds both passages of each of its crossings.
struct Summand {
    Diagram diagram;  ///< The stretch as a diagram of one strand.
    int strand;       ///< Number of the strand that it was cut from.
};
/// Cuts off visible summands and returns them innermost first; `diagram` keeps the rest. A knot comes back whole among
/// the summands, its rest empty.
std::vector<Summand> cut_summands(Diagram& diagram);

/// Half the sum of the signs of the crossings between strands i and j.
int linking_number(const Diagram& diagram, int i, int j);

/// The diagram with strand i traversed backwards.
Diagram reversed(Diagram diagram, int i);

/// Only strand i, its crossings with others taken away.
Diagram only(const Diagram& diagram, int i);

}  // namespace sim::knot
