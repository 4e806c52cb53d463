#pragma once
#include <filesystem>

#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// How right and how fast knots are named: the labelled curves in `curves`, turned and cut finer, random polygons,
/// tight simulated threads flat and capsized. `quick`: a hundredth of the turns.
lab::Suite naming_suite(const std::filesystem::path& curves, bool quick, const lab::Progress& progress);

}  // namespace bench::suites
