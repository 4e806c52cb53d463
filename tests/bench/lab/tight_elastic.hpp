#pragma once
#include <vector>

#include "tests/bench/lab/cost.hpp"
#include "tests/bench/lab/row.hpp"

namespace bench::lab {

/// What an open overhand of an elastic thread that hardly resists bending takes up when it is pulled harder and harder
/// by both ends; by 25 diameters a second; figures in diameters, of the thread as long as it then is, so that its
/// stretch counts for nothing.
struct TightElastic {
    double in_the_end = 0;  ///< At a strain of a hundredth; NaN if it never comes to that.
    double least = 1e300;   ///< At any time.
    double gap = 0;         ///< In the end: smallest distance of its strands' centre lines.
    int pass_throughs = 0;
    Cost cost = {};
};
TightElastic tight_elastic(double link_in_diameters, double friction, double tick = 1e-3);

std::vector<Row> tight_elastic_rows(bool quick);

}  // namespace bench::lab
