#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>

#include "app/commands.hpp"
#include "app/fault.hpp"
#include "assets/mesh.hpp"
#include "scenarios/drill/file.hpp"
#include "scenarios/recording/recording.hpp"

// One line, like every other word on bad input.
static std::string usage_fault(const CLI::App* program, const CLI::Error& error) {
    std::string command = "carrel";
    for (const CLI::App* chosen : program->get_subcommands()) command += " " + chosen->get_name();
    return command + ": error: " + error.what() + "; see " + command + " --help\n";
}

int main(int argc, char** argv) try {
    CLI::App program{"Carrel: a surgical suturing trainer. A thread that can be tied, pulled tight and named."};
    program.require_subcommand(1);
    program.failure_message(usage_fault);
    app::add_commands(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    }
    return app::chosen_command()();
} catch (const app::CheckFailed& failed) {
    std::cerr << failed.what() << '\n';
    return 3;
} catch (const app::InputFault& fault) {
    std::cerr << fault.what() << '\n';
    return 2;
} catch (const assets::AssetError& fault) {
    std::cerr << fault.what() << '\n';
    return 2;
} catch (const scenarios::drill::FileError& fault) {
    std::cerr << fault.what() << '\n';
    return 2;
} catch (const scenarios::recording::RecordingError& fault) {
    std::cerr << fault.what() << '\n';
    return 2;
} catch (const std::exception& error) {
    std::cerr << "carrel: failed: " << error.what() << '\n';
    return 1;
}
