#pragma once
#include <functional>

namespace CLI {
class App;
}

namespace app {

/// Adds every command of docs/commands to the program.
void add_commands(CLI::App& program);

/// What the command line asked for; call after parsing. Returns the exit code.
std::function<int()>& chosen_command();


}  // namespace app
