#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// What every reader of an asset's text needs.
namespace assets {

/// Throws AssetError "file:line:column: error: what"; a line or column of 0 is left out.
[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what, int line = 0,
                       std::size_t column = 0);

/// All bytes of a file. Throws AssetError where it cannot be read.
std::string bytes_of(const std::filesystem::path& file);

/// The ending of a file's name in small letters: ".stl" of "SCAN.STL".
std::string ending_of(const std::filesystem::path& file);

/// `text` with A to Z in small letters.
std::string in_small_letters(std::string text);

/// The words of a line between blanks, tabs and commas, at most `most` of them.
std::vector<std::string_view> words_of(std::string_view line, std::size_t most);

/// The line that `text` starts with, without its end ("\n" or "\r\n"), which is taken off `text`.
std::string_view next_line(std::string_view& text);

/// A word fit to print within a message: quoted, cut to 20 characters, '?' for what a terminal cannot show.
std::string shown(std::string_view word);

/// A coordinate [mm], finite and within 1e9 mm. Throws AssetError that points at the word within `line`.
double coordinate_in(std::string_view word, std::string_view line, const std::filesystem::path& file, int number);

}  // namespace assets
