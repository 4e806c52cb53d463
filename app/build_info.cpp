#include "app/build_info.hpp"

namespace app {

std::string version() {
    return CARREL_VERSION;
}

std::string build_name() {
#ifdef __clang__
    constexpr const char* compiler = "Clang " __clang_version__;
#else
    constexpr const char* compiler = "GCC " __VERSION__;
#endif
    std::string name = "carrel " + version() + ", commit " + commit + ", " + compiler;
#ifdef __OPTIMIZE__
    name += ", optimised";
#endif
#ifdef __SANITIZE_ADDRESS__
    name += ", sanitized";
#endif
    return name;
}

}  // namespace app
