#pragma once
#include <utility>
#include <vector>

#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// Error against theory and cost of both threads, over links and ticks; of the rod alone over links. Cost is processor
/// time: of a simulated second, or of an equilibrium of the rod. `quick`: the coarsest links in the longest ticks
/// alone.
lab::Suite speed_vs_error_suite(bool quick, const lab::Progress& progress);

/// What it found, drawn: error over cost, a picture (SVG) a problem, and its name.
std::vector<std::pair<std::string, std::string>> speed_vs_error_pictures(const lab::Suite& suite);

}  // namespace bench::suites
