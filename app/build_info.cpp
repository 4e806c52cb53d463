#include "app/build_info.hpp"

namespace app {

std::string version() {
    return CARREL_VERSION;
}

std::string compiler_name() {
#ifdef __clang__
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

std::string compiler_flags() {
    return CARREL_FLAGS;
}

std::string library_versions() {
    return CARREL_LIBRARIES;
}

std::string build_name() {
    std::string name = "carrel " + version() + ", commit " + commit + ", " + compiler_name();
#ifdef __OPTIMIZE__
    name += ", optimised";
#endif
#ifdef __SANITIZE_ADDRESS__
    name += ", sanitized";
#endif
    return name;
}

}  // namespace app
