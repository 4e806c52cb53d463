#pragma once
#include "tests/bench/lab/problems.hpp"

namespace bench::lab {

/// A thread of polypropylene 6-0, a hundred diameters long from where it is clamped, bent by ten times B / L^2 at its
/// tip for half a second: the tip's way across over the length, and that of an elastica (surgery-and-physics.md, D2).
/// `link`: number of links.
Compared cantilever(const Setting& setting, Cost& cost);

/// The same thread held by both ends, which come together by 3 % of its length: its steepest angle, and that of a helix
/// of 27 turns (D7, a). Tools do not turn a thread yet, so that none of the turns gets into it: what is missed is the
/// twist.
Compared let_in(const Setting& setting, Cost& cost);

}  // namespace bench::lab
