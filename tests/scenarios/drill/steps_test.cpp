#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scenarios/drill/history_key.hpp"
#include "tests/scenarios/drill/sample.hpp"

namespace {

using scenarios::drill::Drill;
using scenarios::drill::Held;
using scenarios::drill::parse_drill;

// The sample with these steps, written in one line behind its time limit.
std::string guided(const std::string& steps, const std::string& drill = sample::drill) {
    const std::string at = "\"time_limit_s\": 120";
    std::string text = drill;
    return text.replace(text.find(at), at.size(), at + ",\n  \"steps\": [" + steps + "]");
}

std::string step(const std::string& done, const std::string& more = "") {
    return R"({"text": "Do it.", "done": {)" + done + "}" + more + "}";
}

// What is said of a step that is done when this is, without file and place.
std::string complaint(const std::string& done, const std::string& drill = sample::drill) {
    const std::string said = sample::message(guided(step(done), drill)), before = "error: ";
    return said.empty() ? said : said.substr(said.find(before) + before.size());
}

}  // namespace

TEST(Steps, AreReadInSiByNumberOfInstrument) {
    const Drill drill = parse_drill(guided(step(R"("held": {"left": "thread", "right": "nothing"}, "throws": "1=1")",
                                                R"(, "reference_s": [1, 2])") +
                                           "," +
                                           step(R"("near": {"right": {"place_mm": [1, 2, 30], "within_mm": 4}}, )"
                                                R"("event": {"kind": "slip", "what": "left"})") +
                                           "," + step(R"("knot": "surgeons", "throws": 2)")),
                                    "a.json", "");
    ASSERT_EQ(drill.steps.size(), 3u);
    const auto& first = drill.steps[0];
    EXPECT_EQ(first.text, "Do it.");
    ASSERT_EQ(first.done.held.size(), 2u);
    EXPECT_EQ(first.done.held[0].instrument, 0u);
    EXPECT_EQ(first.done.held[0].what, Held::thread);
    EXPECT_EQ(first.done.held[1].instrument, 1u);
    EXPECT_EQ(first.done.held[1].what, Held::nothing);
    EXPECT_EQ(first.done.notation, "1=1");
    EXPECT_EQ(first.reference_s, (std::array{1.0, 2.0}));
    const auto& second = drill.steps[1].done;
    EXPECT_EQ(second.near.at(0).instrument, 1u);
    EXPECT_LT((second.near[0].place - scenarios::world::Vec3(0.001, 0.002, 0.03)).norm(), 1e-12);
    EXPECT_DOUBLE_EQ(second.near[0].within, 0.004);
    EXPECT_EQ(second.event->kind, scenarios::world::EventKind::slip);
    EXPECT_EQ(second.event->what, "left");
    EXPECT_FALSE(second.is_milestone());
    EXPECT_FALSE(drill.steps[1].reference_s);
    EXPECT_EQ(drill.steps[2].done.knot, "surgeon's");
    EXPECT_EQ(drill.steps[2].done.throws, 2);
    EXPECT_TRUE(drill.steps[2].done.is_milestone());
}

TEST(Steps, PaceIsOneUnlessTheDrillIsSlower) {
    EXPECT_EQ(parse_drill(sample::drill, "a.json", "").pace, 1);
    EXPECT_EQ(parse_drill(sample::with("\"time_limit_s\"", "\"pace\": 0.35, \"time_limit_s\""), "a.json", "").pace,
              0.35);
    for (const char* pace : {"0", "0.01", "1.5", "-1"})
        EXPECT_NE(
            sample::message(sample::with("\"time_limit_s\"", std::string("\"pace\": ") + pace + ", \"time_limit_s\""))
                .find("/pace: expected 0.05 to 1, found"),
            std::string::npos)
            << pace;
}

// An author of a drill learns where it is wrong and what would be right.
TEST(Steps, WhatCannotBeDoneIsRefusedInOneLine) {
    EXPECT_EQ(sample::message(guided(step(R"("held": {"lefft": "thread"})"))),
              "a.json:20:50: error: /steps/0/done/held/lefft: no instrument has this name, expected \"left\" or "
              "\"right\"");
    const std::pair<const char*, const char*> wrong[] = {
        {R"()", "/steps/0/done: is empty, expected one condition at least"},
        {R"("held": {})", "/steps/0/done/held: is empty, expected an instrument and what is asked of it"},
        {R"("held": {"left": "needle"})",
         "/steps/0/done/held/left: the thread has no needle to hold: give it one (\"needle\"), or ask for \"thread\""},
        {R"("held": {"left": "wall"})",
         "/steps/0/done/held/left: there is no wall to hold, expected vessels and \"tissue\": \"elastic\" in effects"},
        {R"("near": {"up": {"place_mm": [0, 0, 0], "within_mm": 1}})",
         "/steps/0/done/near/up: no instrument has this name, expected \"left\" or \"right\""},
        {R"("near": {"left": {"place_mm": [0, 0, 500], "within_mm": 1}})",
         "/steps/0/done/near/left/place_mm: is 488 mm outside of the scene, expected at most 100 mm from where thread "
         "and vessels begin"},
        {R"("event": {"kind": "slip", "what": "carotid"})",
         "/steps/0/done/event/what: no instrument is named \"carotid\", expected \"left\" or \"right\""},
        {R"("event": {"kind": "torn", "what": "left"})",
         "/steps/0/done/event/what: no vessel is named \"left\", expected \"carotid\""},
        {R"("event": {"kind": "break", "what": "left"})",
         "/steps/0/done/event/what: says nothing of \"break\", expected no such key"},
        {R"("event": {"kind": "knot", "what": "square"})",
         "/steps/0/done/event/what: expected \"knot\" in \"done\" for a knot of this name"},
        {R"("bites": 1)",
         "/steps/0/done/bites: there is no needle or no vessel to bite, expected both, or no such key"},
        {R"("throws": "one")",
         "/steps/0/done/throws: expected turns of each throw joined by '=' (reversed) or 'x' (same way), such as "
         "\"2=1\", found \"one\""},
        {R"("throws": -1)", "/steps/0/done/throws: expected 1 to 20, found -1"}};
    for (const auto& [done, said] : wrong) EXPECT_EQ(complaint(done), said);
}

