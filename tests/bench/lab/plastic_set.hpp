#pragma once
#include <string>
#include <vector>

#include "tests/bench/lab/rod_cases.hpp"
#include "tests/bench/lab/row.hpp"

// What a thread keeps of the bends that a knot has put into it: RodDef::yield_strain.
namespace bench::lab {

/// Strain at which polypropylene yields: the middle of 3 to 5 % [surgery-and-physics.md, C].
constexpr double polypropylene_yield = 0.04;

/// A straight rod laid round a mandrel, its centre line `diameters` from the axis, and let go of: the curvature that it
/// keeps [1/D]. Reference: a round section of elastic and perfectly plastic fibres.
Compared springback(double diameters, double yield_strain);

/// An overhand knot pulled tight by its ends with `pull` [B/D^2], which are let go of evenly in half a second, and a
/// second later.
struct LetGoOverhand {
    double tight,
        after;  ///< Thread between the first and the last place where strands touch [D]; 0: it is no knot any more.
    int pass_throughs;
};
LetGoOverhand let_go_overhand(double pull, double yield_strain);

std::vector<Row> plastic_set_rows(bool quick);

}  // namespace bench::lab
