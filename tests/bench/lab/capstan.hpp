#pragma once
#include <vector>

#include "tests/bench/lab/cost.hpp"
#include "tests/bench/lab/row.hpp"

namespace bench::lab {

/// A thread drawn round a fixed cylinder: one end is pulled at a surgeon's pace, the other end is a long free tail
/// whose drag is the brake.
struct CapstanCase {
    double wrap;      ///< Angle round the cylinder [rad].
    double friction;  ///< Coulomb coefficient.
    double tick;      ///< [s]
    double link;      ///< In thread diameters.
};

struct Capstan {
    double ratio = 0;  ///< Exponent ln(T2/T1) over what the discrete law says for this very polyline; median of ticks.
    double followed = 0;  ///< Share of the ticks that made their whole motion and showed a tension on both sides.
    Cost cost = {};

    /// |ratio - 1|; 1 where the thread hung more than it slid, so that there is nothing to read.
    double deviation() const;
};

/// T2/T1 over one node of a polyline that turns there by `turn` [rad], sliding with this Coulomb coefficient; over many
/// of them the product (surgery-and-physics.md, table D1). `friction` tan(turn / 2) < 1.
double ratio_over_node(double friction, double turn);

Capstan capstan(const CapstanCase& c);

std::vector<Row> capstan_rows(bool quick);

}  // namespace bench::lab
