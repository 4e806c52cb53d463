#pragma once
#include <string>

namespace app {

/// Processor and number of cores, in one line, for figures that depend on them.
std::string machine_name();

/// Processor time of this thread [us]: what a tick costs, whatever else the machine is doing.
double processor_us();

}  // namespace app
