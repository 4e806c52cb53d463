#pragma once
#include "sim/knot/diagram.hpp"

namespace sim::knot {

/// A stretch that passes only over (or only under) the rest may be lifted off and laid down anywhere else over (under)
/// it, its ends fixed. Finds the first such stretch that can be laid with fewer crossings and lays it so; false when
/// there is none. Curls whose other passage ends the stretch go with it.
/// Cost: O(n^2) for n crossings.
bool shorten_one_stretch(Diagram& diagram);

/// The diagrams after one such stretch is laid another way with as few crossings, up to six ways of each; that it came
/// from may be among them.
std::vector<Diagram> laid_elsewhere(const Diagram& diagram);

/// The knot of the passages first .. first + count - 1 of an open one-strand diagram, its ends joined the shortest way
/// over (or under) everything.
Diagram joined_ends(const Diagram& open, int first, int count, bool over);

}  // namespace sim::knot
