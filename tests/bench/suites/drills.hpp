#pragma once
#include <filesystem>

#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// The knot drills of the folder `drills` by their own motions, with other threads, links and ticks. A row's `error` is
/// how far its figure is from the same drill's in a fine run. Cost: minutes. `quick`: the first drill as it is, and no
/// fine run to be off.
void add_drills(lab::Suite& suite, const std::filesystem::path& drills, bool quick, const lab::Progress& progress);

}  // namespace bench::suites
