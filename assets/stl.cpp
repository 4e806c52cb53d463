#include <algorithm>
#include <cstdint>

#include "assets/formats.hpp"
#include "assets/text.hpp"

namespace assets {

namespace {

constexpr std::size_t header_size = 84, triangle_size = 50;  // [bytes] of a binary .stl

// How many triangles a binary .stl says that it has; little-endian behind 80 bytes of free text.
std::uint64_t said_triangles(const std::string& bytes) {
    std::uint64_t count = 0;
    for (std::size_t i = 4; i-- > 0;) count = count << 8 | static_cast<unsigned char>(bytes[80 + i]);
    return count;
}

// Many programs begin a binary file with 'solid' too: there bytes follow that no text has.
bool is_text(const std::string& lower) {
    constexpr std::size_t enough = 512;
    if (!lower.starts_with("solid")) return false;
    const std::string_view looked_at = std::string_view(lower).substr(0, std::min(lower.rfind("endsolid"), enough));
    return std::none_of(looked_at.begin(), looked_at.end(),
                        [](unsigned char c) { return c < ' ' && c != '\t' && c != '\r' && c != '\n'; });
}

std::string readable_text(const std::string& lower, const std::filesystem::path& file) {
    const std::size_t last = lower.rfind("endsolid");
    if (last == std::string::npos) fail(file, "is cut off: no 'endsolid' ends it");
    const std::size_t end = std::min(lower.find('\n', last), lower.size());
    if (lower.find("solid", end) != std::string::npos)
        fail(file, "is cut off: no 'endsolid' ends the last of its solids");
    return lower.substr(0, end) + "\n";
}

}  // namespace

std::string readable_stl(std::string bytes, const std::filesystem::path& file) {
    const bool is_long_enough = bytes.size() >= header_size;
    const std::uint64_t said = is_long_enough ? said_triangles(bytes) : 0;
    if (!is_long_enough || bytes.size() != header_size + said * triangle_size) {
        const std::size_t begin = std::min(bytes.find_first_not_of(" \t\r\n\xef\xbb\xbf"), bytes.size());
        if (const std::string lower = in_small_letters(bytes.substr(begin)); is_text(lower))
            return readable_text(lower, file);
    }
    if (!is_long_enough)
        fail(file, "is cut off or no .stl file: has " + std::to_string(bytes.size()) + " bytes, expected at least " +
                       std::to_string(header_size));
    if (bytes.size() < header_size + said * triangle_size)
        fail(file, "is cut off or no .stl file: says " + std::to_string(said) + " triangles and has bytes for " +
                       std::to_string((bytes.size() - header_size) / triangle_size));
    bytes.resize(header_size + said * triangle_size);
    return bytes;
}

}  // namespace assets
