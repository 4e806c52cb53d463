#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

// The program as people meet it: started with a command line, read on stdout and stderr.
namespace program {

namespace fs = std::filesystem;

/// A folder of its own for a test, removed with everything in it.
class Folder {
  public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "carrel-test-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
        path_ = name;
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return path(name);
    }
    std::string path(const std::string& name) const { return (path_ / name).string(); }

  private:
    fs::path path_;
};

inline std::string read(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The text with its first `from` made `to`; throws when there is none.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("nowhere is " + from);
    return text.replace(at, from.size(), to);
}

/// Bytes of no format: the same for the same seed.
inline std::string junk(unsigned seed, std::size_t size) {
    std::mt19937 random(seed);
    std::string bytes;
    while (bytes.size() < size) bytes += static_cast<char>(random());
    return bytes;
}

/// Starts the program with its output going to these files.
inline pid_t start(std::vector<std::string> arguments, const std::string& out, const std::string& errors) {
    arguments.insert(arguments.begin(), CARREL_PROGRAM);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    pid_t child = 0;
    const int spawned = posix_spawn(&child, CARREL_PROGRAM, &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (spawned != 0) throw std::runtime_error("cannot start " CARREL_PROGRAM);
    return child;
}

struct Ending {
    bool in_time = true;
    int signal = 0, exit = -1;
    std::string out, said;  ///< On stdout, on stderr.
};

/// Runs the program to its end; kills it when that takes longer than `patience`.
inline Ending run(const std::vector<std::string>& arguments, std::chrono::seconds patience = std::chrono::seconds(60)) {
    const Folder folder;
    const std::string out = folder.path("stdout"), errors = folder.path("stderr");
    const pid_t child = start(arguments, out, errors);
    Ending ending;
    int status = 0;
    const auto begin = std::chrono::steady_clock::now();
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() - begin > patience) {
            ending.in_time = false;
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
    if (WIFEXITED(status)) ending.exit = WEXITSTATUS(status);
    ending.out = read(out);
    ending.said = read(errors);
    return ending;
}

/// Bad input: exit 2 and one line, which a terminal can show and which names what is to blame.
inline void expect_one_line_naming(const std::string& blamed, const Ending& ending) {
    EXPECT_TRUE(ending.in_time) << "did not end";
    EXPECT_EQ(ending.signal, 0);
    EXPECT_EQ(ending.exit, 2);
    EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said.substr(0, 2000);
    EXPECT_TRUE(ending.said.ends_with('\n'));
    EXPECT_NE(ending.said.find(blamed), std::string::npos) << ending.said.substr(0, 2000);
    EXPECT_NE(ending.said.find("error: "), std::string::npos) << ending.said.substr(0, 2000);
    EXPECT_LT(ending.said.size(), 1000u);
    const auto breaks_a_terminal = [](unsigned char c) { return c < ' ' && c != '\n'; };
    EXPECT_TRUE(std::none_of(ending.said.begin(), ending.said.end(), breaks_a_terminal)) << ending.said;
}

}  // namespace program
