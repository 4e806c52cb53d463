#include "scenarios/drill/score.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/scenarios/drill/sample.hpp"

using namespace scenarios;
using drill::ScoreItem;

namespace {

world::Measures good() {
    world::Measures m;
    m.knot.knot = "3_1#m3_1";
    m.knot.surgical = "square";
    m.knot.throws = "1=1";
    m.knot_since_s = 12.5;
    m.tail_mm = {7.5, 4};
    m.around = {"carotid"};
    m.duration_s = 30;
    m.path_mm = {400, 800};
    m.grasps = {2, 3};
    m.tension_max_N = {0.8, 21};
    m.lag_max_mm = {{0.1, 3}, {0.2, 4}};
    return m;
}

ScoreItem item(const std::string& name, const world::Measures& m, const std::string& text = sample::drill) {
    for (const ScoreItem& i : drill::score(drill::parse_drill(text, "a.json", ""), m))
        if (i.name == name) return i;
    ADD_FAILURE() << "no item " << name;
    return {};
}

}  // namespace

// A good tie passes every item; an item that fails for it would teach the resident a fault she did not make.
TEST(Score, GoodTiePasses) {
    for (const ScoreItem& i : drill::score(drill::parse_drill(sample::drill, "a", ""), good())) {
        EXPECT_TRUE(i.passed) << i.name;
        EXPECT_EQ(i.why, "") << i.name;
    }
    const ScoreItem tension = item("tension", good());
    EXPECT_EQ(tension.value, "0.80");
    EXPECT_EQ(tension.band, "0.1 to 1");
    EXPECT_EQ(tension.unit, "N");
    EXPECT_EQ(tension.at_s, 21);
    EXPECT_EQ(item("knot", good()).at_s, 12.5);
    EXPECT_EQ(item("time", good()).band, "at most 120");
    EXPECT_EQ(item("path_right", good()).band, "");
}

// "1.00, at most 1" would be a riddle.
TEST(Score, WhatIsJustOutsideIsShownToBe) {
    world::Measures m = good();
    m.tension_max_N = {1.0004, 21};
    EXPECT_EQ(item("tension", m).value, "1.0004");
    m.tension_max_N = {1.0, 21};
    EXPECT_EQ(item("tension", m).value, "1.00");
}

// A thread that broke was pulled through well enough: told that it was not, a resident would pull harder.
TEST(Score, ABrokenThreadIsToldInsteadOfAThrowThatWasNotPulledThrough) {
    world::Measures m = good();
    m.knot = {};
    m.knot.knot = "0_1";
    EXPECT_EQ(item("knot", m).why.find("broke"), std::string::npos);
    m.broke_s = 13.71;
    EXPECT_FALSE(item("broke", m).passed) << "asked or not";
    EXPECT_EQ(item("knot", m).why.rfind("The thread broke at 13.71 s", 0), 0u) << item("knot", m).why;
    m.tension_max_N = {2, 13.6};
    EXPECT_EQ(item("tension", m).why.rfind("The thread broke at 13.71 s", 0), 0u) << item("tension", m).why;
}

// The granny is the mistake the drill exists for: it must fail, and say how to do it right.
TEST(Score, GrannyWhereSquareWasAskedFailsAndTeaches) {
    world::Measures m = good();
    m.knot.knot = "3_1#3_1";
    m.knot.surgical = "granny";
    m.knot.throws = "1x1";
    const ScoreItem knot = item("knot", m);
    EXPECT_FALSE(knot.passed);
    EXPECT_EQ(knot.value, "granny");
    EXPECT_EQ(knot.band, "square");
    EXPECT_EQ(knot.why,
              "The second throw went the same way round as the first: a granny, which slips. Reverse the second wrap.");
    EXPECT_TRUE(item("throws", m).passed);  // two were asked, two were tied
    EXPECT_FALSE(item("throws", m, sample::with("\"throws\": 2", "\"throws\": \"1=1\"")).passed);
}

