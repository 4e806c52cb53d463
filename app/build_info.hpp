#pragma once
#include <string>

namespace app {

/// Of the program, such as "0.2.0".
std::string version();

/// Of the sources that were compiled, such as "5080f11" and "5080f11+" where they were changed since; "unknown" outside
/// a checkout.
extern const char* const commit;

/// Version, commit, compiler and how it was told to build, for figures that depend on them.
std::string build_name();

}  // namespace app
