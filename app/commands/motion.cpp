#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/commands/play.hpp"
#include "app/files.hpp"
#include "scenarios/drill/waypoints.hpp"

namespace app {

void add_motion(CLI::App& program) {
    auto* command = program.add_subcommand("motion", "Turn waypoints, as a person writes them, into a motion file");
    struct Options {
        std::string waypoints, out;
    };
    auto options = std::make_shared<Options>();
    command->add_option("WAYPOINTS", options->waypoints, "Steps of the tools (.waypoints)")->required();
    command->add_option("--out", options->out, "Motion file to write (.csv)")->required();
    command->callback([options] {
        chosen_command() = [options] {
            expect_writable("--out", options->out);
            const auto waypoints = scenarios::drill::load_waypoints(options->waypoints);
            scenarios::drill::write_motion(options->out, waypoints.motion, waypoints.instruments);
            return 0;
        };
    });
}

}  // namespace app