// The namer writes the apostrophe, drill files do not; compared as they are no surgeon's knot would ever pass.
TEST(Score, SurgeonsKnotIsMetWithItsApostrophe) {
    world::Measures m = good();
    m.knot.surgical = "surgeon's";
    m.knot.throws = "2=1";
    const std::string text = sample::with("\"tie\": \"square\", \"around\": \"carotid\", \"throws\": 2",
                                          "\"tie\": \"surgeons\", \"throws\": \"2=1\"");
    EXPECT_TRUE(item("knot", m, text).passed);
    EXPECT_TRUE(item("throws", m, text).passed);
    EXPECT_FALSE(item("knot", m).passed);
    EXPECT_FALSE(item("knot", good(), text).passed);
}

// Two throws of three are a square knot that lacks one, not another knot; three have no name of their own.
TEST(Score, AMissingThrowIsNotAnotherKnot) {
    world::Measures m = good();
    const std::string three = sample::with("\"throws\": 2", "\"throws\": 3");
    EXPECT_TRUE(item("knot", m, three).passed);
    EXPECT_FALSE(item("throws", m, three).passed);
    EXPECT_EQ(item("throws", m, three).why.rfind("Throws are missing", 0), 0u);
    m.knot.surgical = "", m.knot.throws = "1=1=1";
    EXPECT_TRUE(item("knot", m, three).passed);
    EXPECT_FALSE(item("knot", m).passed);
}

// A name that invariants could not decide must not be taken for a pass.
TEST(Score, UncertainNameFails) {
    world::Measures m = good();
    m.knot.certain = false;
    EXPECT_FALSE(item("knot", m).passed);
}

// An untied thread has no name, no throws and no tails: each fails with its own sentence, none crashes.
TEST(Score, NothingTied) {
    world::Measures m = good();
    m.knot = {};
    m.tail_mm = {0, 0};
    EXPECT_EQ(item("knot", m).value, "none");
    EXPECT_EQ(item("knot", m).why, "There is no knot in the thread: the throw was not pulled through, or came undone.");
    EXPECT_FALSE(item("throws", m).passed);
    EXPECT_FALSE(item("tail_short", m).passed);
    EXPECT_EQ(item("tail_short", m).why, "There is no knot to judge.");
    m.around = {};
    EXPECT_EQ(item("around", m).why, "There is no knot to judge.");
}

// Both ends of a band belong to it, and both tails are judged: a long tail must not hide a short one.
TEST(Score, TailsAreJudgedBothAtTheirBand) {
    world::Measures m = good();
    m.tail_mm = {8, 3};
    EXPECT_TRUE(item("tail_short", m).passed);
    EXPECT_TRUE(item("tail_long", m).passed);
    m.tail_mm = {8.5, 2.5};
    EXPECT_EQ(item("tail_short", m).value, "2.50");
    EXPECT_EQ(item("tail_short", m).why,
              "The tail is too short: a knot that slips a little runs off it. Leave more thread on this side.");
    EXPECT_EQ(item("tail_long", m).why,
              "The tail is longer than asked. Cut it, or start with less thread on this side.");
}

