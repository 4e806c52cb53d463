#include "assets/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>

#include "assets/mesh.hpp"

namespace assets {

void fail(const std::filesystem::path& file, const std::string& what, int line, std::size_t column) {
    std::string place = file.string();
    if (line > 0) place += ":" + std::to_string(line);
    if (column > 0) place += ":" + std::to_string(column);
    throw AssetError(place + ": error: " + what);
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) fail(file, "cannot be opened");
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string in_small_letters(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::string ending_of(const std::filesystem::path& file) {
    return in_small_letters(file.extension().string());
}

std::vector<std::string_view> words_of(std::string_view line, std::size_t most) {
    std::vector<std::string_view> words;
    constexpr std::string_view between = " \t,\r";
    for (std::size_t from = line.find_first_not_of(between); from != std::string_view::npos && words.size() < most;) {
        const std::size_t to = std::min(line.find_first_of(between, from), line.size());
        words.push_back(line.substr(from, to - from));
        from = line.find_first_not_of(between, to);
    }
    return words;
}

std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::string shown(std::string_view word) {
    std::string text = "'";
    for (const char c : word.substr(0, 20)) text += c > ' ' && c < 127 ? c : '?';
    return text + (word.size() > 20 ? "...'" : "'");
}

double coordinate_in(std::string_view word, std::string_view line, const std::filesystem::path& file, int number) {
    constexpr double farthest_mm = 1e9;  // a thousand kilometres: a wrong unit or a broken number
    const auto column = static_cast<std::size_t>(word.data() - line.data()) + 1;
    const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end != digits.data() + digits.size() || digits.empty() || error == std::errc::invalid_argument)
        fail(file, "expected a number, found " + shown(word) + "; a line is 'x y z' in mm", number, column);
    if (error != std::errc{} || !std::isfinite(value) || std::abs(value) > farthest_mm)
        fail(file, "expected a finite coordinate within 1e9 mm, found " + shown(word), number, column);
    return value;
}

}  // namespace assets
