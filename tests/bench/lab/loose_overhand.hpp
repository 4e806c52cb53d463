#pragma once
#include <vector>

#include "tests/bench/lab/cost.hpp"
#include "tests/bench/lab/row.hpp"

namespace bench::lab {

/// A loose overhand of an elastic thread of radius h: a loop of radius R, its two strands twisted about each other
/// where it closes.
struct LooseOverhand {
    double loop;         ///< R / h.
    int links = 60;      ///< Once round the loop.
    int half_turns = 3;  ///< Of the strands about each other, odd: 3 an overhand, 5 a double overhand.
    double friction = 0;
    double tick = 1e-3;   ///< [s]; it takes some seconds.
    bool elastic = true;  ///< Else what ftl shows as tension.

    double eps() const;  ///< sqrt(h / R).
    /// F h^2 / B to lowest order in eps, where B is the bending stiffness: eps^4 / 2 + 0.492 friction eps^3. The first
    /// is a circle that gives way, B / (2 R^2). The second is what drags where the strands press on each other: over a
    /// length that goes with sqrt(h R), by B h / (h R)^(3/2) in all; its number is a single overhand's [Audoly,
    /// Clauvelin and Neukirch 2007, by surgery-and-physics.md D9, which has eps^5; forces scale as eps^3, and so does
    /// what is measured].
    double law() const;
};

/// The same of what it is drawn with, slowly, by both ends, held so that they point along the tails: mean while the
/// knot takes up 2 pi R to within 2 %, for strands that are made of links slide unevenly. NaN if its loop never gets
/// there.
double drawn_with(const LooseOverhand& knot, Cost& cost);

inline double drawn_with(const LooseOverhand& knot) {
    Cost cost;
    return drawn_with(knot, cost);
}

std::vector<Row> loose_overhand_rows(bool quick);

}  // namespace bench::lab