// Of a join of several stitches one knot that is right must not hide another that is not, nor its short tail.
TEST(Score, EveryOneOfSeveralKnotsIsJudged) {
    const std::string text = sample::with("\"around\": \"carotid\", \"throws\": 2", "\"throws\": 2, \"times\": 3");
    world::Measures m = good();
    const world::TieMeasure tied{m.knot, {3, 8}};
    m.ties = {tied, tied, tied};
    EXPECT_TRUE(item("knots", m, text).passed);
    EXPECT_EQ(item("knots", m, text).band, "3");
    EXPECT_TRUE(item("tails", m, text).passed);
    m.ties[1].tail_mm = {8.1, 4};
    EXPECT_EQ(item("tails_2", m, text).value, "8.10 and 4.00");
    EXPECT_TRUE(item("knots", m, text).passed);
    EXPECT_EQ(item("tails", m, text).value, "2");
    EXPECT_FALSE(item("tails", m, text).passed);
    EXPECT_EQ(item("tails", m, text).why, "Cut each stitch alike: tails of 8.10 and 4.00 mm.");
    m.ties[2].knot.surgical = "granny", m.ties[2].knot.throws = "1x1";
    EXPECT_EQ(item("knots", m, text).value, "2");
    EXPECT_FALSE(item("knots", m, text).passed);
    EXPECT_EQ(item("knots", m, text).why, "The threads that are tied: square (1=1), square (1=1), granny (1x1).");
    m.ties[1].tail_mm = {3, 8};
    EXPECT_EQ(item("tails", m, text).why, "Knots are missing; the tails of those that are tied are right.");
    m.ties[1].tail_mm = {8.1, 4};
    m.ties[2] = {m.knot, {4, 4}};
    m.ties[2].knot.throws = "1=1=1";
    EXPECT_EQ(item("knots", m, text).value, "2") << "two throws were asked";
    m.ties = {tied, tied, tied, tied};
    EXPECT_FALSE(item("knots", m, text).passed);
    m.ties.clear();
    EXPECT_EQ(item("knots", m, text).why, "No thread is tied.");
    EXPECT_EQ(item("tails", m, text).why, "There is no knot to judge.");
}

// Each measured item fails on its own and leaves the others alone: there is no sum in which one hides another.
TEST(Score, ItemsFailAlone) {
    const std::string text =
        sample::with("\"tension_N\": [0.1, 1]",
                     "\"tension_N\": [0.1, 1], \"grasps\": {\"right\": [1, 4]}, \"lag_mm\": {\"left\": {\"max\": 1}}");
    using Change = std::function<void(world::Measures&)>;
    const std::pair<std::string, Change> cases[] = {{"time", [](auto& m) { m.duration_s = 121; }},
                                                    {"path_left", [](auto& m) { m.path_mm[0] = 901; }},
                                                    {"grasps_right", [](auto& m) { m.grasps[1] = 5; }},
                                                    {"tension", [](auto& m) { m.tension_max_N.value = 1.1; }},
                                                    {"tension", [](auto& m) { m.tension_max_N.value = 0; }},
                                                    {"lag_left", [](auto& m) { m.lag_max_mm[0].value = 2; }},
                                                    {"pass_throughs", [](auto& m) { m.pass_throughs = 1; }}};
    for (const auto& [name, change] : cases) {
        world::Measures m = good();
        change(m);
        for (const ScoreItem& i : drill::score(drill::parse_drill(text, "a", ""), m)) {
            EXPECT_EQ(i.passed, i.name != name) << name << " " << i.name;
            EXPECT_EQ(i.why.empty(), i.passed) << name << " " << i.name;
        }
    }
}

// Whatever the drill allows: of a motion that the clock cut off nobody knows how long it takes.
TEST(Score, TheTimeLimitThatEndsADrillIsMissed) {
    for (const char* bands : {"\"tension_N\": [0.1, 1]", "\"tension_N\": [0.1, 1], \"time_s\": {\"max\": 120}"}) {
        const std::string text = sample::with("\"tension_N\": [0.1, 1]", bands);
        world::Measures m = good();
        m.duration_s = 119.999;
        EXPECT_TRUE(item("time", m, text).passed);
        m.duration_s = 120;
        EXPECT_FALSE(item("time", m, text).passed);
        EXPECT_EQ(item("time", m, text).why, "The time limit ended the drill.");
    }
}

