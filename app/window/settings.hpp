#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace app::window {

/// What a person chose and finds again the next time.
struct Settings {
    std::string who;                   ///< Pseudonym of the person who plays; empty: nobody has said.
    bool is_exam = false;              ///< The menu opens drills as exams.
    double scale = 1;                  ///< Of letters, 0.75 to 2.5.
    std::vector<std::string> folders;  ///< Of further drills.
    std::string assists;               ///< Those that practice begins with, with "," between.
    bool left_handed = false;          ///< The mouse leads the left instrument.
    bool one_handed = false;           ///< The mouse alone leads both hands.
    bool toggles = false;              ///< What is held otherwise begins with a press and ends with the next.
    bool holds_jaw = false;            ///< Jaws are shut while their button is held.
};

/// The folder's name of who plays: "resident" where nobody has said.
std::string who_of(const Settings& settings);

/// Where settings, cached pictures and recordings lie, by the XDG base directories.
struct Places {
    std::filesystem::path settings;    ///< The file of settings.
    std::filesystem::path keys;        ///< The file of keys that are not as usual.
    std::filesystem::path cache;       ///< A folder that may be emptied at any time.
    std::filesystem::path recordings;  ///< A folder with one folder for each person.
};

/// As the environment says.
Places places();

/// What the file says; where it is missing or damaged as if nothing were chosen. `problem`: why it could not be read,
/// a line for the person; untouched where all is well.
Settings load_settings(const std::filesystem::path& file, std::string& problem);

/// Replaces the file at once. Returns what went wrong, a line for the person, or "".
std::string save_settings(const std::filesystem::path& file, const Settings& settings);

}  // namespace app::window
