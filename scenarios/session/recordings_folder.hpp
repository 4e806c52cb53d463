#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace scenarios::session {

/// What is wrong with a name of who plays, and what would be right, in a sentence; none: it can be a folder's name.
std::optional<std::string> problem_with_player(const std::string& who);

/// Where the recordings of one who plays lie: "$XDG_DATA_HOME/carrel/recordings/WHO", else below "~/.local/share".
/// `who` has no problem. The folder need not be there.
std::filesystem::path recordings_folder(const std::string& who);

/// Makes an empty file for the next recording, and the folder for it: "square-knot-0007.carrel", of the lowest number
/// above all that are there. Nothing that is there is ever touched, even when two programs ask at once.
/// Throws std::runtime_error, one line, when it cannot be made.
std::filesystem::path make_next_recording(const std::filesystem::path& folder, const std::string& drill_name);

/// What to say before play where less than `needed` bytes are free for `folder`; none: there is room, or nobody knows.
std::optional<std::string> low_space(const std::filesystem::path& folder, std::uintmax_t needed = 100 << 20);

}  // namespace scenarios::session
