#pragma once
#include <gtest/gtest.h>

#include <string>

#include "scenarios/drill/drill.hpp"

namespace sample {

/// The smallest drill with something in every part; tests change one place of it.
inline const std::string drill = R"({
  "carrel_drill": 1,
  "title": "Square knot",
  "thread": {
    "size": "6-0",
    "length_mm": 150,
    "friction": 0.2
  },
  "vessels": [
    {"name": "carotid", "tube": {"diameter_mm": 4, "wall_mm": 0.6, "length_mm": 30}}
  ],
  "instruments": [
    {"name": "left", "kind": "forceps"},
    {"name": "right", "kind": "needle_holder"}
  ],
  "effects": {"gravity": false},
  "goals": [{"tie": "square", "around": "carotid", "throws": 2, "tails_mm": [3, 8]}],
  "bands": {"path_mm": {"left": {"max": 900}}, "tension_N": [0.1, 1]},
  "time_limit_s": 120
}
)";

/// The drill with `from`, which must be there, replaced by `to`.
inline std::string with(const std::string& from, const std::string& to) {
    std::string text = drill;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// The drill with another vessel, a needle, walls that give way, and these bands.
inline std::string sewn(const std::string& bands) {
    std::string text =
        with("\"friction\": 0.2",
             R"("needle": {"code": "BV-1", "tail_mm": [0, 0, 9], "towards": [0, 0, 1], "bulge": [0, -1, 0]})");
    const auto replace = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    replace(R"("length_mm": 30}})", R"("length_mm": 30}, "held": ["start"]}, )"
                                    R"({"name": "graft", "held": ["end"], "centre_mm": [0, 6, 0], )"
                                    R"("tube": {"diameter_mm": 4, "wall_mm": 0.6, "length_mm": 30}})");
    replace("{\"gravity\": false}", "{\"tissue\": \"elastic\"}");
    replace("\"bands\": {", "\"bands\": {" + bands + ", ");
    return text;
}

/// What is said of a text, or "" if it is a drill.
inline std::string message(const std::string& text) {
    try {
        scenarios::drill::parse_drill(text, "a.json", "");
        return "";
    } catch (const scenarios::drill::FileError& error) {
        return error.what();
    }
}

}  // namespace sample
