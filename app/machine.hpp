#pragma once
#include <string>

namespace app {

/// Processor and number of cores, in one line, for figures that depend on them.
std::string machine_name();

}  // namespace app
