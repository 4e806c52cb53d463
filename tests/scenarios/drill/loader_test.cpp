#include <gtest/gtest.h>

#include <span>

#include "scenarios/drill/drill.hpp"
#include "tests/scenarios/drill/sample.hpp"

using namespace scenarios::drill;
using sample::message;
using sample::with;

// A value in the wrong unit or a default that is not the table's would simulate another thread and look plausible.
TEST(DrillLoader, ReadsEveryPartInSi) {
    const Drill drill = parse_drill(sample::drill, "a.json", "/base");
    EXPECT_EQ(drill.title, "Square knot");
    EXPECT_EQ(drill.text, sample::drill);
    const auto& thread = drill.world.thread;
    EXPECT_DOUBLE_EQ(thread.length, 0.150);
    EXPECT_DOUBLE_EQ(thread.diameter, 0.085e-3);
    EXPECT_DOUBLE_EQ(thread.break_force, 1.96);
    EXPECT_DOUBLE_EQ(thread.young_modulus, 2.8e9);
    EXPECT_DOUBLE_EQ(thread.density, 905);
    EXPECT_DOUBLE_EQ(thread.friction, 0.2);
    EXPECT_EQ(thread.links, 300);
    ASSERT_EQ(drill.world.vessels.size(), 1u);
    EXPECT_DOUBLE_EQ(drill.world.vessels[0].diameter, 4e-3);
    EXPECT_DOUBLE_EQ(drill.world.vessels[0].wall, 0.6e-3);
    ASSERT_EQ(drill.world.instruments.size(), 2u);
    EXPECT_EQ(drill.world.instruments[1].kind, instruments::Kind::needle_holder);
    ASSERT_EQ(drill.goals.size(), 1u);
    EXPECT_EQ(drill.goals[0].throws, 2);
    EXPECT_EQ(drill.goals[0].tails_mm->high, 8);
    EXPECT_EQ(drill.bands.path_mm[0]->high, 900);
    EXPECT_FALSE(drill.bands.path_mm[1]);
    EXPECT_EQ(drill.bands.tension_N->low, 0.1);
    EXPECT_EQ(drill.bands.pass_throughs->high, 0);
}

// Numbers must win over the tables, or an author's measured thread silently becomes the textbook one.
TEST(DrillLoader, NumbersWinOverSizeAndMaterial) {
    const auto thread =
        parse_drill(with("\"friction\": 0.2", "\"diameter_mm\": 0.1, \"break_N\": 3, \"material\": \"nylon\""), "a", "")
            .world.thread;
    EXPECT_DOUBLE_EQ(thread.diameter, 0.1e-3);
    EXPECT_DOUBLE_EQ(thread.break_force, 3);
    EXPECT_DOUBLE_EQ(thread.young_modulus, 2e9);
}

// explain prints `filled`; if it were not a drill with the same meaning it would mislead the author.
TEST(DrillLoader, FilledInDrillMeansTheSame) {
    const Drill drill = parse_drill(sample::drill, "a", ""), again = parse_drill(drill.filled, "b", "");
    EXPECT_EQ(drill.filled, again.filled);
    EXPECT_EQ(drill.world.thread.start, again.world.thread.start);
    EXPECT_NE(drill.filled.find("\"young_MPa\": 2800"), std::string::npos);
}

// A start path cut short or left long would give a thread of another length than the author wrote.
TEST(DrillLoader, CutsStartPathToLength) {
    const auto thread =
        parse_drill(with("\"friction\": 0.2", "\"start_mm\": [[0, 0, 9], [0, 100, 9], [0, 100, 209]]"), "a", "")
            .world.thread;
    ASSERT_EQ(thread.start.size(), 3u);
    EXPECT_NEAR((thread.start[2] - sim::geometry::Vec3(0, 0.1, 0.059)).norm(), 0, 1e-15);
    EXPECT_DOUBLE_EQ(thread.length, 0.150);
}

// The drill with an elastic thread and these effects.
std::string elastic(const std::string& effects, const std::string& more = "") {
    std::string text = with("\"6-0\"", "\"6-0\", \"model\": \"elastic\"" + more);
    return text.replace(text.find("{\"gravity\": false}"), 18, effects);
}

