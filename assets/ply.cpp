#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

#include "assets/formats.hpp"
#include "assets/text.hpp"

namespace assets {

namespace {

struct Property {
    std::string count_type;  // of a list; else empty
    std::string type;
};

struct Element {
    std::string line;  // that names it
    double count = 0;
    std::vector<Property> properties = {};
};

struct Header {
    std::string text;  // without comments
    std::string format = {};
    std::vector<Element> elements = {};
};

// [bytes] 0: no type of a .ply.
std::size_t size_of(const std::string& type) {
    struct Type {
        const char *name, *also;
        std::size_t size;
    };
    for (const auto& [name, also, size] : {Type{"char", "int8", 1},
                                           {"uchar", "uint8", 1},
                                           {"short", "int16", 2},
                                           {"ushort", "uint16", 2},
                                           {"int", "int32", 4},
                                           {"uint", "uint32", 4},
                                           {"float", "float32", 4},
                                           {"double", "float64", 8}})
        if (type == name || type == also) return size;
    return 0;
}

// Takes the header off `rest`.
Header header_of(std::string_view& rest, const std::filesystem::path& file) {
    constexpr std::size_t most_words = 6;
    Header header{};
    while (!rest.empty()) {
        const std::string line = in_small_letters(std::string(next_line(rest)));
        const auto words = words_of(line, most_words);
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
        header.text += line + "\n";
        if (words[0] == "end_header") return header;
        if (words[0] == "format" && words.size() > 1) header.format = words[1];
        if (words[0] == "element") {
            Element element{line.substr(0, 60)};
            const std::string_view count = words.size() > 2 ? words[2] : std::string_view();
            const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
            if (error != std::errc() || !(element.count >= 0))
                fail(file, "says " + shown(line) + ", expected 'element', a name and how many there are");
            header.elements.push_back(element);
        }
        if (words[0] == "property" && words.size() > 2 && !header.elements.empty()) {
            const bool is_list = words[1] == "list" && words.size() > 4;
            header.elements.back().properties.push_back(
                {std::string(is_list ? words[2] : ""), std::string(words[is_list ? 3 : 1])});
        }
    }
    fail(file, "has no 'end_header', it is cut off or not a .ply file");
}

// What comes behind the header, value by value.
class Body {
  public:
    Body(std::string_view bytes, const std::string& format) : rest_(bytes), format_(format) {}

    // Nothing where the body is at its end. What is no number is told by assimp.
    std::optional<double> next(const std::string& type) { return format_ == "ascii" ? word() : number(type); }

    bool take(const Element& element) {
        for (const Property& property : element.properties) {
            const auto count = property.count_type.empty() ? 1 : next(property.count_type);
            if (!count) return false;
            for (double i = 0; i < *count; ++i)
                if (!next(property.type)) return false;
        }
        return true;
    }

  private:
    std::optional<double> word() {
        const std::size_t from = rest_.find_first_not_of(" \t\r\n");
        if (from == std::string_view::npos) return {};
        rest_.remove_prefix(from);
        double value = 0;
        std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        rest_.remove_prefix(std::min(rest_.find_first_of(" \t\r\n"), rest_.size()));
        return value;
    }

    // A whole number; of others only the length matters.
    std::optional<double> number(const std::string& type) {
        const std::size_t size = size_of(type);
        if (rest_.size() < size) return {};
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < size; ++i)
            value =
                value << 8 | static_cast<unsigned char>(rest_[format_ == "binary_little_endian" ? size - 1 - i : i]);
        rest_.remove_prefix(size);
        return static_cast<double>(value);
    }

    std::string_view rest_;
    const std::string& format_;
};

bool is_known(const Header& header) {
    for (const Element& element : header.elements)
        for (const Property& property : element.properties)
            if (size_of(property.type) == 0 || (!property.count_type.empty() && size_of(property.count_type) == 0))
                return false;
    return header.format == "ascii" || header.format == "binary_little_endian" || header.format == "binary_big_endian";
}

// assimp 5.2 runs for ever on a file that promises more than it holds.
void check_length(std::string_view bytes, const Header& header, const std::filesystem::path& file) {
    Body body(bytes, header.format);
    for (const Element& element : header.elements)
        for (double i = 0; i < element.count; ++i)
            if (element.properties.empty() ? bytes.size() < element.count : !body.take(element))
                fail(file, "is cut off: says '" + element.line + "' and holds " +
                               std::to_string(static_cast<std::int64_t>(i)) + " of them");
}

}  // namespace

std::string readable_ply(const std::string& bytes, const std::filesystem::path& file) {
    std::string_view rest = bytes;
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n\xef\xbb\xbf"), rest.size()));
    if (in_small_letters(std::string(rest.substr(0, 3))) != "ply")
        fail(file, "has no 'ply' at its start, it is not a .ply file");
    const Header header = header_of(rest, file);
    if (!is_known(header))
        fail(file,
             "its header names a format or a type that .ply files do not have, expected such as 'format ascii "
             "1.0' and 'property float x'");
    check_length(rest, header, file);
    return header.text + std::string(rest);
}

}  // namespace assets
