#pragma once
#include <vector>

#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/result.hpp"
#include "scenarios/world/measure.hpp"

// What a session with a needle is scored by, each added to `items`.
namespace scenarios::drill {

/// Scores how square to its wire the needle was held.
void score_needle(const Drill& drill, const world::Measures& measures, std::vector<ScoreItem>& items);

/// Scores each bite: whether it goes between outside and lumen of one wall and holds, how far from the cut, at what
/// angle; and how many do.
void score_bites(const Drill& drill, const world::Measures& measures, std::vector<ScoreItem>& items);

/// Scores gap, lumen, leak and the ten lapses of two ends that are sewn.
void score_join(const Drill& drill, const world::Measures& measures, std::vector<ScoreItem>& items);

}  // namespace scenarios::drill
