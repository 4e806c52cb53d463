#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "scenarios/drill/materials.hpp"
#include "scenarios/drill/needles.hpp"
#include "scenarios/drill/score.hpp"
#include "tests/scenarios/drill/sample.hpp"

// Every scored item with its value, its unit and its moment: by the moment a resident is led to a fault in the
// recording. Each measure has a moment of its own, so that no item can show another's.
namespace items {

using namespace scenarios;

struct Shown {
    std::string value, unit;
    double at_s;

    bool operator==(const Shown&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Shown& shown) {
    return out << shown.value << " [" << shown.unit << "] at " << shown.at_s << " s";
}

world::Measures measured() {
    world::Measures m;
    m.knot.knot = "3_1#m3_1";
    m.knot.surgical = "square";
    m.knot.throws = "1=1";
    m.knot.factors.resize(2);
    m.knot.throw_list.resize(2);
    m.knot_since_s = 11.25;
    m.tail_mm = {7.126, 4.254};
    m.around = {"carotid"};
    m.loop_mm = 13.517, m.knot_mm = 1.204, m.off_tissue_mm = 0.318;
    m.duration_s = 34.56;
    m.path_mm = {412.34, 876.54};
    m.grasps = {2, 3};
    m.tension_max_N = {0.8064, 21.5};
    m.lag_max_mm = {{0.123, 3.25}, {0.456, 4.75}};
    m.pass_throughs = 2, m.first_pass_through_s = 7.875;
    m.needle_deg = world::Moment{81.4, 5.5};
    m.bites = {{"carotid", "outer", "inner", 1.236, 0.5, 78.6}, {"graft", "inner", "outer", 1.044, 0.5, 84.2}};
    m.bites[0].at_s = 8.125, m.bites[1].at_s = 9.375;
    m.join = {0.1246, 0.934, 81.376, {{"tear", "hole", 3.518, 2, false, true}, {"overlap", "overlap", 0.4, 1}}};
    return m;
}

std::map<std::string, Shown> shown(const std::string& text, const world::Measures& m) {
    std::map<std::string, Shown> all;
    for (const drill::ScoreItem& item : drill::score(drill::parse_drill(text, "a.json", ""), m))
        EXPECT_TRUE(all.emplace(item.name, Shown{item.value, item.unit, item.at_s}).second) << item.name << " twice";
    return all;
}

void expect_items(const std::map<std::string, Shown>& expected, const std::string& text, const world::Measures& m) {
    const auto found = shown(text, m);
    for (const auto& [name, item] : expected) {
        ASSERT_TRUE(found.contains(name)) << name;
        EXPECT_EQ(found.at(name), item) << name;
    }
    for (const auto& [name, item] : found) EXPECT_TRUE(expected.contains(name)) << name << " is in no table";
}

TEST(ScoreItems, EachHasItsOwnValueUnitAndMoment) {
    const std::string text = sample::sewn(R"("bites": [2, 2], "gap_mm": {"max": 1})");
    std::map<std::string, Shown> expected{{"knot", {"square", "", 11.25}},
                                          {"throws", {"2", "", 11.25}},
                                          {"tail_short", {"4.25", "mm", 11.25}},
                                          {"tail_long", {"7.13", "mm", 11.25}},
                                          {"around", {"carotid", "", 11.25}},
                                          {"form", {"flat", "", 11.25}},
                                          {"loop", {"13.52", "mm", 11.25}},
                                          {"knot_thread", {"1.20", "mm", 11.25}},
                                          {"off_tissue", {"0.32", "mm", 11.25}},
                                          {"needle_angle", {"81", "degrees", 5.5}},
                                          {"bite_1", {"outer to inner", "", 8.125}},
                                          {"bite_size_1", {"1.24", "mm", 8.125}},
                                          {"bite_angle_1", {"79", "degrees", 8.125}},
                                          {"bite_2", {"inner to outer", "", 9.375}},
                                          {"bite_size_2", {"1.04", "mm", 9.375}},
                                          {"bite_angle_2", {"84", "degrees", 9.375}},
                                          {"bites", {"2", "", 34.56}},
                                          {"gap", {"0.12", "mm", 34.56}},
                                          {"lumen", {"0.93", "", 34.56}},
                                          {"leak", {"81.38", "mL/min", 34.56}},
                                          {"lapses", {"1", "", 34.56}},
                                          {"lapse: tear", {"yes", "", 34.56}},
                                          {"lapse: overlap", {"no", "", 34.56}},
                                          {"time", {"34.6", "s", 34.56}},
                                          {"path_left", {"412.3", "mm", 34.56}},
                                          {"path_right", {"876.5", "mm", 34.56}},
                                          {"grasps_left", {"2", "", 34.56}},
                                          {"grasps_right", {"3", "", 34.56}},
                                          {"tension", {"0.81", "N", 21.5}},
                                          {"lag_left", {"0.12", "mm", 3.25}},
                                          {"lag_right", {"0.46", "mm", 4.75}},
                                          {"walls_crossed", {"1", "", 6.625}},
                                          {"pass_throughs", {"2", "", 7.875}}};
    world::Measures m = measured();
    m.walls_crossed = 1, m.first_crossed_s = 6.625;
    expect_items(expected, text, m);
    m.broke_s = 12.625;
    expected["broke"] = {"yes", "", 12.625};
    expect_items(expected, text, m);
    m.knot.flat = false;
    EXPECT_EQ(shown(text, m)["form"], (Shown{"capsized", "", 11.25}));
    m.needle_deg.reset();
    EXPECT_EQ(shown(sample::sewn("\"needle_deg\": [70, 90]"), m)["needle_angle"], (Shown{"never", "degrees", 34.56}));
    m.join = {};
    EXPECT_EQ(shown(text, m)["join"], (Shown{"none", "", 34.56}));
}

TEST(ScoreItems, OfSeveralKnotsEachHasItsOwnToo) {
    const std::string text = sample::with("\"around\": \"carotid\", \"throws\": 2", "\"throws\": 2, \"times\": 2");
    world::Measures m = measured();
    m.ties = {{m.knot, {3.126, 8.004}}, {m.knot, {4.5, 9.25}}};
    const auto found = shown(text, m);
    for (const auto& [name, item] : std::map<std::string, Shown>{{"knots", {"2", "", 34.56}},
                                                                 {"tails", {"0", "", 34.56}},
                                                                 {"tails_1", {"3.13 and 8.00", "mm", 34.56}},
                                                                 {"tails_2", {"4.50 and 9.25", "mm", 34.56}}})
        EXPECT_EQ(found.at(name), item) << name;
}

// USP <861>: middles of the ranges of limits on average diameter, class I synthetic absorbable and nonabsorbable;
// USP <881>: limits on average knot-pull tensile strength, nonabsorbable class I.
TEST(Materials, SizesAreThoseOfThePharmacopeia) {
    const struct {
        std::string name;
        double low_mm, high_mm, kgf;
    } table[] = {{"3-0", 0.20, 0.25, 0.96},    {"4-0", 0.15, 0.20, 0.60},    {"5-0", 0.10, 0.15, 0.40},
                 {"6-0", 0.070, 0.10, 0.20},   {"7-0", 0.050, 0.07, 0.11},   {"8-0", 0.040, 0.050, 0.06},
                 {"9-0", 0.030, 0.040, 0.043}, {"10-0", 0.020, 0.030, 0.019}};
    ASSERT_EQ(drill::sizes().size(), std::size(table));
    for (std::size_t i = 0; i < std::size(table); ++i) {
        const drill::Size& size = drill::sizes()[i];
        EXPECT_EQ(size.name, table[i].name);
        EXPECT_NEAR(size.diameter_mm, (table[i].low_mm + table[i].high_mm) / 2, 1e-12) << size.name;
        EXPECT_NEAR(size.break_N, 9.80665 * table[i].kgf, 0.02) << size.name;
        EXPECT_EQ(&drill::size_named(size.name), &size);
    }
}

// Moduli along and in bending, density, yield: Naleway 2015 for silk and polyglactin, handbooks for the others.
TEST(Materials, AreThoseOfTheirSources) {
    const struct {
        std::string name;
        double young_MPa, bending_young_MPa, density_kg_m3, yield_percent;
    } table[] = {{"polypropylene", 2800, 2800, 905, 4},
                 {"nylon", 2000, 2000, 1140, 0},
                 {"silk", 8700, 500, 1300, 0},
                 {"polyglactin", 9000, 500, 1500, 0}};
    ASSERT_EQ(drill::materials().size(), std::size(table));
    for (std::size_t i = 0; i < std::size(table); ++i) {
        const drill::Material& material = drill::materials()[i];
        EXPECT_EQ(material.name, table[i].name);
        EXPECT_EQ(material.young_MPa, table[i].young_MPa) << material.name;
        EXPECT_EQ(material.bending_young_MPa, table[i].bending_young_MPa) << material.name;
        EXPECT_EQ(material.density_kg_m3, table[i].density_kg_m3) << material.name;
        EXPECT_EQ(material.yield_percent, table[i].yield_percent) << material.name;
    }
}

// As makers sell them: share of a circle, length along the curve, wire. BV175-6 says 175 micrometres and 6-0 of thread.
TEST(Materials, NeedlesAreThoseOfTheirMaker) {
    const struct {
        std::string name;
        double circle, length_mm, wire_mm;
    } table[] = {{"BV75-3", 3.0 / 8, 3.8, 0.075},  {"BV100-4", 3.0 / 8, 5.1, 0.100}, {"BV130-5", 3.0 / 8, 6.5, 0.130},
                 {"BV175-6", 3.0 / 8, 8.0, 0.175}, {"BV-1", 3.0 / 8, 9.3, 0.20},     {"C-1", 3.0 / 8, 13, 0.35},
                 {"RB-1", 1.0 / 2, 17, 0.43},      {"SH", 1.0 / 2, 26, 0.60}};
    ASSERT_EQ(drill::needle_codes().size(), std::size(table));
    for (std::size_t i = 0; i < std::size(table); ++i) {
        const drill::NeedleCode& code = drill::needle_codes()[i];
        EXPECT_EQ(code.name, table[i].name);
        EXPECT_EQ(code.circle, table[i].circle) << code.name;
        EXPECT_NEAR(code.length, 1e-3 * table[i].length_mm, 1e-12) << code.name;
        EXPECT_NEAR(code.wire, 1e-3 * table[i].wire_mm, 1e-12) << code.name;
    }
}

// The limits and defaults of drill files, which a whole school's drills rely on: one changed by mistake makes files of
// last year mean something else.
const std::string thread = "/properties/thread/properties/", vessel = "/properties/vessels/items/properties/",
                  effects = "/properties/effects/properties/", bands = "/properties/bands/properties/";

nlohmann::json in_schema(const std::string& pointer) {
    return nlohmann::json::parse(drill::published_schema()).at(nlohmann::json::json_pointer(pointer));
}

TEST(DrillKeys, LimitsAreThese) {
    const struct {
        std::string pointer;
        double low, high;
    } limits[] = {{thread + "length_mm", 5, 1000},
                  {thread + "diameter_mm", 0.01, 1},
                  {thread + "young_MPa", 1, 300000},
                  {thread + "density_kg_m3", 500, 20000},
                  {thread + "break_N", 0.01, 200},
                  {thread + "friction", 0, 2},
                  {thread + "friction_tool", 0, 2},
                  {thread + "yield_percent", 0.1, 100},
                  {thread + "links", 2, 5000},
                  {thread + "shortest_link_mm", 0, 1000},
                  {thread + "contacts_per_tick", 0, 100000},
                  {vessel + "tube/properties/diameter_mm", 0.3, 60},
                  {vessel + "tube/properties/wall_mm", 0.02, 5},
                  {vessel + "tube/properties/length_mm", 1, 500},
                  {vessel + "tube/properties/cut_angle_deg", 45, 90},
                  {vessel + "mesh/properties/wall_mm", 0.02, 5},
                  {vessel + "young_MPa", 0.001, 10},
                  {vessel + "puncture_N", 0.001, 10},
                  {"/properties/instruments/items/properties/pull_N", 0.01, 100},
                  {"/properties/time_limit_s", 0.1, 7200},
                  {bands + "time_s/items", 0, 7200},
                  {bands + "tension_N/items", 0, 200},
                  {bands + "needle_deg/items", 0, 90},
                  {bands + "bites/items", 0, 1000},
                  {bands + "bite_mm/items", 0, 100},
                  {bands + "bite_deg/items", 0, 90},
                  {bands + "gap_mm/items", 0, 100},
                  {bands + "lumen/items", 0, 10},
                  {bands + "leak_mL_min/items", 0, 1e6},
                  {bands + "lapses/items", 0, 10},
                  {bands + "walls_crossed/items", 0, 1000}};
    for (const auto& [pointer, low, high] : limits) {
        const nlohmann::json value = in_schema(pointer);
        EXPECT_EQ(value.at("minimum"), low) << pointer;
        EXPECT_EQ(value.at("maximum"), high) << pointer;
    }
}

TEST(DrillKeys, DefaultsAreThese) {
    const std::pair<std::string, nlohmann::json> defaults[] = {{thread + "size", "6-0"},
                                                               {thread + "material", "polypropylene"},
                                                               {thread + "model", "ftl"},
                                                               {thread + "friction", 0.15},
                                                               {thread + "friction_tool", 0.15},
                                                               {thread + "contacts_per_tick", 0},
                                                               {vessel + "centre_mm", {0, 0, 0}},
                                                               {vessel + "axis", {1, 0, 0}},
                                                               {vessel + "held", {"start", "end"}},
                                                               {vessel + "young_MPa", 0.1},
                                                               {vessel + "puncture_N", 0.05},
                                                               {vessel + "tube/properties/cut_angle_deg", 90},
                                                               {effects + "gravity", false},
                                                               {effects + "plastic_set", false},
                                                               {effects + "air", false},
                                                               {effects + "tissue", "rigid"},
                                                               {"/properties/goals/items/properties/times", 1},
                                                               {bands + "pass_throughs", {{"max", 0}}}};
    for (const auto& [pointer, value] : defaults) EXPECT_EQ(in_schema(pointer + "/default"), value) << pointer;
}

}  // namespace items
