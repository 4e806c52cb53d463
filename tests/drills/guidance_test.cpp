#include <gtest/gtest.h>

#include <cstdlib>

#include "scenarios/session/guide.hpp"
#include "scenarios/session/script.hpp"
#include "tests/drills/shake.hpp"

// The reference motion of each drill that has guidance, watched by the guide: every step is ticked off, each in its
// turn and in its seconds, whoever's hand it is.
namespace {

using scenarios::session::Guide;
using scenarios::session::Script;

// Tips pass a place or close on a strand at the reference's own time, within the 2 ms that a shake of 0.05 mm is worth
// at 25 mm/s; but a knot's name comes every 0.1 s, so that a shake of a hair may bring it by one look sooner.
constexpr double too_early_s = 0.1;
// A name is 20 to 120 ms old when it comes, a step that waits for one is ticked off by as much later; a tool that waits
// for a taut thread comes later too.
constexpr double too_late_s = 0.5;

// Plays the script until its end, or until all steps are done.
Guide follow(const Script& script) {
    auto world = script.start();
    Guide guide(script.drill);
    while (world.ticks() < script.ticks() && guide.now()) {
        script.tick(world);
        guide.after_tick(world);
    }
    return guide;
}

void expect_in_turn(const Script& script) {
    const scenarios::drill::Drill& drill = script.drill;
    const Guide guide = follow(script);
    ASSERT_FALSE(drill.steps.empty());
    EXPECT_EQ(guide.step(), drill.steps.size()) << "left: " << (guide.now() ? guide.now()->text : "");
    for (std::size_t i = 0; i < guide.marks().size(); ++i) {
        SCOPED_TRACE(std::to_string(i + 1) + ". " + drill.steps[i].text);
        const auto [at_s, passed_over] = guide.marks()[i];
        EXPECT_FALSE(passed_over) << "at " << at_s << " s";
        ASSERT_TRUE(drill.steps[i].reference_s);
        EXPECT_GE(at_s, drill.steps[i].reference_s->at(0) - too_early_s);
        EXPECT_LE(at_s, drill.steps[i].reference_s->at(1) + too_late_s);
    }
}

struct Guidance : testing::TestWithParam<const char*> {
    Script script{std::filesystem::path(CARREL_SOURCE "/scenarios/drills") / (GetParam() + std::string(".json"))};
};

std::string test_name(const testing::TestParamInfo<const char*>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

TEST_P(Guidance, TicksEveryStepOffInItsTurn) {
    expect_in_turn(script);
}

// One seed; twenty with CARREL_LONG set.
TEST_P(Guidance, FollowsShakenHands) {
    for (unsigned seed = 1; seed <= (std::getenv("CARREL_LONG") ? 20u : 1u); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Script other = script;
        other.motion = shake::shaken(script.motion, seed);
        expect_in_turn(other);
        if (HasFailure()) return;
    }
}

INSTANTIATE_TEST_SUITE_P(Short, Guidance,
                         testing::Values("first-moves", "square-knot", "granny-knot", "surgeons-knot", "single-bite"),
                         test_name);
INSTANTIATE_TEST_SUITE_P(Assisted, Guidance,
                         testing::Values("assisted-square-knot", "assisted-granny-knot", "assisted-surgeons-knot"),
                         test_name);

}  // namespace
