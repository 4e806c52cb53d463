#pragma once
#include <functional>

namespace app {

/// What a command line asks for, ready to be done; returns the exit code. Help and usage faults are printed at once.
std::function<int()> asked_for(int argc, char** argv);

}  // namespace app
