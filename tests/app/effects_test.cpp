#include "app/commands/effects.hpp"

#include <gtest/gtest.h>

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
    for (const char* name : {"gravity", "bending", "twist", "extension", "plastic_set", "tissue", "tear", "leak"}) {
        EXPECT_FALSE(effect(name, sample::drill).error.empty());
        EXPECT_FALSE(effect(name, sample::drill).cost.empty());
        EXPECT_FALSE(effect(name, sample::drill).on);
    }
}

// What an elastic thread is made for is on with it, and its cost no longer conditional.
TEST(Effects, AnElasticThreadBendsStretchesAndSwings) {
    const std::string text = sample::with("\"size\": \"6-0\"", "\"size\": \"6-0\", \"model\": \"elastic\"");
    for (const char* name : {"bending", "extension", "inertia"}) EXPECT_TRUE(effect(name, text).on) << name;
    for (const char* name : {"gravity", "twist", "plastic_set"}) EXPECT_FALSE(effect(name, text).on) << name;
}
