#pragma once
#include <filesystem>

#include "app/bench/row.hpp"

namespace app::bench {

/// How right and how fast knots are named: the labelled curves in `curves`, turned and cut finer, random polygons,
/// tight simulated threads flat and capsized. `quick`: a hundredth of the turns.
Suite naming_suite(const std::filesystem::path& curves, bool quick, const Progress& progress);

}  // namespace app::bench