// "Yes" alone leaves an assessor to guess how far beyond the limit it was.
TEST(Score, ALapseTellsItsNumber) {
    world::Measures m = good();
    m.join.lapses = {{"tear", "hole, in diameters of the thread", 3.518, 2, false, true},
                     {"overlap", "overlap, in walls", 0.4, 1},
                     {"unequal spacing", "shortest, in means", 0.8, 0.6, true}};
    EXPECT_EQ(item("lapse: tear", m).why, "hole, in diameters of the thread: 3.52; at most 2.00.");
    EXPECT_EQ(item("lapse: unequal spacing", m).why, "shortest, in means: 0.80; at least 0.60.");
    EXPECT_EQ(item("lapse: overlap", m).value, "no");
    EXPECT_EQ(item("lapse: overlap", m).why, "overlap, in walls: 0.40; at most 1.00.") << "how near it came";
}

// A suture with a stitch left out passed: nothing asked for it. What runs along in the wall or was torn out does not
// count.
TEST(Score, BitesThatHoldAreCounted) {
    const std::string text = sample::sewn("\"bites\": [2, 2]");
    world::Measures m = good();
    m.bites = {{"left", "outer", "inner"}, {"right", "inner", "outer"}};
    EXPECT_TRUE(item("bites", m, text).passed);
    m.bites[1].torn = true;
    EXPECT_FALSE(item("bites", m, text).passed);
    m.bites[1].torn = false, m.bites[1].is_empty = true;
    EXPECT_FALSE(item("bites", m, text).passed);
    EXPECT_TRUE(item("bite_2", m, text).why.starts_with("No thread is in it"));
    m.bites[1] = {"right", "inner", ""};
    EXPECT_EQ(item("bites", m, text).value, "1");
    m.bites[1] = {"right", "inner", "outer"};
    m.bites[1].on_needle = true, m.bites[1].at_s = 3.6;
    EXPECT_EQ(item("bites", m, text).value, "1") << "no thread is in it yet";
    EXPECT_TRUE(item("bite_2", m, text).why.starts_with("The needle is still in the wall"));
    EXPECT_EQ(item("bite_2", m, text).at_s, 3.6);
    m.bites[1] = {"right", "inner", "outer"};
    m.bites[1].both_walls = true;
    EXPECT_EQ(item("bites", m, text).value, "1");
    m.bites.clear();
    EXPECT_FALSE(item("bites", m, text).passed);
    EXPECT_TRUE(item("bites", m, text).why.starts_with("No wall was pierced"));
    m.slipped = "left", m.slipped_s = 1.734;
    EXPECT_TRUE(item("bites", m, text).why.starts_with("The needle slipped off the edge of left at 1.73 s"));
    m.bites = {{"left", "outer", "inner"}};
    EXPECT_TRUE(item("bites", m, text).why.starts_with("Bites are missing")) << "it was bitten after all";
}

TEST(Score, AWallThatCavedInIsTold) {
    const std::string text = sample::sewn("\"bites\": [1, 2]");
    world::Measures m = good();
    m.bites = {{"left", "outer", "inner"}};
    EXPECT_EQ(item("bite_1", m, text).why, "");
    m.bites[0].caved_in = true;
    EXPECT_TRUE(item("bite_1", m, text).passed) << "it holds";
    EXPECT_TRUE(item("bite_1", m, text).why.starts_with("The wall caved in"));
}

