#pragma once
#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/json_text.hpp"

namespace scenarios::drill {

/// Reads a band, [low, high] or {"max": high}, as `document` has it at `pointer`. Throws FileError where low is above
/// high.
Band read_band(const JsonText& document, const json& entry, const std::string& pointer);

/// Reads a drill's /bands, which fit drill_schema(). Throws FileError where one is of what this world has not: an
/// instrument, a needle, two ends to join.
Bands read_bands(const JsonText& document, const json& entries, const world::WorldDef& world);

}  // namespace scenarios::drill
