#include "tests/bench/peers/peer.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "tests/bench/peers/pull_json.hpp"

namespace bench::peers {

using namespace lab;

namespace fs = std::filesystem;

namespace {

std::string all_from(int descriptor) {
    std::string text;
    char piece[4096];
    for (ssize_t got; (got = read(descriptor, piece, sizeof piece)) > 0;)
        text.append(piece, static_cast<std::size_t>(got));
    return text;
}

// What the program says on stdout.
std::string output_of(std::vector<std::string> call) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe to " + call[0]);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    posix_spawn_file_actions_addclose(&actions, ends[1]);
    std::vector<char*> argv;
    for (std::string& word : call) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    const int spawned = posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    const std::string said = all_from(ends[0]);
    close(ends[0]);
    int status = 0;
    if (spawned != 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw std::runtime_error(call[0] + " failed");
    return said;
}

}  // namespace

Peer::Peer(const std::string& name) {
    std::error_code ignored;
    program_ = fs::read_symlink("/proc/self/exe", ignored).parent_path() / ("rope_" + name);
}

bool Peer::there() const {
    return access(program_.c_str(), X_OK) == 0;
}

PullFigures Peer::pull(int links, double speed) const try {
    return figures_from(nlohmann::json::parse(output_of({program_, std::to_string(links), std::to_string(speed)})));
} catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(program_ + " said what is no answer: " + error.what());
}

}  // namespace bench::peers
