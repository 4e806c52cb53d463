#pragma once
#include <stdexcept>

namespace app {

/// A file or a person is at fault: one line "file:line:column: error: where: what is wrong, what would be right".
/// Exit 2.
struct InputFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A check that was asked for did not hold. Exit 3.
struct CheckFailed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace app
