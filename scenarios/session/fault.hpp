#pragma once
#include <stdexcept>

namespace scenarios::session {

/// A file or a person is at fault: one line "file:line:column: error: where: what is wrong, what would be right".
struct InputFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace scenarios::session
