#include "app/build_info.hpp"

namespace app {

std::string version() {
    return CARREL_VERSION;
}

std::string build_name() {
    std::string name = "carrel " + version() + ", GCC " __VERSION__;
#ifdef __OPTIMIZE__
    name += ", optimised";
#endif
#ifdef __SANITIZE_ADDRESS__
    name += ", sanitized";
#endif
    return name;
}

}  // namespace app
