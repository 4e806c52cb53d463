#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "app/commands/commands.hpp"

namespace app {

// Returns only where there is no such program.
static void become(const std::filesystem::path& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program.string());
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    execvp(argv[0], argv.data());
}

int bench_command(const std::vector<std::string>& arguments) {
    const std::string name = "carrel-bench";
    std::error_code ignored;
    const auto here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    become(here / name, arguments);
    become(name, arguments);
    throw std::runtime_error(
        "bench: " + name +
        " is neither beside this program nor on the path; in the source tree `make build` builds it");
}

}  // namespace app
