#include "tests/bench/lab/hard_case_keys.hpp"

#include "tests/bench/lab/trace.hpp"

namespace bench::lab {

using namespace scenarios::drill;

namespace {

Schema quantity(double low, double high, const std::string& unit = "") {
    return {.types = number, .low = low, .high = high, .unit = unit};
}
Schema count(double low, double high) {
    return {.types = integer, .low = low, .high = high};
}
Schema words() {
    return {.types = text};
}
Schema word(const std::string& pattern, const std::string& in_words) {
    return {.types = text, .pattern = pattern, .pattern_words = in_words};
}
Schema choice(std::vector<json> choices) {
    return {.types = text, .choices = std::move(choices)};
}
Schema list(std::size_t min_items, std::size_t max_items, Schema item) {
    return {.types = array, .min_items = min_items, .max_items = max_items, .items = {std::move(item)}};
}
Schema group(std::vector<Key> keys) {
    return {.types = object, .keys = std::move(keys)};
}

Schema millimetres() {
    return quantity(-10000, 10000, "mm");
}
Schema seconds() {
    return quantity(0, 1000, "s");
}
Schema point() {
    return list(3, 3, millimetres());
}
Schema tool() {
    return count(-1, 9);
}

Schema node() {
    Schema schema = word("^(first|last|[0-9]{1,2}%)$", "a number, \"first\", \"last\" or a share such as \"50%\"");
    schema.types |= integer;
    schema.low = 0, schema.high = 1e5;
    return schema;
}

Schema start() {
    return group({{"shape", choice({"straight", "overhand", "tied", "curve", "coil", "folded", "points"}), true},
                  {"throws", word("^[1-4]([=x][1-4])*$", "throws such as \"1=1\"")},
                  {"file", words()},
                  {"turns", quantity(0.1, 200)},
                  {"radius_mm", quantity(1e-4, 1000, "mm")},
                  {"pitch_mm", quantity(1e-4, 1000, "mm")},
                  {"folds", count(1, 100)},
                  {"length_mm", quantity(1e-3, 10000, "mm")},
                  {"gap_mm", quantity(0, 1000, "mm")},
                  {"points_mm", list(2, 2000, point())}});
}

Schema thread() {
    return group({{"model", choice({"ftl", "elastic"}), false, "ftl"},
                  {"radius_mm", quantity(1e-4, 10, "mm"), false, 0.0425},
                  {"friction", quantity(0, 10), false, 0.15},
                  {"friction_tool", quantity(0, 10), false, 0.15},
                  {"axial_stiffness_N", quantity(1e-6, 1e9, "N"), false, 15.9},
                  {"axial_over_bending", quantity(0, 1e9), false, 0},
                  {"keeps_shape", {.types = boolean}, false, false},
                  {"break_N", quantity(1e-6, 1e6, "N")},
                  {"links", count(1, 5000)},
                  {"link_over_diameter", quantity(1e-3, 100), false, 1},
                  {"short_link", group({{"after", node(), true}, {"share", quantity(1e-9, 0.5), true}})},
                  {"start", start(), true}});
}

std::vector<Key> way_keys() {
    const Schema key = group({{"t_s", seconds(), true},
                              {"by_mm", point(), false, json{0, 0, 0}},
                              {"turn_deg", quantity(-1e5, 1e5, "degrees"), false, 0}});
    return {{"tool", tool(), false, -1},
            {"axis", list(3, 3, quantity(-1, 1)), false, json{1, 0, 0}},
            {"keys", list(0, 1000, key), false, json::array()}};
}

Schema hold() {
    std::vector<Key> keys = way_keys();
    keys.push_back({"nodes", list(1, 50, node()), true});
    keys.push_back({"from_s", seconds(), false, 0});
    keys.push_back({"to_s", seconds()});
    keys.push_back({"chatter", group({{"period_s", quantity(1e-4, 10, "s"), true}, {"phase_s", seconds(), false, 0}})});
    return group(std::move(keys));
}

Schema tool_part() {
    std::vector<Key> keys = way_keys();
    keys.push_back({"a_mm", point(), true});
    keys.push_back({"b_mm", point(), true});
    keys.push_back({"radius_mm", quantity(1e-4, 100, "mm"), true});
    return group(std::move(keys));
}

Schema tube() {
    return group({{"diameter_mm", quantity(1e-3, 100, "mm"), true},
                  {"wall_mm", quantity(1e-4, 50, "mm"), true},
                  {"length_mm", quantity(1e-3, 1000, "mm"), true},
                  {"sides", count(3, 200), false, 32},
                  {"along", choice({"x", "y", "z"}), false, "x"},
                  {"centre_mm", point(), false, json{0, 0, 0}}});
}

Schema fault() {
    return group({{"input", word("^[a-z][a-z0-9_-]{0,39}$", "\"holds\", \"tools\" or an instrument"), true},
                  {"is",
                   choice({"nan", "infinite", "zero_rotation", "long_rotation", "flipped_rotation", "frozen", "leap",
                           "sampled"}),
                   true},
                  {"from_s", seconds(), false, 0},
                  {"to_s", seconds()},
                  {"by_mm", point(), false, json{0, 0, 0}},
                  {"hz", quantity(1, 10000, "Hz"), false, 30}});
}

std::vector<json> event_names() {
    std::vector<json> names;
    for (const scenarios::world::EventWords& words : scenarios::world::event_words) names.emplace_back(words.name);
    return names;
}

Schema condition() {
    std::vector<json> names;
    for (const ConditionKind& kind : condition_kinds()) names.emplace_back(kind.name);
    Schema schema = group({{"is", choice(std::move(names)), true},
                           {"at_most", quantity(-1e12, 1e12)},
                           {"at_least", quantity(-1e12, 1e12)},
                           {"from_s", seconds(), false, 0},
                           {"to_s", seconds()},
                           {"node", node()},
                           {"part", count(0, 99), false, 0},
                           {"vessel", count(-1, 15), false, -1},
                           {"factor", quantity(1e-6, 1e6), false, 1},
                           {"knot", words()},
                           {"event", choice(event_names())},
                           {"model", choice({"ftl", "elastic"})},
                           {"known", words()},
                           {"today", quantity(-1e12, 1e12)}});
    schema.one_of = {"at_most", "at_least"};
    return schema;
}

}  // namespace

const Schema& hard_case_schema() {
    static const Schema schema = group(
        {{"id", word("^[a-z0-9]+(-[a-z0-9]+)*$", "letters a-z, digits and '-'"), true},
         {"case", list(1, 20, word("^[ET][0-9]{1,2}$", "\"E\" or \"T\" and a number")), true},
         {"goes_wrong", words(), true},
         {"why", words()},
         {"thread", thread()},
         {"drill", words()},
         {"model", choice({"ftl", "elastic"})},
         {"holds", list(0, 100, hold()), false, json::array()},
         {"tools", list(0, 100, tool_part()), false, json::array()},
         {"tube", tube()},
         {"cuts",
          list(0, 100, group({{"t_s", seconds(), true}, {"after", node(), true}, {"share", quantity(0, 1), false, 0}})),
          false, json::array()},
         {"broken_input", list(0, 20, fault()), false, json::array()},
         {"tick_s", quantity(1e-5, 1, "s"), false, 1e-3},
         {"duration_s", quantity(1e-4, 1000, "s"), true},
         {"expect", list(1, 60, condition()), true}});
    return schema;
}

}  // namespace bench::lab
