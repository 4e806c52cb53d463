#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

// What a JSON value may be, as data. The loader's checks, the defaults and the published JSON Schema are all made from
// the same shapes, so they cannot disagree.
namespace scenarios::drill {

using nlohmann::json;

enum Type : unsigned { boolean = 1, integer = 2, number = 4, text = 8, array = 16, object = 32 };

struct Key;

/// The allowed form of one value. A limit applies to values of its own type only, as in JSON Schema.
struct Shape {
    unsigned types = object;       ///< Types, or-ed.
    std::string types_words = {};  ///< For the message, where their names say too little.
    std::string about = {};        ///< For editors: one sentence.
    double low = 0, high = 0;      ///< Numbers, both ends included, in `unit`.
    std::string unit = {};
    std::vector<json> choices = {};  ///< If any: the only values allowed.
    std::string why_only = {};       ///< With choices: why no others, for the message.
    std::string pattern = {};        ///< Texts: regular expression, and in words:
    std::string pattern_words = {};
    std::size_t min_items = 0, max_items = 0;  ///< Arrays.
    std::vector<Shape> items = {};             ///< Arrays: one, the form of each item.
    std::vector<Key> keys = {};                ///< Objects: the keys known ...
    std::vector<Shape> other_keys = {};        ///< ... or one: the form of the value at any key.
    std::vector<std::string> one_of = {};      ///< Objects: exactly one of these keys is given.
};

struct Key {
    std::string name;
    Shape shape;
    bool required = false;
    json fallback = nullptr;  ///< Used when absent; null for none.
};

constexpr std::size_t longest_text = 2000;  ///< Characters in any text.

/// What is wrong with a value, and where.
struct Problem {
    std::string pointer, what;
    bool at_key = false;  ///< The key is wrong, not the value.
};

/// The first thing wrong with `value`, or nothing.
std::optional<Problem> first_problem(const json& value, const Shape& shape);

/// `value`, which has no problem, with the defaults of absent keys filled in.
json with_defaults(const json& value, const Shape& shape);

/// `value`, which has no problem, with keys in the order of the table.
nlohmann::ordered_json in_table_order(const json& value, const Shape& shape);

/// JSON text with what fits into a line on one line.
std::string laid_out(const nlohmann::ordered_json& value, std::size_t indent = 0);

/// JSON Schema, draft 2020-12, of `shape`, without the "$schema" line.
nlohmann::ordered_json schema_of(const Shape& shape);

/// A number as people write it: shortest digits that give the same double.
std::string shown(double value);

}  // namespace scenarios::drill
