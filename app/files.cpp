#include "app/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "app/fault.hpp"

namespace app {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(std::string_view option, const fs::path& path, const std::string& why) {
    throw InputFault(path.string() + ": error: " + std::string(option) + ": cannot be written: " + why);
}

}  // namespace

void expect_writable(std::string_view option, const fs::path& file, std::initializer_list<fs::path> others) {
    std::error_code ignored;
    const auto is_same = [&](const fs::path& other) {
        return fs::equivalent(file, other, ignored) ||
               fs::weakly_canonical(file, ignored) == fs::weakly_canonical(other, ignored);
    };
    for (const fs::path& other : others)
        if (!other.empty() && is_same(other))
            refuse(option, file, "the command reads or writes it as well, expected another name");
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (file.empty() || fs::is_directory(file, ignored))
        refuse(option, file, "is a folder, expected the name of a file");
    if (!fs::is_directory(folder, ignored)) refuse(option, file, "there is no folder " + folder.string());
    // Rights alone do not tell: a root user has them all, and a full or foreign file system refuses nevertheless.
    const bool there = fs::exists(fs::symlink_status(file, ignored));
    const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
    if (opened < 0) refuse(option, file, std::strerror(errno));
    close(opened);
    if (!there) fs::remove(file, ignored);
}

void expect_ending(std::string_view option, const fs::path& file, std::string_view ending) {
    if (file.extension() != ending) refuse(option, file, "expected a name that ends in " + std::string(ending));
}

void make_folder(std::string_view option, const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) refuse(option, folder, error.message());
    if (!fs::is_directory(folder, error)) refuse(option, folder, "is a file, expected a folder");
    if (access(folder.c_str(), W_OK | X_OK) != 0) refuse(option, folder, std::strerror(errno));
}

void write_file(const fs::path& file, std::string_view bytes) {
    std::ofstream out(file, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (out.flush()) return;
    const std::string why = std::strerror(errno);
    out.close();
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) fs::remove(file, ignored);
    throw std::runtime_error(file.string() + ": cannot be written: " + why);
}

}  // namespace app
