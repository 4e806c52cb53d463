#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include "app/commands.hpp"
#include "app/fault.hpp"
#include "assets/mesh.hpp"
#include "scenarios/drill/file.hpp"
#include "scenarios/recording/recording.hpp"

// Words of files and libraries may hold anything; a terminal gets one line.
static std::string one_line(std::string text) {
    std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
    return text + '\n';
}

static int fail(int exit_code, const std::string& what) {
    std::cerr << one_line(what);
    return exit_code;
}

static std::string usage_fault(const CLI::App* program, const CLI::Error& error) {
    std::string command = "carrel";
    for (const CLI::App* chosen : program->get_subcommands()) command += " " + chosen->get_name();
    return one_line(command + ": error: " + error.what() + "; see " + command + " --help");
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
    return fail(3, failed.what());
} catch (const app::InputFault& fault) {
    return fail(2, fault.what());
} catch (const assets::AssetError& fault) {
    return fail(2, fault.what());
} catch (const scenarios::drill::FileError& fault) {
    return fail(2, fault.what());
} catch (const scenarios::recording::RecordingError& fault) {
    return fail(2, fault.what());
} catch (const std::exception& error) {
    return fail(1, std::string("carrel: failed: ") + error.what());
}
