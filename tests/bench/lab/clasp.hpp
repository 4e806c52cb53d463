#pragma once
#include <vector>

#include "tests/bench/lab/row.hpp"

namespace bench::lab {

/// Two bights of an elastic thread that hardly resists bending, hooked into each other at right angles and drawn apart
/// without friction until it is stretched by a hundredth; figures in diameters.
struct Clasp {
    /// Length of both bights, as stretched as they are, less twice the distance between the planes in which their arms
    /// end: each bight straight from plane to plane and back again would take that. If each were half a circle about
    /// the other's tip it would be 2 pi - 2; the shape that balances takes 4.263 [Cantarella, Fu, Kusner, Sullivan and
    /// Wrinkle 2006]. NaN if never tight.
    double excess;
    double tips;  ///< Distance of their tips' centre lines.
    double gap;   ///< Smallest distance of both.
    int pass_throughs = 0;
};
Clasp clasp(double link_in_diameters);

std::vector<Row> clasp_rows(bool quick);

}  // namespace bench::lab
