#include "app/window/settings.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/files.hpp"
#include "app/hands/assists.hpp"

namespace app::window {

namespace fs = std::filesystem;

static fs::path base(const char* variable, const char* otherwise) {
    if (const char* set = std::getenv(variable); set && *set == '/') return set;
    const char* home = std::getenv("HOME");
    return fs::path(home && *home ? home : "/tmp") / otherwise;
}

Places places() {
    const fs::path config = base("XDG_CONFIG_HOME", ".config") / "carrel";
    return {config / "settings.json", config / "keys.json", base("XDG_CACHE_HOME", ".cache") / "carrel",
            base("XDG_DATA_HOME", ".local/share") / "carrel/recordings"};
}

std::string who_of(const Settings& settings) {
    return settings.who.empty() ? "resident" : settings.who;
}

static Settings from_json(const nlohmann::json& json) {
    Settings settings;
    settings.who = json.value("who", settings.who);
    settings.is_exam = json.value("exam", settings.is_exam);
    settings.scale = std::clamp(json.value("scale", settings.scale), 0.75, 2.5);
    settings.folders = json.value("folders", settings.folders);
    settings.assists = hands::parse_assists(json.value("assists", settings.assists)).names();
    settings.left_handed = json.value("left_handed", settings.left_handed);
    settings.one_handed = json.value("one_handed", settings.one_handed);
    settings.toggles = json.value("toggles", settings.toggles);
    settings.holds_jaw = json.value("holds_jaw", settings.holds_jaw);
    return settings;
}

Settings load_settings(const fs::path& file, std::string& problem) try {
    std::ifstream stream(file);
    if (!stream) return {};
    return from_json(nlohmann::json::parse(stream));
} catch (const std::exception& error) {
    problem = file.string() + ": error: " + error.what() + "; the usual settings are used";
    return {};
}

std::string save_settings(const fs::path& file, const Settings& settings) try {
    const nlohmann::json json{{"who", settings.who},
                              {"exam", settings.is_exam},
                              {"scale", settings.scale},
                              {"folders", settings.folders},
                              {"assists", settings.assists},
                              {"left_handed", settings.left_handed},
                              {"one_handed", settings.one_handed},
                              {"toggles", settings.toggles},
                              {"holds_jaw", settings.holds_jaw}};
    fs::create_directories(file.parent_path());
    const fs::path fresh = file.string() + "." + std::to_string(getpid());
    write_file(fresh, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    fs::rename(fresh, file);
    return "";
} catch (const std::exception& error) {
    return std::string("the settings could not be kept: ") + error.what();
}

}  // namespace app::window
