#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "scenarios/drill/drill.hpp"
#include "tests/scenarios/drill/sample.hpp"

using nlohmann::json;

namespace {

// JSON Schema draft 2020-12, the keywords that our schema uses; written from the specification and without any of the
// loader's code, so that the two can disagree. Throws on a keyword it does not know.
bool accepts(const json& schema, const json& value);

bool is_type(const std::string& type, const json& value) {
    if (type == "integer") return value.is_number() && value.get<double>() == std::floor(value.get<double>());
    if (type == "number") return value.is_number();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "array") return value.is_array();
    if (type == "object") return value.is_object();
    throw std::logic_error("type " + type);
}

bool type_fits(const json& types, const json& value) {
    if (types.is_string()) return is_type(types, value);
    return std::any_of(types.begin(), types.end(), [&](const json& type) { return is_type(type, value); });
}

std::size_t length(const std::string& utf8) {
    return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

bool object_fits(const json& schema, const json& value) {
    for (const auto& [key, inner] : value.items()) {
        if (schema.contains("properties") && schema["properties"].contains(key)) {
            if (!accepts(schema["properties"][key], inner)) return false;
        } else if (schema.contains("additionalProperties") && !accepts(schema["additionalProperties"], inner)) {
            return false;
        }
    }
    return true;
}

// Compiled once: that takes longer than all else here.
const std::regex& regex_of(const std::string& pattern) {
    static std::map<std::string, std::regex> known;
    const auto found = known.find(pattern);
    return found != known.end() ? found->second : known.emplace(pattern, pattern).first->second;
}

bool keyword_fits(const std::string& keyword, const json& limit, const json& schema, const json& value) {
    if (keyword == "type") return type_fits(limit, value);
    if (keyword == "enum") return std::find(limit.begin(), limit.end(), value) != limit.end();
    if (keyword == "minimum") return !value.is_number() || value.get<double>() >= limit.get<double>();
    if (keyword == "maximum") return !value.is_number() || value.get<double>() <= limit.get<double>();
    if (keyword == "minLength") return !value.is_string() || length(value) >= limit.get<std::size_t>();
    if (keyword == "maxLength") return !value.is_string() || length(value) <= limit.get<std::size_t>();
    if (keyword == "pattern")
        return !value.is_string() || std::regex_search(value.get<std::string>(), regex_of(limit.get<std::string>()));
    if (keyword == "minItems") return !value.is_array() || value.size() >= limit.get<std::size_t>();
    if (keyword == "maxItems") return !value.is_array() || value.size() <= limit.get<std::size_t>();
    if (keyword == "items")
        return !value.is_array() ||
               std::all_of(value.begin(), value.end(), [&](const json& v) { return accepts(limit, v); });
    if (keyword == "required")
        return !value.is_object() ||
               std::all_of(limit.begin(), limit.end(), [&](const json& k) { return value.contains(k); });
    if (keyword == "properties" || keyword == "additionalProperties")
        return !value.is_object() || object_fits(schema, value);
    if (keyword == "minProperties") return !value.is_object() || value.size() >= limit.get<std::size_t>();
    if (keyword == "oneOf")
        return std::count_if(limit.begin(), limit.end(), [&](const json& s) { return accepts(s, value); }) == 1;
    if (keyword == "description" || keyword == "default" || keyword == "title" || keyword == "$schema") return true;
    throw std::logic_error("keyword " + keyword);
}

bool accepts(const json& schema, const json& value) {
    if (schema.is_boolean()) return schema.get<bool>();
    for (const auto& [keyword, limit] : schema.items())
        if (!keyword_fits(keyword, limit, schema, value)) return false;
    return true;
}

std::string contents(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

}  // namespace

// Editors read the committed file; if it lags behind the loader they underline good drills and pass bad ones.
TEST(DrillSchema, CommittedFileIsWhatTheProgramPrints) {
    EXPECT_EQ(contents(std::string(CARREL_SOURCE) + "/scenarios/drills/schema/drill.schema.json"),
              scenarios::drill::published_schema())
        << "write it again: carrel validate --schema > scenarios/drills/schema/drill.schema.json";
}

// A drill with a value at every kind of key.
json full_drill() {
    json document = json::parse(sample::drill);
    document["motion"] = "a.csv";
    document["thread"].update({{"links", 50},
                               {"material", "silk"},
                               {"model", "elastic"},
                               {"yield_percent", 4},
                               {"start_mm", {{0, 0, 9}, {0, 150, 9}}},
                               {"young_MPa", 100}});
    document["vessels"][0].update({{"held", {"start"}}, {"axis", {0, 1, 0}}});
    document["effects"].update({{"gravity", true},
                                {"bending", true},
                                {"extension", false},
                                {"inertia", false},
                                {"plastic_set", true},
                                {"twist", false}});
    document["bands"].update({{"time_s", {0, 60}}, {"grasps", {{"right", {1, 6}}}}});
    document["pace"] = 0.5;
    document["steps"] = {{{"text", "Grasp the strand."},
                          {"done",
                           {{"held", {{"left", "thread"}}},
                            {"near", {{"right", {{"place_mm", {0, 0, 9}}, {"within_mm", 3}}}}},
                            {"event", {{"kind", "grasp"}, {"what", "left"}}},
                            {"knot", "overhand"},
                            {"throws", 1}}},
                          {"reference_s", {0, 1}}}};
    return document;
}

// Pointers to all values of a document, objects and lists among them.
std::vector<std::string> pointers_in(const json& document) {
    const json flat = document.flatten();
    std::vector<std::string> pointers;
    for (const auto& [pointer, value] : flat.items())
        for (std::string at = pointer; !at.empty(); at = at.substr(0, at.rfind('/')))
            if (std::find(pointers.begin(), pointers.end(), at) == pointers.end()) pointers.push_back(at);
    return pointers;
}

// Values of each type, and around the limits of a drill's keys.
const json others[] = {nullptr,
                       true,
                       false,
                       0,
                       1,
                       -1,
                       2.5,
                       5000,
                       5001,
                       1e9,
                       1e300,
                       "",
                       "x",
                       "square",
                       "2=1",
                       std::string(2001, 'x'),
                       json::array(),
                       {1, 2},
                       {2, 1, 3},
                       {1, 2, 3, 4},
                       json::object(),
                       {{"max", 3}},
                       {{"left", {{"max", 3}}}},
                       {{"file", "a.obj"}}};

// Whether a message is of what only the loader can know.
bool is_of_a_relation(const std::string& message) {
    for (const char* words : {"no vessel is named",
                              "no instrument has",
                              "named twice",
                              "above",
                              "less than half",
                              "has no direction",
                              "needs a vessel",
                              "has no throws",
                              " for \"",
                              "shorter than",
                              "the path is",
                              "from here to",
                              "corner before it",
                              "moved by ftl",
                              "an elastic thread bends",
                              "nothing is known of",
                              "instrument is named",
                              "outside of the scene",
                              "not before",
                              "expected no such key",
                              "no needle",
                              "no wall to hold",
                              "expected \"knot\" in"})
        if (message.find(words) != std::string::npos) return true;
    return false;
}

// Every value of a drill is replaced, in turn, by values of each type and by values around its limits, every key is
// removed and a foreign one added: loader and schema must judge each document the same. What only the loader can know
// (names that refer to others, paths through vessels) says nothing of the form, so those messages count as accepted.
TEST(DrillSchema, JudgesAsTheLoaderDoes) {
    const json schema = json::parse(scenarios::drill::published_schema());
    const json document = full_drill();
    ASSERT_TRUE(accepts(schema, document));
    ASSERT_EQ(sample::message(document.dump()), "");

    int accepted = 0, refused = 0;
    const auto compare = [&](const json& changed) {
        const std::string message = sample::message(changed.dump());
        const bool fits = accepts(schema, changed), loads = message.empty() || is_of_a_relation(message);
        EXPECT_EQ(fits, loads) << changed.dump() << "\n" << message;
        ++(fits ? accepted : refused);
    };
    for (const std::string& pointer : pointers_in(document)) {
        const json::json_pointer at(pointer);
        for (const json& other : others) {
            json changed = document;
            changed[at] = other;
            compare(changed);
        }
        json removed = document;
        if (removed[at.parent_pointer()].is_object()) {
            removed[at.parent_pointer()].erase(at.back());
            compare(removed);
        }
        json added = document;
        if (added[at].is_object()) {
            added[at]["foreign"] = 1;
            compare(added);
        }
    }
    // Both answers must be common, or one of the two judges is asleep.
    EXPECT_GT(accepted, 100);
    EXPECT_GT(refused, 500);
}
