#pragma once
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace scenarios::drill {

/// What is wrong with a file that a person wrote, in one line for its author:
/// "file:line:column: error: /json/pointer: what is wrong, what would be right".
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws FileError "place: error: what". Control characters, which would break the one line, are shown as '?'.
[[noreturn]] void fail(const std::string& place, const std::string& what);

/// The bytes of a regular file of at most `most_bytes`. Throws FileError: missing, a directory, a pipe, unreadable,
/// larger.
std::string read_text(const std::filesystem::path& file, std::size_t most_bytes);

/// The text without the byte order mark (EF BB BF) that some editors and spreadsheets begin a text with.
std::string without_mark(std::string text);

/// SHA-256 of `bytes` as 64 lower-case hex digits.
std::string sha256(const std::string& bytes);

}  // namespace scenarios::drill
