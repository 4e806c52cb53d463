#pragma once
#include <filesystem>

#include "tests/bench/lab/row.hpp"

namespace bench::suites {

/// The hard cases in the files of `scenes`: one row a condition. `quick` leaves out the variants of each scene.
/// Throws as load_hard_case does.
std::vector<lab::Row> hard_case_rows(const std::filesystem::path& scenes, bool quick, const lab::Progress& progress);

/// Those, and the thread's laws: tight knots, friction, rest, invariance, memory, seeded ties.
lab::Suite stability_suite(const std::filesystem::path& scenes, bool quick, const lab::Progress& progress);

}  // namespace bench::suites
