#include "app/commands.hpp"

#include <CLI/CLI.hpp>

#include "app/commands/checks.hpp"

namespace app {

std::function<int()>& chosen_command() {
    static std::function<int()> chosen;
    return chosen;
}

void add_commands(CLI::App& program) {
    add_validate(program);
    add_explain(program);
    add_rope(program);
}

}  // namespace app
