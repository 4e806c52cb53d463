#pragma once
#include <vector>

#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// Of some seeded ties, for `carrel bench stability`.
std::vector<lab::Row> ties_rows(bool quick);

/// Ten thousand ties; `quick`: two hundred. `progress` is told each seed that went wrong.
lab::Suite ties_suite(bool quick, const lab::Progress& progress);

/// A thousand of an elastic thread; `quick`: twenty.
lab::Suite elastic_ties_suite(bool quick, const lab::Progress& progress);

}  // namespace bench::suites
