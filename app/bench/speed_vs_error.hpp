#pragma once
#include <utility>
#include <vector>

#include "app/bench/row.hpp"

namespace app::bench {

/// Error against theory and cost of both threads, over links and ticks; of the rod alone over links. Cost is processor
/// time: of a simulated second, or of an equilibrium of the rod. `quick`: the coarsest links in the longest ticks
/// alone.
Suite speed_vs_error_suite(bool quick, const Progress& progress);

/// What it found, drawn: error over cost, a picture (SVG) a problem, and its name.
std::vector<std::pair<std::string, std::string>> speed_vs_error_pictures(const Suite& suite);

}  // namespace app::bench
