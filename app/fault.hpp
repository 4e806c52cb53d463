#pragma once
#include "scenarios/session/fault.hpp"

namespace app {

/// A file or a person is at fault. Exit 2.
using scenarios::session::InputFault;

/// A check that was asked for did not hold. Exit 3.
struct CheckFailed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace app
