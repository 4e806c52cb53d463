#pragma once
#include <string>

namespace app {

/// Of the program, such as "0.2.0".
std::string version();

/// Version, compiler and how it was told to build, for figures that depend on them.
std::string build_name();

}  // namespace app
