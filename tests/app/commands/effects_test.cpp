#include "app/commands/effects.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program.hpp"
#include "tests/scenarios/drill/sample.hpp"

using app::Effect;

namespace {

Effect effect(const std::string& name, const std::string& text) {
    for (const Effect& e : app::effects_of(scenarios::drill::parse_drill(text, "a", "")))
        if (e.name == name) return e;
    ADD_FAILURE() << name;
    return {};
}

}  // namespace

// Published figures of 6-0 polypropylene: gravito-bending length 52 mm, EA 15.9 N, 1 per cent sag at 22 mm, first mode
// 8.4 Hz at 50 mm. Off by a power of the diameter, explain would tell an author to leave out what matters.
TEST(Effects, SixZeroPolypropyleneAsPublished) {
    EXPECT_NEAR(effect("gravity", sample::drill).value, 150.0 / 52, 0.03);
    EXPECT_NE(effect("gravity", sample::drill).error.find("over 23 mm"), std::string::npos);
    EXPECT_NEAR(effect("extension", sample::drill).value, 0.02 / 15.9, 1e-5);
    EXPECT_NEAR(effect("inertia", sample::drill).value, (2 / 8.4) * (2 / 8.4), 1e-3);
    EXPECT_NEAR(effect("air", sample::drill).value, 1 / 0.10, 0.5);
    EXPECT_NEAR(effect("twist", sample::drill).value, 5 * 1.5, 0.2);  // 5 turns at 100 mm
}

// Ten-zero nylon, 0.024 mm: its gravito-bending length is published as 19 mm, so known to half of that last digit.
TEST(Effects, TenZeroNylonAsPublished) {
    const std::string text =
        sample::with("\"size\": \"6-0\"", "\"size\": \"10-0\", \"material\": \"nylon\", \"diameter_mm\": 0.024");
    EXPECT_NEAR(effect("gravity", text).value, 150.0 / 19, 150.0 / 19 * 0.5 / 19);
    EXPECT_NEAR(effect("extension", text).value, 0.02 / 0.91, 3e-4);
}

// Each effect that a drill file names is explained, so that an author finds the word she wrote.
TEST(Effects, EveryEffectOfDrillFilesIsExplained) {
    for (const char* name :
         {"gravity", "bending", "twist", "extension", "plastic_set", "tissue", "tear", "leak", "inertia", "air"}) {
        EXPECT_FALSE(effect(name, sample::drill).error.empty());
        EXPECT_FALSE(effect(name, sample::drill).cost.empty());
        EXPECT_FALSE(effect(name, sample::drill).on);
    }
}

// What an elastic thread is made for is on with it, and its cost no longer conditional.
TEST(Effects, AnElasticThreadBendsStretchesAndSwings) {
    const std::string text = sample::with("\"size\": \"6-0\"", "\"size\": \"6-0\", \"model\": \"elastic\"");
    for (const char* name : {"bending", "extension", "inertia"}) EXPECT_TRUE(effect(name, text).on) << name;
    for (const char* name : {"gravity", "twist", "plastic_set", "air"}) EXPECT_FALSE(effect(name, text).on) << name;
}

// What a soft wall does by itself is told as done: bites tear out and joins leak where, and only where, walls give way.
TEST(Effects, SoftWallsTearAndLeak) {
    std::string text = sample::drill;
    text.replace(text.find("{\"gravity\": false}"), 18, "{\"tissue\": \"elastic\"}");
    for (const char* name : {"tissue", "tear", "leak"}) EXPECT_TRUE(effect(name, text).on) << name;
}

// What is written in the drill is what is on, each by itself.
TEST(Effects, EachIsOnWhereTheDrillSaysSo) {
    const auto on = [](const std::string& name, const std::string& effects) {
        std::string text = sample::with("\"6-0\"", "\"6-0\", \"model\": \"elastic\"");
        return effect(name, text.replace(text.find("{\"gravity\": false}"), 18, effects)).on;
    };
    for (const char* name : {"gravity", "plastic_set", "air"})
        EXPECT_TRUE(on(name, "{\"" + std::string(name) + "\": true}")) << name;
    for (const char* name : {"extension", "inertia"})
        EXPECT_FALSE(on(name, "{\"" + std::string(name) + "\": false}")) << name;
}

