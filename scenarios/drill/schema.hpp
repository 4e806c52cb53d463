#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

// What a JSON value may be, as data. The loader's checks, the defaults and the published JSON Schema are all made from
// the same tables, so they cannot disagree.
namespace scenarios::drill {

using nlohmann::json;

/// Types of a JSON value, to be or-ed. A whole number is an integer and a number.
enum Type : unsigned { boolean = 1, integer = 2, number = 4, text = 8, array = 16, object = 32 };

struct Key;

/// The allowed form of one value. A limit applies to values of its own type only, as in JSON Schema.
struct Schema {
    unsigned types = object;                   ///< Types allowed, or-ed.
    std::string types_words = {};              ///< Types as a message says them, where their names say too little.
    std::string about = {};                    ///< What the value is, in a sentence for editors.
    double low = 0, high = 0;                  ///< Numbers: least and greatest, both allowed, in `unit`.
    std::string unit = {};                     ///< Numbers: such as "mm"; empty for none.
    std::vector<json> choices = {};            ///< The only values allowed; empty: any.
    std::string why_only = {};                 ///< Why there are no other choices, the beginning of a message.
    std::string pattern = {};                  ///< Texts: extended regular expression; empty: any text.
    std::string pattern_words = {};            ///< Texts: the pattern as a message says it.
    std::size_t min_items = 0, max_items = 0;  ///< Arrays: fewest and most items.
    std::vector<Schema> items = {};            ///< Arrays: one schema, that of each item.
    std::vector<Key> keys = {};                ///< Objects: the keys that are known.
    std::vector<Schema> other_keys = {};       ///< Objects: one schema, that of the value at any other key, or none.
    std::vector<std::string> one_of = {};      ///< Objects: exactly one of these keys is given.
    std::size_t min_keys = 0;                  ///< Objects: fewest keys.
};

/// One key of an object.
struct Key {
    std::string name;         ///< As files have it.
    Schema schema;            ///< The form of its value.
    bool required = false;    ///< Whether an object without it is refused.
    json fallback = nullptr;  ///< Its value when it is absent; null: it stays absent.
};

constexpr std::size_t longest_text = 2000;  ///< Characters that any text may have.

/// What is wrong with a value, and where.
struct Problem {
    std::string pointer;  ///< JSON pointer (RFC 6901) to the value.
    std::string what;     ///< What is wrong and what would be right: the end of a message.
    bool at_key = false;  ///< The key is wrong, not the value.
};

/// The first thing wrong with `value`, or nothing.
std::optional<Problem> first_problem(const json& value, const Schema& schema);

/// `value`, which has no problem, with the defaults of absent keys filled in.
json with_defaults(const json& value, const Schema& schema);

/// `value`, which has no problem, with keys in the order of the table.
nlohmann::ordered_json in_table_order(const json& value, const Schema& schema);

/// The JSON text of a value, with what fits into a line on one line.
std::string laid_out(const nlohmann::ordered_json& value, std::size_t indent = 0);

/// The JSON Schema, draft 2020-12, of `schema`, without the "$schema" line.
nlohmann::ordered_json json_schema_of(const Schema& schema);

/// A number as people write it: shortest digits that give the same double.
std::string shown(double value);

}  // namespace scenarios::drill
