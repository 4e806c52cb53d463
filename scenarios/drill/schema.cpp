#include "scenarios/drill/schema.hpp"

#include <regex.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "scenarios/drill/json_text.hpp"
#include "scenarios/drill/nearest.hpp"

namespace scenarios::drill {

namespace {

using Found = std::optional<Problem>;

struct TypeName {
    Type type;
    const char* article;
    const char* json_schema;
};
constexpr TypeName type_names[] = {{boolean, "true or false", "boolean"},
                                   {integer, "a whole number", "integer"},
                                   {number, "a number", "number"},
                                   {text, "a text", "string"},
                                   {array, "a list", "array"},
                                   {object, "an object", "object"}};

// Largest double below which every whole number is one: beyond it "whole" says nothing.
constexpr double largest_whole = 9007199254740992.0;

unsigned types_of(const json& value) {
    if (value.is_boolean()) return boolean;
    if (value.is_string()) return text;
    if (value.is_array()) return array;
    if (value.is_object()) return object;
    if (!value.is_number()) return 0;
    const double x = value.get<double>();
    return x == std::floor(x) && std::abs(x) <= largest_whole ? number | integer : number;
}

std::string joined(const std::vector<std::string>& words) {
    std::string line;
    for (std::size_t i = 0; i < words.size(); ++i)
        line += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return line;
}

std::string shown(const json& value) {
    if (value.is_number_float()) return drill::shown(value.get<double>());
    if (value.is_null()) return "null";
    if (value.is_array()) return "a list of " + std::to_string(value.size());
    if (value.is_object()) return "an object";
    const std::string dumped = value.dump(-1, ' ', true, json::error_handler_t::replace);
    return dumped.size() > 60 ? dumped.substr(0, 56) + " ..." : dumped;
}

std::string kinds(unsigned types) {
    std::vector<std::string> names;
    for (const TypeName& name : type_names)
        if (types & name.type) names.push_back(name.article);
    return joined(names);
}

std::size_t characters(const std::string& utf8) {
    return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

Found check_number(double x, const Schema& schema, const std::string& pointer, const json& value) {
    if (x >= schema.low && x <= schema.high) return {};
    const std::string unit = schema.unit.empty() ? "" : " " + schema.unit;
    return Problem{pointer, "expected " + drill::shown(schema.low) + " to " + drill::shown(schema.high) + unit +
                                ", found " + shown(value)};
}

// POSIX's extended syntax and JSON Schema's agree on what the drills' patterns use; std::regex doubles the time that
// this file takes to compile.
bool matches(const std::string& text, const std::string& pattern) {
    regex_t regex;
    if (regcomp(&regex, pattern.c_str(), REG_EXTENDED | REG_NOSUB) != 0)
        throw std::logic_error("bad pattern " + pattern);
    regmatch_t whole{0, static_cast<regoff_t>(text.size())};  // a text may hold a zero
    const bool found = regexec(&regex, text.c_str(), 1, &whole, REG_STARTEND) == 0;
    regfree(&regex);
    return found;
}

Found check_text(const std::string& value, const Schema& schema, const std::string& pointer) {
    const std::size_t length = characters(value);
    if (length == 0) return Problem{pointer, "is empty, expected a text"};
    if (length > longest_text)
        return Problem{
            pointer, "has " + std::to_string(length) + " characters, expected at most " + std::to_string(longest_text)};
    if (schema.pattern.empty() || matches(value, schema.pattern)) return {};
    return Problem{pointer, "expected " + schema.pattern_words + ", found " + shown(json(value))};
}

Found check(const json& value, const Schema& schema, const std::string& pointer);

Found check_array(const json& value, const Schema& schema, const std::string& pointer) {
    if (value.size() < schema.min_items || value.size() > schema.max_items) {
        const std::string range = schema.min_items == schema.max_items
                                      ? std::to_string(schema.min_items)
                                      : std::to_string(schema.min_items) + " to " + std::to_string(schema.max_items);
        const std::string form = schema.types_words.empty() ? "a list of " + range + " items, found "
                                                            : schema.types_words + ", found a list of ";
        return Problem{pointer, "expected " + form + std::to_string(value.size())};
    }
    for (std::size_t i = 0; i < value.size(); ++i)
        if (auto problem = check(value[i], schema.items.front(), pointer + "/" + std::to_string(i))) return problem;
    return {};
}

const Key* find_key(const std::vector<Key>& keys, const std::string& name) {
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
    return found == keys.end() ? nullptr : &*found;
}

Found check_object(const json& value, const Schema& schema, const std::string& pointer) {
    for (const auto& [name, inner] : value.items()) {
        const Key* key = find_key(schema.keys, name);
        const std::string place = pointer + "/" + pointer_part(name);
        if (!key && schema.other_keys.empty()) {
            std::vector<std::string> known, missing;
            for (const Key& k : schema.keys) {
                known.push_back(k.name);
                if (!value.contains(k.name)) missing.push_back(k.name);
            }
            const std::string form = schema.types_words.empty() ? "" : "; expected " + schema.types_words;
            return Problem{place, unknown_key(name, known, missing) + form, true};
        }
        if (auto problem = check(inner, key ? key->schema : schema.other_keys.front(), place)) return problem;
    }
    for (const Key& key : schema.keys)
        if (key.required && !value.contains(key.name))
            return Problem{pointer, "the key \"" + key.name + "\" is missing"};
    if (value.size() < schema.min_keys) return Problem{pointer, "is empty, expected " + schema.types_words};
    const auto given =
        std::count_if(schema.one_of.begin(), schema.one_of.end(), [&](auto& k) { return value.contains(k); });
    if (!schema.one_of.empty() && given != 1)
        return Problem{pointer, "expected exactly one of the keys \"" + schema.one_of[0] + "\" and \"" +
                                    schema.one_of[1] + "\", found " + std::to_string(given)};
    return {};
}

std::string choices_in_words(const Schema& schema) {
    std::vector<std::string> allowed;
    for (const json& choice : schema.choices) allowed.push_back(shown(choice));
    return joined(allowed);
}

// Which of many choices a misspelt one is near to; of few that are listed anybody sees it.
std::string meant_by(const json& value, const Schema& schema) {
    constexpr std::size_t many = 6;
    std::vector<std::string> known;
    for (const json& choice : schema.choices)
        if (choice.is_string()) known.push_back(choice);
    const std::string close = value.is_string() && known.size() > many ? nearest(value, known) : "";
    return close.empty() ? "" : ", did you mean \"" + close + "\"?";
}

Found check(const json& value, const Schema& schema, const std::string& pointer) {
    const unsigned types = types_of(value);
    if (!(types & schema.types))
        return Problem{pointer, "expected " + (schema.types_words.empty() ? kinds(schema.types) : schema.types_words) +
                                    ", found " + shown(value)};
    if (!schema.choices.empty()) {
        if (std::find(schema.choices.begin(), schema.choices.end(), value) != schema.choices.end()) return {};
        return Problem{pointer, schema.why_only + "expected " + choices_in_words(schema) + ", found " + shown(value) +
                                    meant_by(value, schema)};
    }
    if (types & number) return check_number(value.get<double>(), schema, pointer, value);
    if (types & text) return check_text(value.get_ref<const std::string&>(), schema, pointer);
    if (types & array) return check_array(value, schema, pointer);
    if (types & object) return check_object(value, schema, pointer);
    return {};
}

// A whole number is written as one: "maximum": 5000, not 5000.0.
json limit(double x) {
    return types_of(json(x)) & integer ? json(static_cast<std::int64_t>(x)) : json(x);
}

}  // namespace

std::string shown(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::optional<Problem> first_problem(const json& value, const Schema& schema) {
    return check(value, schema, "");
}

json with_defaults(const json& value, const Schema& schema) {
    json filled = value;
    if (value.is_array())
        for (json& item : filled) item = with_defaults(item, schema.items.front());
    if (!value.is_object()) return filled;
    for (auto& [name, inner] : filled.items())
        if (!find_key(schema.keys, name)) inner = with_defaults(inner, schema.other_keys.front());
    for (const Key& key : schema.keys) {
        if (filled.contains(key.name))
            filled[key.name] = with_defaults(filled[key.name], key.schema);
        else if (!key.fallback.is_null())
            filled[key.name] = with_defaults(key.fallback, key.schema);
    }
    return filled;
}

nlohmann::ordered_json in_table_order(const json& value, const Schema& schema) {
    if (value.is_array() && !schema.items.empty()) {
        auto list = nlohmann::ordered_json::array();
        for (const json& item : value) list.push_back(in_table_order(item, schema.items.front()));
        return list;
    }
    if (!value.is_object()) return value;
    auto ordered = nlohmann::ordered_json::object();
    for (const Key& key : schema.keys)
        if (value.contains(key.name)) ordered[key.name] = in_table_order(value[key.name], key.schema);
    for (const auto& [name, inner] : value.items())
        if (!find_key(schema.keys, name)) ordered[name] = in_table_order(inner, schema.other_keys.front());
    return ordered;
}

std::string laid_out(const nlohmann::ordered_json& value, std::size_t indent) {
    const std::string line = value.dump();
    if (!value.is_structured() || indent + line.size() <= 100) return line;
    const std::string margin = "\n" + std::string(indent, ' ');
    std::string text;
    for (const auto& [key, inner] : value.items()) {
        text += (text.empty() ? "" : ",") + margin + "  ";
        text += (value.is_object() ? json(key).dump() + ": " : "") + laid_out(inner, indent + 2);
    }
    return value.is_object() ? "{" + text + margin + "}" : "[" + text + margin + "]";
}

nlohmann::ordered_json json_schema_of(const Schema& schema) {
    nlohmann::ordered_json json_schema;
    if (!schema.about.empty()) json_schema["description"] = schema.about;
    std::vector<std::string> types;
    for (const TypeName& name : type_names)
        if (schema.types & name.type) types.push_back(name.json_schema);
    if (types.size() == 1)
        json_schema["type"] = types.front();
    else
        json_schema["type"] = types;
    if (!schema.choices.empty()) {
        json_schema["enum"] = schema.choices;
        return json_schema;
    }
    if (schema.types & (number | integer)) {
        json_schema["minimum"] = limit(schema.low);
        json_schema["maximum"] = limit(schema.high);
    }
    if (schema.types & text) {
        json_schema["minLength"] = 1;
        json_schema["maxLength"] = longest_text;
        if (!schema.pattern.empty()) json_schema["pattern"] = schema.pattern;
    }
    if (schema.types & array) {
        json_schema["minItems"] = schema.min_items;
        json_schema["maxItems"] = schema.max_items;
        json_schema["items"] = json_schema_of(schema.items.front());
    }
    if (!(schema.types & object)) return json_schema;
    std::vector<std::string> required;
    for (const Key& key : schema.keys) {
        auto& inner = json_schema["properties"][key.name] = json_schema_of(key.schema);
        if (!key.fallback.is_null()) inner["default"] = key.fallback;
        if (key.required) required.push_back(key.name);
    }
    if (!required.empty()) json_schema["required"] = required;
    if (schema.min_keys > 0) json_schema["minProperties"] = schema.min_keys;
    for (const std::string& key : schema.one_of) json_schema["oneOf"].push_back({{"required", {key}}});
    if (schema.other_keys.empty())
        json_schema["additionalProperties"] = false;
    else
        json_schema["additionalProperties"] = json_schema_of(schema.other_keys.front());
    return json_schema;
}

}  // namespace scenarios::drill
