#include "scenarios/drill/json_text.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "scenarios/drill/file.hpp"

namespace scenarios::drill {

namespace {

// A drill nests 5 deep. The bound keeps the scanner below, which recurses, far from the end of the stack.
constexpr int deepest = 32;

struct TooDeep {};

// What the parser says, without its class name, its position (ours is better) and the token, which can be binary.
std::string reason(const std::string& message) {
    const auto start = message.find(" - ");
    if (start == std::string::npos) return "not valid JSON";
    const auto end = message.find("; last read", start);
    std::string text = message.substr(start + 3, end == std::string::npos ? end : end - start - 3);
    const auto expected = message.find("; expected", end == std::string::npos ? start : end);
    if (end != std::string::npos && expected != std::string::npos) text += message.substr(expected);
    return "not valid JSON: " + text.substr(0, 120);
}

struct Slip {
    std::size_t at;
    const char* what;
};

std::size_t curly_quote_in(const std::string& text, std::size_t from, std::size_t to) {
    std::size_t first = std::string::npos;
    for (const char* quote : {"\u2018", "\u2019", "\u201c", "\u201d", "\u201e", "\u00ab", "\u00bb"})
        first = std::min(first, text.find(quote, from));
    return first < to ? first : std::string::npos;
}

// What editors and other languages put into a text, where the parser stopped at `at`: the last text before that, on the
// same line, may have begun or ended with a curly quote.
std::optional<Slip> slip_near(const std::string& text, std::size_t at) {
    std::size_t begin = std::string::npos, end = 0;
    bool inside = false;
    for (std::size_t i = 0; i < std::min(at, text.size()); ++i) {
        if (inside && text[i] == '\\')
            ++i;
        else if (text[i] == '"' && (inside = !inside))
            begin = i;
        else if (text[i] == '"')
            end = i;
    }
    const bool is_near = begin != std::string::npos && (inside || text.find('\n', end) >= at);
    std::size_t curly = is_near ? curly_quote_in(text, begin, at) : std::string::npos;
    if (curly == std::string::npos && !inside) curly = curly_quote_in(text, at < 2 ? 0 : at - 2, at + 1);
    if (curly != std::string::npos) return Slip{curly, "a curly quote, expected a straight one: \""};
    if (inside) return {};
    const std::string_view there = std::string_view(text).substr(std::min(at, text.size()));
    if (there.starts_with("//") || there.starts_with("/*") || there.starts_with('#'))
        return Slip{at, "a comment, which JSON does not have, remove it"};
    if (there.starts_with('\'')) return Slip{at, "a single quote, expected a double one: \""};
    return {};
}

}  // namespace

std::string pointer_part(const std::string& key) {
    std::string part;
    for (const char c : key) part += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return part;
}

/// Walks text that is known to be valid JSON and notes where each value starts.
class PlaceScanner {
  public:
    explicit PlaceScanner(JsonText& document) : document_(document), text_(document.text_) {
        if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // byte order mark
        value("", 0);
    }

  private:
    void value(const std::string& pointer, std::size_t key) {
        skip_blank();
        if (!document_.offsets_.emplace(pointer, JsonText::Offsets{key, at_}).second)
            document_.fail_at(key, pointer + ": this key is given twice, remove one");
        if (text_[at_] == '{') {
            object(pointer);
        } else if (text_[at_] == '[') {
            array(pointer);
        } else if (text_[at_] == '"') {
            string();
        } else {
            at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
        }
    }
    void object(const std::string& pointer) {
        for (++at_; skip_blank() != '}';) {
            if (text_[at_] == ',') ++at_;
            skip_blank();
            const std::size_t key = at_;
            const std::string name = string();
            skip_blank();
            ++at_;  // the colon
            value(pointer + "/" + pointer_part(name), key);
        }
        ++at_;
    }
    void array(const std::string& pointer) {
        int index = 0;
        for (++at_; skip_blank() != ']'; ++index) {
            if (text_[at_] == ',') ++at_;
            skip_blank();
            value(pointer + "/" + std::to_string(index), at_);
        }
        ++at_;
    }
    std::string string() {
        const std::size_t start = at_++;
        while (text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
        ++at_;
        return json::parse(text_.substr(start, at_ - start)).get<std::string>();
    }
    char skip_blank() {
        at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
        return at_ < text_.size() ? text_[at_] : '\0';
    }

    JsonText& document_;
    const std::string& text_;
    std::size_t at_ = 0;
};

JsonText::JsonText(const std::string& text, std::string name) : text_(text), name_(std::move(name)) {
    if (text_.find_first_not_of(" \t\r\n") == std::string::npos) drill::fail(name_, "is empty, expected a JSON object");
    const auto bounded = [](int depth, json::parse_event_t, json&) {
        if (depth > deepest) throw TooDeep();
        return true;
    };
    try {
        value_ = json::parse(text_, bounded);
    } catch (const TooDeep&) {
        drill::fail(name_, "is nested deeper than " + std::to_string(deepest) + " levels");
    } catch (const json::parse_error& error) {
        const std::size_t at = error.byte == 0 ? 0 : error.byte - 1;
        if (const auto slip = slip_near(text_, at)) fail_at(slip->at, std::string("not valid JSON: ") + slip->what);
        fail_at(at, reason(error.what()));
    } catch (const json::out_of_range& error) {  // "... number overflow parsing '1e999'"
        const std::string what = error.what();
        const auto open = what.find('\'');
        const std::string number = open == std::string::npos ? "" : what.substr(open + 1, what.rfind('\'') - open - 1);
        fail_at(std::min(text_.find(number), text_.size()), "number too large: " + number.substr(0, 40));
    }
    PlaceScanner{*this};
}

std::string JsonText::place_of(std::size_t offset) const {
    const std::string before = text_.substr(0, offset);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const auto start = before.rfind('\n') + 1;  // npos + 1 is 0
    // Editors count characters: bytes that continue a UTF-8 character are none.
    const auto column = std::count_if(before.begin() + static_cast<std::ptrdiff_t>(start), before.end(),
                                      [](char c) { return (c & 0xc0) != 0x80; }) +
                        1;
    return name_ + ":" + std::to_string(line) + ":" + std::to_string(column);
}

void JsonText::fail_at(std::size_t offset, const std::string& what) const {
    drill::fail(place_of(offset), what);
}

void JsonText::fail(const std::string& pointer, const std::string& what, bool at_key) const {
    const auto found = offsets_.find(pointer);
    const std::string shown = pointer.empty() ? "/" : pointer.substr(0, 200);
    if (found == offsets_.end()) drill::fail(name_, shown + ": " + what);
    fail_at(at_key ? found->second.key : found->second.value, shown + ": " + what);
}

}  // namespace scenarios::drill
