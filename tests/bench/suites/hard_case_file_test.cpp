#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scenarios/drill/file.hpp"
#include "scenarios/drill/waypoints.hpp"
#include "tests/bench/lab/hard_case.hpp"
#include "tests/bench/lab/trace.hpp"
#include "tests/bench/suites/stability.hpp"

namespace {

using namespace bench::lab;
using namespace bench::suites;
using nlohmann::json;

// A scene with everything that conditions look at: held ends, a tool, a wall, broken input.
const char* const small_scene = R"({
  "id": "small", "case": ["T41"], "goes_wrong": "Nothing.",
  "thread": {"links": 60, "start": {"shape": "overhand"}},
  "holds": [{"nodes": ["first"], "keys": [{"t_s": 0}, {"t_s": 0.02, "by_mm": [-3, 0, 0]}]},
            {"nodes": ["last"], "keys": [{"t_s": 0}, {"t_s": 0.02, "by_mm": [3, 0, 0]}]}],
  "tools": [{"a_mm": [-3, 0.3, 0], "b_mm": [3, 0.3, 0], "radius_mm": 0.01,
             "keys": [{"t_s": 0}, {"t_s": 0.03, "by_mm": [0, -0.3, 0]}]}],
  "tube": {"diameter_mm": 1, "wall_mm": 0.1, "length_mm": 5, "centre_mm": [0, 0, -1]},
  "broken_input": [{"input": "holds", "is": "nan", "from_s": 0.01, "to_s": 0.012}],
  "duration_s": 0.04,
  "expect": [{"is": "pass_throughs", "at_most": 0}]
})";

HardCase parsed(const json& scene) {
    return parse_hard_case(scene.dump(), "small.json");
}

