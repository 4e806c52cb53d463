#pragma once
#include <vector>

#include "tests/bench/lab/rod_cases.hpp"
#include "tests/bench/lab/row.hpp"

// D21 of surgery-and-physics.md: an elastic thread of twenty links under its own weight on a plane, tilted by the angle
// whose tangent is `share` times the friction: above 1 it slides, below it stays.
namespace bench::lab {

struct Incline {
    double friction, share;
    double link;          ///< [D]
    double tick;          ///< [s]
    bool across = false;  ///< It lies level, not down the slope.
};

/// Between a quarter and half a second [m/s^2], and Coulomb's g (sin - friction cos).
Compared incline_acceleration(const Incline& incline);

/// How far any node is from where it lay, at most, in so many seconds [D]; no farther than one is looked at.
double incline_drift(const Incline& incline, double seconds);

std::vector<Row> incline_rows(bool quick);

}  // namespace bench::lab
