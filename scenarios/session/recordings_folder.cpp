#include "scenarios/session/recordings_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace scenarios::session {

namespace fs = std::filesystem;

std::optional<std::string> problem_with_player(const std::string& who) {
    constexpr std::size_t most = 40;
    const auto fits = [](unsigned char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    };
    if (!who.empty() && who.size() <= most && std::all_of(who.begin(), who.end(), fits)) return {};
    return "A name of who plays is 1 to 40 letters without accents, digits, '-' or '_'.";
}

fs::path recordings_folder(const std::string& who) {
    const auto set = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value ? value : "");
    };
    const fs::path data = set("XDG_DATA_HOME");  // one that is not absolute is to be ignored, the standard says
    return (data.is_absolute() ? data : set("HOME") / ".local/share") / "carrel/recordings" / who;
}

// The number in "square-knot-0007.carrel"; 0 where it is of another drill.
static int number_in(const std::string& file, const std::string& drill_name) {
    const std::string before = drill_name + "-";
    int number = 0;
    if (!file.starts_with(before) || !file.ends_with(".carrel")) return 0;
    const char* end = file.data() + file.size() - std::strlen(".carrel");
    return std::from_chars(file.data() + before.size(), end, number).ptr == end ? std::max(0, number) : 0;
}

fs::path make_next_recording(const fs::path& folder, const std::string& drill_name) {
    std::error_code error;
    fs::create_directories(folder, error);
    int number = 0;
    for (const auto& entry : fs::directory_iterator(folder, error))
        number = std::max(number, number_in(entry.path().filename(), drill_name));
    for (;;) {
        char digits[16];
        std::snprintf(digits, sizeof digits, "-%04d", ++number);
        const fs::path file = folder / (drill_name + digits + ".carrel");
        const int opened = open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0644);
        if (opened >= 0) return close(opened), file;
        if (errno != EEXIST)
            throw std::runtime_error(file.string() + ": error: cannot be made (" + std::strerror(errno) + ")");
    }
}

// The nearest folder above that is there: the recordings' own is made by the first of them.
static fs::path nearest_there(fs::path folder) {
    std::error_code ignored;
    while (folder.has_relative_path() && !fs::exists(folder, ignored)) folder = folder.parent_path();
    return folder;
}

std::optional<std::string> low_space(const fs::path& folder, std::uintmax_t needed) {
    std::error_code error;
    const auto space = fs::space(nearest_there(folder), error);
    if (error || space.available >= needed) return {};
    constexpr std::uintmax_t mb = 1000 * 1000;
    return "Only " + std::to_string(space.available / mb) + " MB are free for recordings in " + folder.string() +
           ", expected " + std::to_string(needed / mb) + " MB: what is played may not be kept to its end.";
}

}  // namespace scenarios::session