TEST(Steps, AMisspeltKnotOrEventIsTakenForTheNearest) {
    for (const auto& [done, meant] : {std::pair(R"("knot": "sqare")", "square"),
                                      {R"("knot": "Surgeons")", "surgeons"},
                                      {R"("event": {"kind": "drown"})", "drawn"}}) {
        const std::string said = complaint(done), ending = std::string(", did you mean \"") + meant + "\"?";
        EXPECT_TRUE(said.ends_with(ending)) << said;
    }
}

TEST(Steps, ReferencesFollowOneAnother) {
    const auto with_references = [](const std::string& first, const std::string& second) {
        const std::string done = R"("throws": 1)", key = ", \"reference_s\": ";
        return sample::message(guided(step(done, key + first) + "," + step(done, key + second)));
    };
    EXPECT_EQ(with_references("[0, 1]", "[1, 2]"), "");
    EXPECT_NE(with_references("[0, 1]", "[0.5, 2]")
                  .find("/steps/1/reference_s: begins before the step before ends, expected 1 s or later, found 0.5"),
              std::string::npos);
    EXPECT_NE(with_references("[-1, 1]", "[1, 2]").find("/steps/0/reference_s/0: expected 0 to 7200 s, found -1"),
              std::string::npos);
    EXPECT_NE(with_references("[1, 1]", "[1, 2]").find("expected [begin, end], found 1 not before 1"),
              std::string::npos);
}

// Of the motion's length only the file of it knows.
TEST(Steps, ReferencesEndWithTheMotion) {
    namespace fs = std::filesystem;
    const fs::path dir = fs::temp_directory_path() / "carrel-steps-test";
    fs::create_directories(dir);
    std::ofstream(dir / "m.csv") << "t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw\n0,left,0,0,60,0,1,0,0,1\n"
                                    "3,right,0,0,90,0,1,0,0,1\n";
    const auto said_of = [&](const std::string& drill) -> std::string {
        std::ofstream(dir / "drill.json") << drill;
        try {
            scenarios::drill::load_drill(dir / "drill.json");
            return "";
        } catch (const scenarios::drill::FileError& error) {
            return error.what();
        }
    };
    const std::string moved = sample::with("\"time_limit_s\"", "\"motion\": \"m.csv\", \"time_limit_s\"");
    const auto until = [](const char* end) {
        return step(R"("throws": 1)", std::string(", \"reference_s\": [1, ") + end + "]");
    };
    EXPECT_EQ(said_of(guided(until("3"), moved)), "");
    EXPECT_NE(said_of(guided(until("3.5"), moved))
                  .find("/steps/0/reference_s: ends at 3.5 s, after the motion, which ends at 3 s"),
              std::string::npos);
    EXPECT_NE(said_of(guided(until("3"))).find("are seconds of the drill's motion, expected \"motion\" in the drill"),
              std::string::npos);
}

// Words are mended often; a resident's history must not end there, and must not go on where the task is another.
TEST(HistoryKey, IsOfWhatIsSimulatedAndJudged) {
    const auto key = [](const std::string& text) { return history_key(parse_drill(text, "a.json", "")); };
    const std::string as_is = key(sample::drill);
    EXPECT_EQ(as_is.size(), 64u);
    EXPECT_EQ(key(sample::with("Square knot", "Another title")), as_is);
    EXPECT_EQ(key(sample::with("\"time_limit_s\"", "\"description\": \"Tie.\", \"time_limit_s\"")), as_is);
    EXPECT_EQ(key(sample::with("\"time_limit_s\"", "\"motion\": \"m.csv\", \"time_limit_s\"")), as_is);
    EXPECT_EQ(key(guided(step(R"("throws": 1)"))), as_is);
    EXPECT_EQ(key(sample::with("\"size\": \"6-0\",", "")), as_is) << "a default is as good as what it stands for";
    for (const auto& [from, to] : {std::pair("\"max\": 900", "\"max\": 901"),
                                   {"\"length_mm\": 150", "\"length_mm\": 151"},
                                   {"\"tie\": \"square\"", "\"tie\": \"granny\""},
                                   {"120", "119"},
                                   {"\"time_limit_s\"", "\"pace\": 0.5, \"time_limit_s\""}})
        EXPECT_NE(key(sample::with(from, to)), as_is) << to;
}