std::string complaint(const json& patch) {
    json scene = json::parse(small_scene);
    scene.merge_patch(patch);
    try {
        parsed(scene);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

// The author of a scene must see where it is wrong and what would be right; whatever it is must not run as something
// else.
TEST(HardCaseFile, SaysWhatIsWrongAndWhere) {
    const std::pair<json, const char*> broken[] = {
        {{{"expect", {{{"is", "moved"}, {"at_most", 0}, {"known", "it moves"}}}}},
         "/expect/0: the key \"today\" is missing"},
        {{{"expect", {{{"is", "moved"}, {"at_most", 0}, {"today", 1}}}}},
         "/expect/0: \"today\" goes with \"known\" alone"},
        {{{"id", "other"}}, "/id: expected the file's name, \"small\""},
        {{{"tick_z", 0.001}}, "/tick_z: unknown key, did you mean \"tick_s\"?"},
        {{{"case", {"X1"}}}, "/case/0: expected \"E\" or \"T\" and a number"},
        {{{"duration_s", 0}}, "/duration_s: expected 1e-04 to 1000 s, found 0"},
        {{{"duration_s", 900}}, "/duration_s"},
        {{{"thread", {{"links", nullptr}}}}, "/thread: the key \"links\" is missing"},
        {{{"thread", {{"start", {{"shape", "curve"}}}}}}, "/thread/start: the key \"file\" is missing"},
        {{{"thread", {{"start", {{"shape", "curve"}, {"file", "nowhere.xyz"}}}}}}, "/thread/start/file: nowhere.xyz"},
        {{{"thread", {{"start", {{"shape", "points"}, {"points_mm", {{0, 0, 0}, {0, 0, 0}}}}}}}},
         "points 0 and 1 are the same place"},
        {{{"drill", "d.json"}}, "expected exactly one of the keys \"thread\" and \"drill\""},
        {{{"holds", {{{"nodes", {61}}}}}}, "/holds/0/nodes: expected less than the thread's 61 nodes, found 61"},
        {{{"holds", {{{"nodes", {"middle"}}}}}}, "/holds/0/nodes/0: expected a number, \"first\""},
        {{{"holds", {{{"nodes", {1}}, {"keys", {{{"t_s", 1}}, {{"t_s", 1}}}}}}}},
         "/holds/0/keys/1/t_s: expected later"},
        {{{"holds", {{{"nodes", {1}}, {"from_s", 1}, {"to_s", 0}}}}}, "/holds/0/to_s: expected not before from_s"},
        {{{"holds", {{{"nodes", {1}}, {"axis", {0, 0, 0}}}}}}, "/holds/0/axis: expected a direction"},
        {{{"cuts", {{{"t_s", 0}, {"after", "last"}}}}},
         "/cuts/0/after: expected less than the last of the thread's 61 nodes"},
        {{{"tube", {{"wall_mm", 0.6}}}}, "/tube/wall_mm: expected less than half of diameter_mm"},
        {{{"broken_input", {{{"input", "left"}, {"is", "nan"}}}}},
         "/broken_input/0/input: expected \"holds\" or \"tools\""},
        {{{"broken_input", {{{"input", "holds"}, {"is", "leap"}}}}},
         "/broken_input/0/is: expected \"nan\" or \"infinite\""},
        {{{"expect", json::array()}}, "/expect: expected a list of 1 to 60 items, found 0"},
        {{{"expect", {{{"is", "good"}, {"at_most", 0}}}}}, "/expect/0/is"},
        {{{"expect", {{{"is", "moved"}}}}},
         "/expect/0: expected exactly one of the keys \"at_most\" and \"at_least\", found 0"},
        {{{"expect", {{{"is", "moved"}, {"at_most", 1}, {"from_s", 1}}}}},
         "/expect/0/from_s: expected less than duration_s"},
        {{{"expect", {{{"is", "moved"}, {"at_most", 1}, {"node", 99}}}}}, "/expect/0/node: expected less than"},
        {{{"expect", {{{"is", "tool_moved"}, {"at_most", 1}, {"part", 1}}}}},
         "/expect/0/part: expected less than the 1 tool parts"},
        {{{"expect", {{{"is", "knot_differs"}, {"at_most", 0}}}}}, "the key \"knot\" is missing"},
        {{{"expect", {{{"is", "events"}, {"at_most", 0}}}}}, "the key \"event\" is missing"},
        {{{"model", "elastic"}}, "/model: goes with \"drill\" alone"},
        {{{"expect", {{{"is", "moved"}, {"at_most", 1}, {"model", "elastic"}}}}},
         "/expect/0/model: expected that of a variant"},
        {{{"variants", {{{"thread", {{"links", 0}}}}}}},
         "/variants/0: makes /thread/links: expected 1 to 5000, found 0"},
        {{{"variants", {1}}}, "/variants: expected a list of up to 20 objects"},
    };
    for (const auto& [patch, words] : broken) {
        const std::string said = complaint(patch);
        EXPECT_NE(said.find(words), std::string::npos) << patch << "\nsaid: " << said;
        EXPECT_EQ(said.rfind("small.json:", 0), 0u) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
}

// Someone edits the steps that a person reads, or the motion that is played: either way they no longer say the same.
class Motions : public testing::TestWithParam<const char*> {};

TEST_P(Motions, MoveAsTheirWaypointsSay) {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GetParam())) {
        std::filesystem::path file = entry.path();
        if (file.extension() != ".waypoints") continue;
        const auto waypoints = scenarios::drill::load_waypoints(file);
        constexpr std::size_t most_bytes = 4 << 20;  // a quarter of an hour of five tools takes one
        EXPECT_EQ(scenarios::drill::motion_text(waypoints.motion, waypoints.instruments),
                  scenarios::drill::read_text(file.replace_extension(".csv"), most_bytes))
            << file;
        ++count;
    }
    EXPECT_GT(count, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, Motions,
                         testing::Values(CARREL_SOURCE "/tests/hard_cases", CARREL_SOURCE "/scenarios/drills"));

// A condition that cannot fail proves nothing. Each kind, asked for less and for more than what it measures, must miss
// once and only once; and be no number that every bound lets pass.
TEST(HardCaseConditions, EachCanFail) {
    json scene = json::parse(small_scene);
    scene["expect"] = json::array();
    for (const ConditionKind& kind : condition_kinds()) {
        json condition{{"is", kind.name}, {"at_most", 0}, {"factor", 2}};
        if (std::string(kind.name) == "knot_differs") condition["knot"] = "4_1";
        if (std::string(kind.name) == "events") condition["event"] = "pierced";
        scene["expect"].push_back(condition);
    }
    for (Outcome outcome : examine(parsed(scene))) {
        SCOPED_TRACE(outcome.condition.is);
        ASSERT_TRUE(std::isfinite(outcome.value));
        for (const Must must : {Must::be_at_most, Must::be_at_least}) {
            outcome.condition.must = must;
            outcome.condition.bound = outcome.value + (must == Must::be_at_most ? -1 : 1);
            EXPECT_FALSE(outcome.holds());
            outcome.condition.bound = outcome.value;
            EXPECT_TRUE(outcome.holds());
        }
    }
}

double measured(json condition, const json& patch = json::object()) {
    json scene = json::parse(small_scene);
    scene.merge_patch(patch);
    condition["at_most"] = 0;
    scene["expect"] = {condition};
    return examine(parsed(scene)).front().value;
}

// What a scene says to be broken, lagging, moved, stretched or another knot must show in the figure.
TEST(HardCaseConditions, FiguresTellWhatHappens) {
    EXPECT_EQ(measured({{"is", "not_finite_reported"}}), 3);
    EXPECT_EQ(measured({{"is", "not_finite_reported"}}, {{"broken_input", json::array()}}), 0);
    EXPECT_EQ(measured({{"is", "knot_differs"}, {"knot", "3_1"}}), 0);
    EXPECT_EQ(measured({{"is", "knot_differs"}, {"knot", "0_1"}}), 1);
    EXPECT_GT(measured({{"is", "lag_final"}}), 0.1);
    EXPECT_GT(measured({{"is", "tension_max"}}), 0);
    EXPECT_GT(measured({{"is", "moved"}, {"node", "first"}}), 1);
    EXPECT_LT(measured({{"is", "separation_measured"}}), 1.1);
    EXPECT_GT(measured({{"is", "unbroken_differs"}},
                       {{"broken_input", {{{"input", "holds"}, {"is", "nan"}, {"from_s", 0.01}}}}}),
              0);
    EXPECT_EQ(measured({{"is", "hash_differs"}}), 0);
    EXPECT_EQ(measured({{"is", "mirrored_apart"}}), 0);
    const json elastic{{"thread", {{"model", "elastic"}}}, {"broken_input", json::array()}};
    EXPECT_GT(measured({{"is", "energy_rise"}}, elastic), 0);  // hands pull
    EXPECT_GT(measured({{"is", "energy_left"}}, elastic), 0);
    EXPECT_GT(measured({{"is", "ticked_apart"}, {"factor", 4}}, elastic), 0);
    EXPECT_EQ(measured({{"is", "ticked_apart"}, {"factor", 1}}, elastic), 0);
}

// A bound for one kind of thread must neither fail the other nor hide it.
TEST(HardCaseConditions, AreAskedOfTheirModelAlone) {
    json scene = json::parse(small_scene);
    scene["variants"] = {{{"thread", {{"model", "elastic"}}}}};
    scene["expect"] = {{{"is", "tension_max"}, {"at_most", 0}, {"model", "ftl"}},
                       {{"is", "tension_max"}, {"at_most", 0}, {"model", "elastic"}},
                       {{"is", "tension_max"}, {"at_most", 0}}};
    const HardCase hard_case = parsed(scene);
    const std::vector<Outcome> all = examine(hard_case), first = examine(hard_case, true);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_NE(all[0].value, all[1].value);
    EXPECT_EQ(all[2].value, std::max(all[0].value, all[1].value));
    ASSERT_EQ(first.size(), 2u) << "what no variant that is played is asked";
    EXPECT_EQ(first[0].value, all[0].value);
    EXPECT_EQ(first[1].value, all[0].value);
}

// The worst of all variants counts, and `carrel bench --quick` leaves them out.
TEST(Stability, HasARowAConditionAndCountsTheWorstVariant) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "carrel-hard-cases";
    std::filesystem::create_directories(folder);
    json scene = json::parse(small_scene);
    scene["variants"] = {{{"duration_s", 0.01}, {"broken_input", nullptr}},
                         {{"broken_input", {{{"input", "tools"}, {"is", "nan"}}}}}};
    scene["expect"] = {{{"is", "not_finite_reported"}, {"at_most", 3}},
                       {{"is", "moved"}, {"at_least", 0}},
                       {{"is", "moved"}, {"at_least", 0}, {"node", 3}}};
    std::ofstream(folder / "small.json") << scene;
    std::vector<std::string> told;
    const std::vector<Row> whole =
        hard_case_rows(folder, false, [&](const std::string& line) { told.push_back(line); });
    ASSERT_EQ(whole.size(), 3u);
    EXPECT_EQ(told, std::vector<std::string>{"small"});
    EXPECT_EQ(whole[0].id, "small-not-finite-reported");
    EXPECT_EQ(whole[0].value, 40);
    EXPECT_FALSE(whole[0].pass());
    EXPECT_EQ(whole[0].unit, "ticks");
    EXPECT_GT(whole[0].seconds, 0);
    EXPECT_EQ(whole[2].id, "small-moved-2");
    const std::vector<Row> quick = hard_case_rows(folder, true, {});
    EXPECT_EQ(quick[0].value, 3);
    EXPECT_TRUE(quick[0].pass());
    std::filesystem::remove_all(folder);
}

}  // namespace
