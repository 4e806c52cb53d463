#pragma once
#include "scenarios/drill/drill.hpp"
#include "scenarios/drill/json_text.hpp"

namespace scenarios::drill {

/// Reads a drill's /steps, which fit drill_schema(), into `drill`, whose world is read. Throws FileError where a step
/// asks for what this world has not, or its reference begins before that of the step before ends.
void read_steps(const JsonText& document, const json& entries, Drill& drill);

/// Throws FileError where a step's reference ends after the drill's motion does [s]; no motion: where there is any.
void check_references(const JsonText& document, const Drill& drill, std::optional<double> motion_s);

}  // namespace scenarios::drill
