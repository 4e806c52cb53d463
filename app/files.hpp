#pragma once
#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace app {

/// Called before long work, so that a mistyped path costs nothing. Throws InputFault, which names the option, when no
/// file can be written at `file`, or when it is one of the `others` that the command reads or writes. Makes no file;
/// what is there stays as it is.
void expect_writable(std::string_view option, const std::filesystem::path& file,
                     std::initializer_list<std::filesystem::path> others = {});

/// The same for a folder, which is made if missing.
void make_folder(std::string_view option, const std::filesystem::path& folder);

/// Throws InputFault when `file` does not end in `ending` (".png"): a slip of the hand must not cost a file of another
/// kind.
void expect_ending(std::string_view option, const std::filesystem::path& file, std::string_view ending);

/// The whole file at once, or none: half a report looks like one. Throws std::runtime_error: the system failed, for
/// instance a full disk.
void write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace app