// 300 mm of silk hang in 11 of its gravito-bending lengths, 20 mm of polypropylene in 0.4 of its own.
TEST(Effects, IsMissedWhereTheThreadNeedsIt) {
    const std::string limp =
        sample::with("\"size\": \"6-0\",\n    \"length_mm\": 150", "\"material\": \"silk\", \"length_mm\": 300");
    EXPECT_TRUE(effect("gravity", limp).is_missed());
    EXPECT_TRUE(effect("inertia", limp).is_missed());
    EXPECT_FALSE(effect("extension", limp).is_missed());
    EXPECT_FALSE(effect("gravity", sample::with("150", "20, \"links\": 50")).is_missed());
    // Links of half a millimetre are shorter than a corner of polypropylene is round at 20 mN, links of 1.5 mm are not
    // unless they may be halved.
    EXPECT_TRUE(effect("bending", sample::drill).is_missed());
    EXPECT_TRUE(effect("bending", sample::with("\"friction\": 0.2", "\"links\": 100")).is_missed());
    EXPECT_FALSE(
        effect("bending", sample::with("\"friction\": 0.2", "\"links\": 100, \"shortest_link_mm\": 0")).is_missed());
    // Tied by an elastic thread a knot springs open unless it is set; what ftl ties does not spring.
    EXPECT_FALSE(effect("plastic_set", sample::drill).is_missed());
    EXPECT_TRUE(effect("plastic_set", sample::with("\"6-0\"", "\"6-0\", \"model\": \"elastic\"")).is_missed());
}

// Told of another wall than the drill's, an author would think it far too strong.
TEST(Effects, AWallIsTheDrillsOwn) {
    const std::string thin = sample::with("\"wall_mm\": 0.6", "\"wall_mm\": 0.2");
    EXPECT_NEAR(effect("tissue", thin).value, 3 * effect("tissue", sample::drill).value, 1e-9);
    EXPECT_NEAR(effect("tear", thin).value, 3 * effect("tear", sample::drill).value, 1e-9);
    EXPECT_NE(effect("tear", thin).error.find("a 0.2 mm wall should tear at about 0.68 N"), std::string::npos)
        << effect("tear", thin).error;
}

// A warning is for the author's eyes: the drill stays valid, and what is printed for machines says the same.
TEST(Effects, ValidateWarnsAndExitsAsBefore) {
    const program::Folder folder;
    const std::string file = folder.write("drill.json", sample::with("150", "300"));
    const auto told = program::run({"validate", file});
    EXPECT_EQ(told.exit, 0);
    EXPECT_NE(told.said.find(file + ": warning: /effects/gravity: off, but L / (B / mg)^(1/3) is "), std::string::npos)
        << told.said;
    const auto json = program::run({"validate", "--json", file});
    EXPECT_EQ(json.exit, 0);
    EXPECT_NE(json.out.find("\"warnings\""), std::string::npos) << json.out;
}

// Played by a model that has none of it, a drill would look as if what it asks for made no difference.
TEST(Effects, FtlDoesNotPlayADrillThatAsksForMore) {
    const program::Folder folder;
    std::string text = sample::with("\"6-0\"", "\"6-0\", \"model\": \"elastic\"");
    text.replace(text.find("{\"gravity\": false}"), 18, "{\"gravity\": true}");
    program::expect_one_line_naming("--thread ftl",
                                    program::run({"run", folder.write("drill.json", text), "--thread", "ftl"}));
    std::string feels = sample::with("\"6-0\"", "\"6-0\", \"model\": \"elastic\"");
    feels.replace(feels.find("\"forceps\""), 9, "\"forceps\", \"pull_N\": 1");
    program::expect_one_line_naming("pull_N",
                                    program::run({"run", folder.write("feels.json", feels), "--thread", "ftl"}));
}

// Advice that is refused when it is followed sends its author in circles. What a warning says is expected, and nothing
// else, makes a drill of which that is not warned again.
TEST(Effects, WhatAWarningAsksForIsAccepted) {
    for (const std::string& text :
         {sample::with("150", "300"), sample::with("\"6-0\"", "\"9-0\", \"material\": \"nylon\""),
          sample::with("\"6-0\"", "\"6-0\", \"model\": \"elastic\""),
          sample::with("\"6-0\"", "\"10-0\", \"model\": \"elastic\"")}) {
        auto drill = nlohmann::json::parse(text);
        int missed = 0;
        for (const Effect& of : app::effects_of(scenarios::drill::parse_drill(text, "a", ""))) {
            if (!of.is_missed()) continue;
            ++missed;
            const auto asks = [&](const std::string& what) { return of.remedy.find(what) != std::string::npos; };
            EXPECT_TRUE(asks("\"model\": \"elastic\" in the thread") || asks("\": true in the effects")) << of.remedy;
            if (asks("\"model\": \"elastic\" in the thread")) drill["thread"]["model"] = "elastic";
            if (asks("\"" + of.name + "\": true in the effects")) drill["effects"][of.name] = true;
        }
        EXPECT_GT(missed, 0);
        EXPECT_EQ(sample::message(drill.dump()), "");
        for (const Effect& of : app::effects_of(scenarios::drill::parse_drill(text, "a", "")))
            if (of.is_missed()) {
                EXPECT_FALSE(effect(of.name, drill.dump()).is_missed()) << of.name;
            }
    }
}
