#pragma once
#include <vector>

#include "tests/bench/lab/cost.hpp"
#include "tests/bench/lab/knots.hpp"
#include "tests/bench/lab/row.hpp"

// Laws that a thread must keep, as measured experiments. What takes long is shorter when `quick`.
namespace bench::lab {

/// What an open overhand takes up, pulled as tight as it goes by both ends at `speed` [m/s]; figures in diameters.
struct Tight {
    double least = 0;  ///< At any time.
    double in_the_end = 0;
    Cost cost = {};
};
Tight tight(double link_in_diameters, double friction, double speed = 0.02, double length_in_diameters = 60);

/// Root mean square of node motion per tick, over the thread's radius, in the second after the first that the hands are
/// still at a knot pulled as tight as it goes.
double motion_at_rest(Knot knot);

/// A knot above a loop is pulled tight by its tails, then the sides of the loop are pulled apart for `seconds`, tails
/// free.
struct Held {
    double slip = 0;  ///< How much farther the sides came apart after the first tenth of the time [D].
    double way = 0;   ///< From the beginning [D].
    int pass_throughs = 0;
    bool still_tied = false;
};
Held hold_knot(Knot knot, double friction, double seconds);

/// A tight overhand with one tail cut short: the strand that leads to it is drawn out, so that the tail runs through.
struct Opened {
    bool tight = false, open = false;
    int pass_throughs = 0;
};
Opened open_knot(double friction);

std::vector<Row> tight_rows(bool quick);
std::vector<Row> rest_rows(bool quick);
std::vector<Row> stick_rows(bool quick);
std::vector<Row> invariance_rows(bool quick);
std::vector<Row> memory_rows(bool quick);

}  // namespace bench::lab
