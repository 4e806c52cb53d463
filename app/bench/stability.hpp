#pragma once
#include <filesystem>

#include "app/bench/row.hpp"

namespace app::bench {

/// The hard cases in the files of `scenes`: one row a condition. `quick` leaves out the variants of each scene.
/// Throws as load_hard_case does.
std::vector<Row> hard_case_rows(const std::filesystem::path& scenes, bool quick, const Progress& progress);

/// Those, and the thread's laws: tight knots, friction, rest, invariance, memory, seeded ties.
Suite stability_suite(const std::filesystem::path& scenes, bool quick, const Progress& progress);

}  // namespace app::bench