// The drill with a needle in vessels that give way.
std::string needle(const std::string& towards, const std::string& bulge) {
    std::string text = with("\"friction\": 0.2", R"("needle": {"code": "BV-1", "tail_mm": [0, 0, 9], "towards": )" +
                                                     towards + ", \"bulge\": " + bulge + "}");
    return text.replace(text.find("{\"gravity\": false}"), 18, "{\"tissue\": \"elastic\"}");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// Another vessel of 4 mm across it, so far aside.
std::string beside_carotid(const std::string& aside_mm) {
    return with(R"("length_mm": 30}})",
                R"("length_mm": 30}}, {"name": "vein", "axis": [0.6, 0, 0.8], "centre_mm": [2, )" + aside_mm +
                    R"(, 1], "tube": {"diameter_mm": 4, "wall_mm": 0.6, "length_mm": 20}})");
}

TEST(DrillLoader, VesselsMayLieSideBySideAndInALumen) {
    EXPECT_EQ(parse_drill(beside_carotid("4.1"), "a", "").world.vessels.size(), 2u);
    const std::string within =
        with(R"("length_mm": 30}})",
             R"("length_mm": 30}}, {"name": "graft", "tube": {"diameter_mm": 2.7, "wall_mm": 0.3, "length_mm": 20}})");
    EXPECT_EQ(parse_drill(within, "a", "").world.vessels.size(), 2u);
}

// Of links that it does not name a short thread has no more than it has room for.
TEST(DrillLoader, AShortThreadHasFewerLinks) {
    const auto links = [](const std::string& length_mm) {
        return parse_drill(with("150", length_mm), "a", "").world.thread.links;
    };
    EXPECT_EQ(links("150"), 300);
    EXPECT_EQ(links("20"), 117);  // of 0.17 mm each
    EXPECT_EQ(links("5"), 29);
}

// Another thread beside the one of needle(), so far along y from it.
std::string spare(const std::string& away_mm, const std::string& with_needle = needle("[0, 0, 1]", "[0, -1, 0]")) {
    std::string text = with_needle;
    return text.replace(text.find("\"length_mm\""), 11,
                        R"("spares": [{"needle": {"tail_mm": [0, )" + away_mm +
                            R"(, 9], "towards": [0, 0, 1], "bulge": [0, -1, 0]}, "start_mm": [[100, )" + away_mm +
                            R"(, 9], [400, )" + away_mm + R"(, 9]]}], "length_mm")");
}

TEST(DrillLoader, ReadsSpares) {
    const Drill drill = parse_drill(spare("60"), "a", "");
    ASSERT_EQ(drill.world.spares.size(), 1u);
    const auto& read = drill.world.spares[0];
    EXPECT_NEAR((read.needle.tail() - drill.world.needle.tail() - sim::geometry::Vec3(0, 0.06, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR((read.start.front() - read.needle.tail()).norm(), 0, 1e-15);
    EXPECT_EQ(parse_drill(drill.filled, "b", "").filled, drill.filled);
}

// Off by the model's own default or by the author's word: each reaches the thread, and nothing else does.
TEST(DrillLoader, ReadsEffectsOfAnElasticThread) {
    const auto thread = [](const std::string& effects) { return parse_drill(elastic(effects), "a", "").world.thread; };
    const auto usual = thread("{}");
    EXPECT_FALSE(usual.weighs);
    EXPECT_TRUE(usual.stretches && usual.swings);
    EXPECT_EQ(usual.yield_strain, 0);
    EXPECT_TRUE(thread("{\"gravity\": true}").weighs);
    EXPECT_FALSE(thread("{\"extension\": false}").stretches);
    EXPECT_FALSE(thread("{\"inertia\": false}").swings);
    EXPECT_FALSE(usual.is_in_air);
    EXPECT_TRUE(thread("{\"air\": true}").is_in_air);
    EXPECT_DOUBLE_EQ(thread("{\"plastic_set\": true}").yield_strain, 0.04);
    std::string feels = elastic("{}");
    feels.replace(feels.find("\"forceps\""), 9, "\"forceps\", \"pull_N\": 1.2");
    EXPECT_EQ(parse_drill(feels, "a", "").world.instruments[0].pull, 1.2);
    EXPECT_EQ(parse_drill(feels, "a", "").world.instruments[1].pull, std::numeric_limits<double>::infinity());
    for (const char* effects :
         {"{\"gravity\": true, \"inertia\": false, \"plastic_set\": true}", "{\"extension\": false}"}) {
        const Drill drill = parse_drill(elastic(effects), "a", "");
        EXPECT_EQ(parse_drill(drill.filled, "b", "").filled, drill.filled);
    }
}

struct Case {
    std::string text, message;
};

// The message is the interface: each names line, column, place, fault and remedy, so each is held word for word.
void expect_word_for_word(std::span<const Case> cases) {
    for (const Case& c : cases) EXPECT_EQ(message(c.text), c.message);
}

TEST(DrillLoader, SaysWhatIsWrongWithAThread) {
    const Case cases[] = {
        {with("\"title\": \"Square knot\"", "\"title\": \"Square\\nknot\""),
         "a.json:3:12: error: /title: has control characters, expected one line of text"},
        {with("\"length_mm\": 150", "\"length_cm\": 15"),
         "a.json:6:5: error: /thread/length_cm: unknown key, this is written in mm as \"length_mm\""},
        {with("\"length_mm\": 150", "\"length\": 0.15"),
         "a.json:6:5: error: /thread/length: unknown key, this is written in mm as \"length_mm\""},
        {with("\"friction\":", "\"fricton\":"),
         "a.json:7:5: error: /thread/fricton: unknown key, did you mean \"friction\"?"},
        {with("\"friction\":", "\"wobbliness\":"),
         "a.json:7:5: error: /thread/wobbliness: unknown key, known are \"size\", \"material\", \"length_mm\", "
         "\"diameter_mm\", \"young_MPa\", "
         "\"density_kg_m3\", \"break_N\", \"friction\", \"friction_tool\", \"yield_percent\", \"links\", "
         "\"shortest_link_mm\", \"contacts_per_tick\", \"model\", \"start_mm\", \"needle\", \"spares\""},
        {with("\"friction\": 0.2", "\"links\": 1e9"),
         "a.json:7:14: error: /thread/links: expected 2 to 5000, found 1e+09"},
        {with("\"friction\": 0.2", "\"links\": 1000000000"),
         "a.json:7:14: error: /thread/links: expected 2 to 5000, found 1000000000"},
        {with("\"friction\": 0.2", "\"links\": 2.5"),
         "a.json:7:14: error: /thread/links: expected a whole number, found 2.5"},
        {with("\"friction\": 0.2", "\"links\": 3000"),
         "a.json:7:14: error: /thread/links: links would be shorter than the thread is thick, expected at most 1764"},
        {with("\"friction\": 0.2", "\"shortest_link_mm\": 0.01"),
         "a.json:7:25: error: /thread/shortest_link_mm: links would be shorter than the thread is thick, expected 0 or "
         "at least 0.085"},
        {with("150", "0.15"), "a.json:6:18: error: /thread/length_mm: expected 5 to 1000 mm, found 0.15"},
        {with("150", "\"150 mm\""), "a.json:6:18: error: /thread/length_mm: expected a number, found \"150 mm\""},
        {with("150", "null"), "a.json:6:18: error: /thread/length_mm: expected a number, found null"},
        {with("150", "NaN"), "a.json:6:18: error: not valid JSON: invalid literal"},
        {with("150", "1e999"), "a.json:6:18: error: number too large: 1e999"},
        {with("    \"length_mm\": 150,\n", ""), "a.json:4:13: error: /thread: the key \"length_mm\" is missing"},
        {with("\"friction\": 0.2", "\"length_mm\": 100"),
         "a.json:7:5: error: /thread/length_mm: this key is given twice, remove one"},
        {with("\"6-0\"", "\"60\""),
         "a.json:5:13: error: /thread/size: expected \"3-0\", \"4-0\", \"5-0\", \"6-0\", \"7-0\", \"8-0\", \"9-0\" or "
         "\"10-0\", found \"60\", did you mean "
         "\"6-0\"?"},
    };
    expect_word_for_word(cases);
}

TEST(DrillLoader, SaysWhatIsWrongWithEffects) {
    const Case cases[] = {
        {with("\"gravity\": false", "\"gravity\": true"),
         "a.json:16:26: error: /effects/gravity: a thread moved by ftl has none, expected false, or \"model\": "
         "\"elastic\" in the thread"},
        {with("\"friction\": 0.2", "\"contacts_per_tick\": 50"),
         "a.json:7:26: error: /thread/contacts_per_tick: a thread moved by ftl leaves nothing to the next tick, "
         "expected 0, or \"model\": \"elastic\" in the thread"},
        {with("\"kind\": \"forceps\"", "\"kind\": \"forceps\", \"pull_N\": 1"),
         "a.json:13:51: error: /instruments/0/pull_N: a thread moved by ftl has no forces to feel, expected none, or "
         "\"model\": \"elastic\" in the thread"},
        {with("\"gravity\": false", "\"twist\": true"),
         "a.json:16:24: error: /effects/twist: this version cannot simulate more, expected false, found true"},
        {elastic("{\"bending\": false}"),
         "a.json:16:26: error: /effects/bending: an elastic thread bends, expected true, or \"model\": \"ftl\" in the "
         "thread"},
        {elastic("{\"plastic_set\": true}", ", \"material\": \"silk\""),
         "a.json:16:30: error: /effects/plastic_set: nothing is known of when silk yields, expected false, or "
         "\"yield_percent\" in the thread"},
        {with("\"gravity\": false", "\"tissue\": \"jelly\""),
         "a.json:16:25: error: /effects/tissue: expected \"rigid\" or \"elastic\", found \"jelly\""},
    };
    expect_word_for_word(cases);
}

TEST(DrillLoader, SaysWhatIsWrongWithNeedlesAndVessels) {
    const Case cases[] = {
        {with("\"friction\": 0.2",
              R"("needle": {"code": "BV-1", "tail_mm": [0, 0, 9], "towards": [0, 0, 1], "bulge": [0, 1, 0]})"),
         "a.json:7:15: error: /thread/needle: a rigid vessel lets no needle in, expected \"tissue\": \"elastic\" in "
         "effects, or no vessels"},
        {needle("[0, 0, -1]", "[0, 1, 0]"),
         "a.json:7:43: error: /thread/needle/tail_mm: from here the needle is in the wall of \"carotid\", expected to "
         "start clear of it"},
        {needle("[0, 0, 1]", "[0, 1e-300, 0]"),
         "a.json:7:85: error: /thread/needle/bulge: has no direction, expected one component other than 0"},
        {replaced(needle("[0, 0, 1]", "[0, 1, 0]"), "\"6-0\"", "\"3-0\""),
         "a.json:7:24: error: /thread/needle/code: its wire of 0.2 mm makes no hole for a thread of 0.225 mm, expected "
         "a thicker needle or a thinner thread"},
        {replaced(needle("[0, 0, 1]", "[0, 1, 0]"), "\"length_mm\": 30", "\"length_mm\": 3, \"cut_angle_deg\": 60"),
         "a.json:10:81: error: /vessels/0/tube/length_mm: too short for a slanted cut, expected above 3.42 mm"},
        {beside_carotid("3.9"),
         "a.json:10:140: error: /vessels/1/centre_mm: its wall is in that of \"carotid\", expected the two clear of "
         "each other"},
        {beside_carotid("0.5"),
         "a.json:10:140: error: /vessels/1/centre_mm: its wall is in that of \"carotid\", expected the two clear of "
         "each other"},
        {replaced(sample::sewn("\"gap_mm\": {\"max\": 1}"), ", \"held\": [\"start\"]", ""),
         "a.json:10:5: error: /vessels/0: both ends are held, so that there is no cut to measure bites and join from, "
         "expected one end in \"held\""},
        {needle("[0, 0, 0]", "[0, 0, 1]"),
         "a.json:7:65: error: /thread/needle/towards: has no direction, expected one component other than 0"},
        {spare("60", with("\"friction\": 0.2", "\"links\": 300")),
         "a.json:6:15: error: /thread/spares: they would have needles like the first thread, which has none, expected "
         "\"needle\" beside them"},
        {spare("0"),
         "a.json:6:106: error: /thread/spares/0/start_mm: from here to the next corner it touches a thread before it, "
         "expected them a diameter apart"},
        {needle("[0, 0, 1]", "[0, 0, -2]"),
         "a.json:7:85: error: /thread/needle/bulge: is along \"towards\", expected a direction across it"},
        {with("\"friction\": 0.2", "\"model\": \"rubber\""),
         "a.json:7:14: error: /thread/model: expected \"ftl\" or \"elastic\", found \"rubber\""},
    };
    expect_word_for_word(cases);
}

TEST(DrillLoader, SaysWhatIsWrongWithGoalsAndBands) {
    const Case cases[] = {
        {with("\"around\": \"carotid\"", "\"around\": \"aorta\""),
         "a.json:17:41: error: /goals/0/around: no vessel is named \"aorta\", expected \"carotid\""},
        {with("\"throws\": 2", "\"times\": 2"),
         "a.json:17:41: error: /goals/0/around: knots in several threads are not looked for round a vessel, expected "
         "no such key"},
        {with("\"square\", \"around\": \"carotid\", \"throws\": 2", "\"cow hitch\", \"times\": 2"),
         "a.json:17:43: error: /goals/0/times: hitches are looked for in one thread, expected a knot"},
        {with("\"throws\": 2", "\"throws\": \"2-1\""),
         "a.json:17:62: error: /goals/0/throws: expected turns of each throw joined by '=' (reversed) or 'x' (same "
         "way), such as \"2=1\", found \"2-1\""},
        {with("[3, 8]", "[8, 3]"), "a.json:17:77: error: /goals/0/tails_mm: expected [low, high], found 8 above 3"},
        {with("{\"left\": {", "{\"lefty\": {"),
         "a.json:18:25: error: /bands/path_mm/lefty: no instrument has this name, expected \"left\" or \"right\""},
        {with("\"tension_N\": [0.1, 1]", "\"tension_N\": 1"),
         "a.json:18:61: error: /bands/tension_N: expected [low, high] or {\"max\": high}, found 1"},
        {with("\"tension_N\": [0.1, 1]", "\"tension_N\": {\"min\": 0.1, \"max\": 1}"),
         "a.json:18:62: error: /bands/tension_N/min: unknown key, known are \"max\"; expected [low, high] or {\"max\": "
         "high}"},
        {with("\"tension_N\": [0.1, 1]", "\"tension_N\": [1]"),
         "a.json:18:61: error: /bands/tension_N: expected [low, high] or {\"max\": high}, found a list of 1"},
        {with("\"tension_N\": [0.1, 1]", "\"time_s\": [130, 150]"),
         "a.json:18:58: error: /bands/time_s: the drill ends before, at time_limit_s, which is 120 s"},
        {sample::sewn("\"bites\": [1.5, 2]"),
         "a.json:18:23: error: /bands/bites/0: expected a whole number, found 1.5"},
        {with("{\"gravity\": false}", "{\"tear\": true}"),
         "a.json:16:23: error: /effects/tear: rigid walls neither tear nor leak, expected false, or vessels and "
         "\"tissue\": \"elastic\""},
        {with("{\"gravity\": false}", "{\"tissue\": \"elastic\", \"leak\": false}"),
         "a.json:16:44: error: /effects/leak: walls that give way tear and leak, expected true or no such key"},
        {with("\"tension_N\"", "\"bites\": [2, 2], \"tension_N\""),
         "a.json:18:57: error: /bands/bites: the thread has no needle: give it one (\"needle\"), or leave this out"},
        {sample::sewn("\"bite_mm\": [1, 2]"),
         "a.json:18:24: error: /bands/bite_mm: expected \"bites\" as well, how many there must be"},
        {sample::sewn("\"bite_deg\": [60, 90]"),
         "a.json:18:25: error: /bands/bite_deg: expected \"bites\" as well, how many there must be"},
        {replaced(needle("[0, 0, 1]", "[0, -1, 0]"), "\"tension_N\"", "\"gap_mm\": {\"max\": 1}, \"tension_N\""),
         "a.json:18:58: error: /bands/gap_mm: a join is of two vessels sewn by a needle, expected both"},
    };
    expect_word_for_word(cases);
}

TEST(DrillLoader, SaysWhatIsWrongWithNamesAndStarts) {
    const Case cases[] = {
        {with("\"right\"", "\"left\""),
         "a.json:14:14: error: /instruments/1/name: \"left\" is named twice, expected different names"},
        {with("\"carotid\"", "\"left\""),
         "a.json:10:14: error: /vessels/0/name: \"left\" is named twice, expected different names"},
        {with("\"wall_mm\": 0.6", "\"wall_mm\": 2"),
         "a.json:10:63: error: /vessels/0/tube/wall_mm: expected less than half of diameter_mm, which is 4 mm"},
        {with("\"tube\": {\"diameter_mm\": 4, \"wall_mm\": 0.6, \"length_mm\": 30}", "\"axis\": [1, 0, 0]"),
         "a.json:10:5: error: /vessels/0: expected exactly one of the keys \"tube\" and \"mesh\", found 0"},
        {with("\"friction\": 0.2", "\"start_mm\": [[0, 0, 9], [0, 90, 9]]"),
         "a.json:7:17: error: /thread/start_mm: the path is 90 mm long, expected at least length_mm, which is 150 mm"},
        {with("\"friction\": 0.2", "\"start_mm\": [[0, -90, 1], [0, 90, 1]]"),
         "a.json:7:18: error: /thread/start_mm/0: from here to the next corner the thread is inside the vessel "
         "\"carotid\", expected to start clear "
         "of it"},
        {with("\"friction\": 0.2", "\"start_mm\": [[0, 0, 9], [0, 50, 9], [9, 50, 9], [9, 25, 9], [-99, 25, 9]]"),
         "a.json:7:53: error: /thread/start_mm/3: from here to the next corner the thread touches the piece from "
         "corner 0, expected them a "
         "diameter apart"},
        {with("\"friction\": 0.2", "\"start_mm\": [[0, 0, 9], [0, 100, 9], [1, 20, 9]]"),
         "a.json:7:29: error: /thread/start_mm/1: the thread folds back onto itself here, expected a bend with room "
         "for it"},
        {with("\"friction\": 0.2", "\"links\": 4, \"start_mm\": [[0, -65, 0], [20, 0, 0], [0, 65, 0], [0, 80, 0]]"),
         "a.json:7:29: error: /thread/start_mm: of 4 links number 1 cuts a corner through the vessel \"carotid\", "
         "expected more links, or a wider bend"},
        {with("\"friction\": 0.2",
              "\"links\": 4, \"start_mm\": [[0, 0, 9], [40, 0, 9], [40, 30, 9], [20, 30, 9], [20, 2, 9], [20, 2, 10], "
              "[20, -2, 10], "
              "[20, -2, 9], [20, -40, 9]]"),
         "a.json:7:29: error: /thread/start_mm: of 4 links number 3 cuts a corner through link 0, expected more links, "
         "or a wider bend"},
    };
    expect_word_for_word(cases);
}

TEST(DrillLoader, SaysWhatIsWrongWithADocument) {
    const Case cases[] = {
        {with("\"carrel_drill\": 1", "\"carrel_drill\": 2"), "a.json:2:19: error: /carrel_drill: expected 1, found 2"},
        {with("  \"time_limit_s\": 120\n", "  \"time_limit_s\": 120,\n"),
         "a.json:20:1: error: not valid JSON: unexpected '}'; expected string literal"},
        {"", "a.json: error: is empty, expected a JSON object"},
        {" \n\t\n", "a.json: error: is empty, expected a JSON object"},
        {"[]", "a.json:1:1: error: /: expected an object, found a list of 0"},
        {std::string(100000, '['), "a.json: error: is nested deeper than 32 levels"},
    };
    expect_word_for_word(cases);
}

// What other languages and editors put into a text is named as such, where it stands.
TEST(DrillLoader, NamesWhatIsNoJson) {
    const std::string comment = "not valid JSON: a comment, which JSON does not have, remove it",
                      curly = "not valid JSON: a curly quote, expected a straight one: \"";
    const Case cases[] = {
        {with("  \"title\"", "  // the knot\n  \"title\""), "a.json:3:3: error: " + comment},
        {with("  \"title\"", "  /* the knot */ \"title\""), "a.json:3:3: error: " + comment},
        {with("  \"title\"", "  # the knot\n  \"title\""), "a.json:3:3: error: " + comment},
        {with("150,", "150, // of 6-0"), "a.json:6:23: error: " + comment},
        {with("\"friction\": 0.2", "\"friction\": /* measured */ 0.2"), "a.json:7:17: error: " + comment},
        {with("\"title\"", "\u201ctitle\u201d"), "a.json:3:3: error: " + curly},
        {with("\"Square knot\"", "\u201eSquare knot\u201c"), "a.json:3:12: error: " + curly},
        {with("\"title\"", "\"title\u201d"), "a.json:3:9: error: " + curly},
        {with("\"Square knot\"", "\"Square knot\u201d"), "a.json:3:24: error: " + curly},
        {with("\"Square knot\"", "\u2018Square knot\u2019"), "a.json:3:12: error: " + curly},
        {with("\"title\"", "'title'"), "a.json:3:3: error: not valid JSON: a single quote, expected a double one: \""},
        {with("\"Square knot\"", "\"A \u201csquare\u201d knot // of 2 throws\""), ""}};
    expect_word_for_word(cases);
}

// A suggestion that is no better than a guess sends its reader to a key that has nothing to do with hers.
TEST(DrillLoader, SuggestsOnlyWhatIsNearAndStillMissing) {
    const std::string known =
        "known are \"$schema\", \"carrel_drill\", \"title\", \"description\", \"thread\", \"vessels\", "
        "\"instruments\", \"effects\", \"goals\", \"bands\", \"steps\", \"pace\", "
        "\"time_limit_s\", \"motion\"";
    const auto named = [&](const std::string& key) { return message(with("\"bands\"", "\"" + key + "\"")); };
    for (const char* far : {"boards", "beads", "brands2", "score", "limits"})
        EXPECT_EQ(named(far), "a.json:18:3: error: /" + std::string(far) + ": unknown key, " + known);
    for (const char* near : {"band", "Bands", "bnads", "bandss"})
        EXPECT_EQ(named(near), "a.json:18:3: error: /" + std::string(near) + ": unknown key, did you mean \"bands\"?");
    EXPECT_EQ(message(with("\"time_limit_s\"", "\"band\": 1, \"time_limit_s\"")),
              "a.json:19:3: error: /band: unknown key, " + known)
        << "bands are there already";
    EXPECT_EQ(message(with("\"length_mm\": 150", "\"lenght_mm\": 150")),
              "a.json:6:5: error: /thread/lenght_mm: unknown key, did you mean \"length_mm\"?");
}

// Editors count characters: behind a two-byte letter a column in bytes points one too far.
TEST(DrillLoader, ColumnsCountCharacters) {
    EXPECT_EQ(message(with("{\"name\": \"carotid\", \"tube\"", "{\"name\": \"\xc3\xa9t\xc3\xa9\", \"tube\"")),
              "a.json:10:14: error: /vessels/0/name: expected a letter and up to 39 letters, digits, '_' or '-', found "
              "\"\\u00e9t\\u00e9\"");
    EXPECT_EQ(message(with("\"title\": \"Square knot\",\n", "\"title\": \"\xc3\xa9\", \"extra\": 1,\n")).substr(0, 13),
              "a.json:3:17: ");
}

// Windows line ends, a byte order mark and escaped keys are all in files that people have; places must not drift.
TEST(DrillLoader, PlacesSurviveUnusualText) {
    std::string dos;
    for (const char c : with("150", "0.15")) dos += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(message(dos), "a.json:6:18: error: /thread/length_mm: expected 5 to 1000 mm, found 0.15");
    EXPECT_EQ(message("\xef\xbb\xbf" + sample::drill), "");
    EXPECT_EQ(message(with("\"length_mm\": 150", "\"length\\u005fmm\": 0.15")),
              "a.json:6:23: error: /thread/length_mm: expected 5 to 1000 mm, found 0.15");
    EXPECT_EQ(message(with("\"friction\":", "\"a/b~c\\n\":")).substr(0, 39), "a.json:7:5: error: /thread/a~1b~0c?: un");
}

// Each committed drill must load, or the first thing a newcomer runs fails.
TEST(DrillLoader, CommittedDrillsLoad) {
    // granny-knot asks for a square and ties a granny, to show a drill that fails
    const std::pair<std::string, std::string> ties[] = {
        {"square-knot", "square"},          {"granny-knot", "square"},          {"surgeons-knot", "surgeons"},
        {"assisted-square-knot", "square"}, {"assisted-granny-knot", "granny"}, {"assisted-surgeons-knot", "surgeons"}};
    for (const auto& [name, tie] : ties) {
        SCOPED_TRACE(name);
        const Drill drill = load_drill(std::string(CARREL_SOURCE) + "/scenarios/drills/" + name + ".json");
        ASSERT_EQ(drill.goals.size(), 1u);
        EXPECT_EQ(drill.goals[0].tie, tie);
    }
}
