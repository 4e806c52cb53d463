#pragma once
#include <string>
#include <vector>

#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/motion.hpp"

namespace app {

/// What is amiss with a drill and still can be played, a sentence each that begins with a JSON pointer: what was mended
/// in its meshes and, with a motion, what of that the time limit cuts off and where rows are left out.
/// Throws assets::AssetError for a bad mesh. Cost: reads the meshes.
std::vector<std::string> warnings_of(const scenarios::drill::Drill& drill, const scenarios::drill::Motion* motion);

/// What the drill leaves out that its thread needs, a sentence each that says what to write instead.
std::vector<std::string> missed_effects(const scenarios::drill::Drill& drill);

}  // namespace app