// An instructor asks for bites of one to one and a half millimetres, straight through the wall.
TEST(Score, EachBiteIsJudgedBySizeAndAngle) {
    const std::string text = sample::sewn(R"("bites": [2, 2], "bite_mm": [1, 1.5], "bite_deg": [60, 90])");
    world::Measures m = good();
    m.bites = {{"carotid", "outer", "inner", 1.2, 0.5, 80}, {"graft", "inner", "outer", 1.2, 0.5, 80}};
    for (const char* name : {"bite_size_1", "bite_size_2", "bite_angle_1", "bite_angle_2"})
        EXPECT_TRUE(item(name, m, text).passed) << name;
    m.bites[0].size_mm = 0.8, m.bites[1].size_mm = 1.6, m.bites[1].to_wall_deg = 40;
    EXPECT_TRUE(item("bite_size_1", m, text).why.starts_with("The bite is nearer to the cut"));
    EXPECT_TRUE(item("bite_size_2", m, text).why.starts_with("The bite is wider"));
    EXPECT_TRUE(item("bite_angle_2", m, text).why.starts_with("The needle met the wall aslant"));
    EXPECT_EQ(item("bite_size_1", m, sample::sewn("\"bites\": [2, 2]")).band, "") << "shown where it is not asked for";
    m.bites[0] = {"carotid", "inner", ""};
    EXPECT_EQ(item("bite_size_1", m, text).value, "none") << "no end outside, so no distance that is too small";
    EXPECT_TRUE(item("bite_size_1", m, text).passed);
}

TEST(Score, TheNeedleIsJudgedByHowItIsHeld) {
    const std::string text = sample::sewn("\"needle_deg\": [70, 90]");
    world::Measures m = good();
    EXPECT_EQ(item("needle_angle", m, text).why, "The needle was never held.");
    EXPECT_EQ(item("needle_angle", m, text).value, "never");
    m.needle_deg = world::Moment{55, 3};
    EXPECT_TRUE(item("needle_angle", m, text).why.starts_with("The needle was held askew"));
    EXPECT_EQ(item("needle_angle", m, text).at_s, 3);
    m.needle_deg->value = 85;
    EXPECT_TRUE(item("needle_angle", m, text).passed);
}

// What is never joined must not pass for a join without a gap.
TEST(Score, AJoinIsJudgedWhereOneIsAskedFor) {
    const std::string text = sample::sewn(
        R"("gap_mm": {"max": 0.2}, "lumen": [0.8, 1.2], "leak_mL_min": {"max": 100}, "lapses": {"max": 1})");
    world::Measures m = good();
    EXPECT_FALSE(item("join", m, text).passed);
    m.join = {0.1, 0.9, 80, {{"tear", "hole", 3, 2, false, true}, {"overlap", "overlap, in walls", 0.4, 1}}};
    for (const char* name : {"gap", "lumen", "leak", "lapses"}) EXPECT_TRUE(item(name, m, text).passed) << name;
    m.join.gap_mm = 0.3, m.join.lumen_ratio = 0.7, m.join.leak_ml_min = 120, m.join.lapses[1].committed = true;
    for (const char* name : {"gap", "lumen", "leak", "lapses"}) {
        EXPECT_FALSE(item(name, m, text).passed) << name;
        EXPECT_NE(item(name, m, text).why, "") << name;
    }
    EXPECT_EQ(item("lapses", m, text).why, "There are more lapses than allowed: tear, overlap.");
}

// The ends of a stitch that nobody tied met, and nothing said that clamps held them there.
TEST(Score, AJoinIsToldToBeMeasuredInClamps) {
    std::string text = sample::sewn(R"("gap_mm": {"max": 0.2})");
    world::Measures m = good();
    m.join = {0.1, 0.9, 80, {{"tear", "hole", 3, 2, false, false}}};
    EXPECT_EQ(item("gap", m, text).why, "");
    const auto replace = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    replace(R"("held": ["end"])", R"("held": ["end"], "held_by": "clamps")");
    replace(R"("kind": "needle_holder"})", R"("kind": "needle_holder"}, {"name": "clamps", "kind": "approximator"})");
    m.path_mm.push_back(0), m.grasps.push_back(0), m.lag_max_mm.push_back({0, 0});
    EXPECT_TRUE(item("gap", m, text).passed);
    EXPECT_TRUE(item("gap", m, text).why.starts_with("The clamps of clamps still hold the ends"));
    m.join.gap_mm = 0.3;
    EXPECT_TRUE(item("gap", m, text).why.starts_with("The ends do not meet"));
}
