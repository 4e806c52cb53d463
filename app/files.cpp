#include "app/files.hpp"

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

void expect_writable(std::string_view option, const fs::path& file) {
    std::error_code ignored;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (file.empty() || fs::is_directory(file, ignored)) refuse(option, file, "is a folder, expected the name of a file");
    if (!fs::is_directory(folder, ignored)) refuse(option, file, "there is no folder " + folder.string());
    const fs::path& touched = fs::exists(file, ignored) ? file : folder;
    if (access(touched.c_str(), W_OK) != 0) refuse(option, file, std::strerror(errno));
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
    if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace app
