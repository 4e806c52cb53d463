#pragma once
#include <vector>

#include "sim/geometry/vec.hpp"

namespace sim::knot {

using geometry::Vec3;

/// How unevenly the two strands of a knot bend: |a - b| / (a + b) of what each turns where they cross each other, 0 (a
/// knot that lies flat) to 1 (one strand straight, the other hitched round it).
///
/// Crossings are counted without a view, as all views show them on average (the Gauss integral with its sign left out).
/// The strand is cut in two in the middle of its loop, where the halves cross each other most, and they cross where the
/// middle nine tenths of that are. Neither size nor attitude matters. Cost: 64 chords with each other, 30 us.
double unevenness(const std::vector<Vec3>& strand);

/// Where the knot of a strand is, in lengths along the strand from its first end and in its unit.
struct Extent {
    double first, loop_first;  ///< Where the first of the knot's two strands begins and ends; then the loop follows.
    double loop_last, last;    ///< Where the other of the knot's two strands begins and ends.

    /// The length of the loop.
    double loop() const { return loop_last - loop_first; }
    /// The length of the knot's two strands together.
    double knot() const { return last - first - loop(); }
    /// Whether the knot, its loop left out, holds the place `at` along the strand.
    bool holds(double at) const { return (first <= at && at <= loop_first) || (loop_last <= at && at <= last); }
};
/// Finds where the knot of a strand is, as for unevenness, to a sixtieth of knot and loop; it means little where there
/// is no knot. Cost: twice that of unevenness.
Extent extent(const std::vector<Vec3>& strand);

}  // namespace sim::knot
