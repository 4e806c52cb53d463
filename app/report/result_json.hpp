#pragma once
#include <string>

#include "scenarios/drill/result.hpp"

namespace app::report {

/// result.json: one JSON object, indented, ends in a newline. SI and the unit in the key, as everywhere in files.
/// A figure that is not finite becomes null; bytes that are not UTF-8 become U+FFFD. Samples are left to the report.
/// Equal results give equal text; only `tick_us` and `machine` differ between runs and machines.
std::string result_json(const scenarios::drill::Result& result);

}  // namespace app::report
