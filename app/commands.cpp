#include "app/commands.hpp"

#include <CLI/CLI.hpp>

namespace app {

std::function<int()>& chosen_command() {
    static std::function<int()> chosen;
    return chosen;
}

void add_commands(CLI::App& program) { (void)program; }

}  // namespace app
