#pragma once
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace scenarios::drill {

using nlohmann::json;

/// A JSON document that knows where in its text each value stands, so that complaints can name line and column.
class JsonText {
  public:
    /// Parses `text`; `name` is what messages call it. Throws FileError: not JSON, a key given twice, nested deeper
    /// than 32, a number too large for a double.
    JsonText(const std::string& text, std::string name);

    /// The document itself.
    const json& value() const { return value_; }

    /// Throws FileError that points at the value at `pointer` (or at its key) and says `what`.
    [[noreturn]] void fail(const std::string& pointer, const std::string& what, bool at_key = false) const;

  private:
    struct Offsets {
        std::size_t key, value;
    };
    friend class PlaceScanner;

    [[noreturn]] void fail_at(std::size_t offset, const std::string& what) const;
    std::string place_of(std::size_t offset) const;

    std::string text_, name_;
    json value_;
    std::map<std::string, Offsets> offsets_;  ///< By JSON pointer.
};

/// `key` as a part of a JSON pointer: '~' and '/' escaped (RFC 6901).
std::string pointer_part(const std::string& key);

}  // namespace scenarios::drill
