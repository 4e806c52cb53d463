#pragma once
#include <string>

namespace app {

/// Of the program, such as "0.2.0".
std::string version();

/// Of the sources that were compiled, such as "5080f11" and "5080f11+" where they were changed since; "unknown" outside
/// a checkout.
extern const char* const commit;

/// The compiler, such as "GCC 12.2.0".
std::string compiler_name();

/// What the compiler was told, as far as it decides what a tick computes.
std::string compiler_flags();

/// The libraries that a tick depends on, with their versions: "Eigen 3.4.0, Bullet 3.24".
std::string library_versions();

/// Version, commit, compiler and how it was told to build, for figures that depend on them.
std::string build_name();

}  // namespace app
