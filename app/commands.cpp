#include "app/commands.hpp"

#include <CLI/CLI.hpp>

#include "app/commands/checks.hpp"
#include "app/commands/knot.hpp"
#include "app/commands/play.hpp"

namespace app {

std::function<int()>& chosen_command() {
    static std::function<int()> chosen;
    return chosen;
}

void add_commands(CLI::App& program) {
    add_run(program);
    add_replay(program);
    add_render(program);
    add_motion(program);
    add_knot_command(program);
    add_validate(program);
    add_explain(program);
    add_rope(program);
}

}  // namespace app
