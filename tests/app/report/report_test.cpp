#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/report/report_html.hpp"
#include "app/report/result_json.hpp"
#include "app/report/text.hpp"

using namespace app::report;
using scenarios::drill::Result;
using scenarios::world::EventKind;

namespace {

Result tied() {
    Result r;
    r.drill_title = "Square knot around a 4 mm vessel";
    r.instruments = {"left", "right"};
    r.items = {{"knot", "Knot", "granny", "", "square", false, 21.5, "The second throw went the same way round."},
               {"tail_short", "Shorter tail", "6.1", "mm", "3 to 8", true, 24, ""},
               {"time", "Time", "131.0", "s", "at most 120", false, 131, "It took too long."},
               {"path_left", "Path length, left tool", "402", "mm", "", true, 131, ""}};
    for (int i = 0; i < 2400; ++i) {
        const double t = 0.01 * i, wave = 1 + std::sin(t);
        r.samples.push_back({t,
                             i == 1700 ? 1.87 : 0.3 * wave,
                             {40 * wave, 25.0},
                             {0.1 * wave, 0.0},
                             {i > 300 ? "thread" : "", i / 500 % 2 ? "needle and wall" : ""},
                             i < 900    ? "0_1"
                             : i < 1800 ? "3_1"
                                        : "3_1#3_1"});
    }
    r.events = {
        {3.0, EventKind::grasp, "left", 0.02}, {9.0, EventKind::knot, "3_1", 0}, {12.3, EventKind::slip, "right", 1.2}};
    r.duration_s = 24;
    r.links = 300;
    r.ticks = 24000;
    r.substeps = 61234;
    r.stretch_max = 0.004;
    r.separation_min = 0.998;
    r.node_step_max_over_bound = 1;
    r.contacts_max = 61;
    r.knot = "3_1#3_1";
    r.surgical = "granny";
    r.throws = "1x1";
    r.state_hash = "0123456789abcdef";
    r.tick_us = {41, 63, 120};
    r.machine = "some machine";
    return r;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

// Scripts read result.json by these keys; a renamed one breaks them silently.
TEST(ResultJson, SaysWhatTheContractNames) {
    const auto j = nlohmann::json::parse(result_json(tied()));
    EXPECT_EQ(j.at("drill"), "Square knot around a 4 mm vessel");
    EXPECT_EQ(j.at("passed"), false);
    EXPECT_EQ(j.at("items").size(), 4u);
    const auto& item = j.at("items")[0];
    EXPECT_EQ(item.at("name"), "knot");
    EXPECT_EQ(item.at("title"), "Knot");
    EXPECT_EQ(item.at("value"), "granny");
    EXPECT_EQ(item.at("unit"), "");
    EXPECT_EQ(item.at("band"), "square");
    EXPECT_EQ(item.at("passed"), false);
    EXPECT_EQ(item.at("at_s"), 21.5);
    EXPECT_EQ(item.at("why"), "The second throw went the same way round.");
    EXPECT_EQ(j.at("/items/3/passed"_json_pointer), nullptr);  // measured, not judged
    EXPECT_EQ(j.at("knot"), "3_1#3_1");
    EXPECT_EQ(j.at("surgical"), "granny");
    EXPECT_EQ(j.at("throws"), "1x1");
    EXPECT_EQ(j.at("/thread/links"_json_pointer), 300);
    EXPECT_EQ(j.at("/thread/stretch/max"_json_pointer), 0.004);
    EXPECT_EQ(j.at("/thread/stretch/settled"_json_pointer), 0);
    EXPECT_EQ(j.at("/thread/separation/min"_json_pointer), 0.998);
    EXPECT_EQ(j.at("/thread/node_step/max_over_bound"_json_pointer), 1);
    EXPECT_EQ(j.at("/thread/pass_throughs"_json_pointer), 0);
    EXPECT_EQ(j.at("/thread/contacts/max"_json_pointer), 61);
    EXPECT_EQ(j.at("/tick_us/p50"_json_pointer), 41);
    EXPECT_EQ(j.at("/tick_us/p99"_json_pointer), 63);
    EXPECT_EQ(j.at("/tick_us/max"_json_pointer), 120);
    EXPECT_EQ(j.at("ticks"), 24000);
    EXPECT_EQ(j.at("substeps"), 61234);
    EXPECT_EQ(j.at("duration_s"), 24);
    EXPECT_EQ(j.at("state_hash"), "0123456789abcdef");
    EXPECT_EQ(j.at("machine"), "some machine");
    EXPECT_EQ(j.at("/events/2"_json_pointer),
              nlohmann::json({{"t_s", 12.3}, {"kind", "slip"}, {"what", "right"}, {"value", 1.2}}));
}

// A NaN or a stray byte in the file would make every JSON reader refuse the whole result.
TEST(ResultJson, IsJsonWhateverWasMeasured) {
    Result r = tied();
    r.stretch_max = NAN;
    r.tick_us.max = INFINITY;
    r.items[0].at_s = -INFINITY;
    r.events[0].what = "\xff";
    const auto j = nlohmann::json::parse(result_json(r));
    EXPECT_TRUE(j.at("/thread/stretch/max"_json_pointer).is_null());
    EXPECT_TRUE(j.at("/tick_us/max"_json_pointer).is_null());
    EXPECT_TRUE(j.at("/items/0/at_s"_json_pointer).is_null());
}

// A score whose band or reason is left out teaches nothing.
TEST(Report, ShowsEveryItemWithBandMomentAndReason) {
    const Result r = tied();
    const std::string html = report_html(r, {});
    for (const auto& item : r.items) {
        EXPECT_TRUE(has(html, item.title)) << item.title;
        EXPECT_TRUE(has(html, item.unit.empty() ? item.value : item.value + " " + item.unit)) << item.name;
        EXPECT_TRUE(has(html, item.unit.empty() || item.band.empty() ? item.band : item.band + " " + item.unit))
            << item.name;
        EXPECT_TRUE(has(html, number(item.at_s, 1) + " s")) << item.name;
        EXPECT_TRUE(has(html, item.why)) << item.name;
    }
    EXPECT_TRUE(has(html, "✗ fail"));
    EXPECT_TRUE(has(html, "✓ pass"));
    EXPECT_TRUE(has(html, "✗ Not passed"));
    EXPECT_TRUE(has(html, "2 of 3 judged items"));
}

// "Tied: 0_1" would be read as a knot of that name.
TEST(Report, SaysThatNothingIsTied) {
    Result r = tied();
    EXPECT_FALSE(has(report_html(r, {}), "Nothing is tied"));
    r.surgical.clear();
    r.knot = "0_1";
    EXPECT_TRUE(has(report_html(r, {}), "Nothing is tied"));
    EXPECT_FALSE(has(report_html(r, {}), "Tied:"));
}

// The page is mailed and opened on hospital machines: it must not ask for anything outside itself.
TEST(Report, SaysWhatEachToolHeldAndWhetherTheSessionEnded) {
    Result session = tied();
    EXPECT_NE(report_html(session, {}).find("needle and wall"), std::string::npos);
    session.passed = true;
    session.finished = false;
    EXPECT_NE(report_html(session, {}).find("Broken off, not finished"), std::string::npos);
    EXPECT_FALSE(nlohmann::json::parse(result_json(session)).at("finished").get<bool>());
}

TEST(Report, NeedsNothingButItself) {
    const std::string html = report_html(tied(), {{3, "Grasp", {1, 2, 3}}});
    for (const char* outside : {"http://", "https://", "file:", "src=\"/", "<script", "<link", "url(", "@import"})
        EXPECT_FALSE(has(html, outside)) << outside;
    EXPECT_TRUE(has(html, "src=\"data:image/png;base64,AQID\""));
}

// Titles and names come from files that others wrote: they must not become markup.
TEST(Report, TextFromFilesStaysText) {
    const std::string evil = "<script>alert('x')</script>\"&";
    Result r = tied();
    r.drill_title = r.instruments[0] = r.knot = r.surgical = r.throws = r.state_hash = r.machine = evil;
    r.items[0] = {evil, evil, evil, evil, evil, false, 1, evil};
    r.events[0].what = r.events[1].what = r.samples[0].knot = evil;
    const std::string html = report_html(r, {{1, evil, {}}});
    EXPECT_FALSE(has(html, "<script"));
    EXPECT_FALSE(has(html, "alert('"));
    EXPECT_TRUE(has(html, "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&quot;&amp;"));
}

// A drill that stops at once, or a measurement that blew up, must still give a page to read.
TEST(Report, SurvivesEmptyAndBrokenSessions) {
    EXPECT_TRUE(has(report_html(Result{}, {}), "Nothing was sampled"));
    Result r = tied();
    r.duration_s = NAN;
    r.samples[5] = {NAN, NAN, {}, {}, {}, ""};
    r.samples[6].tension_N = INFINITY;
    r.samples[7].t_s = -1;
    r.events[0].t_s = NAN;
    r.separation_min = NAN;
    const std::string html = report_html(r, {{NAN, "When?", {}}});
    for (const char* word : {"\"nan", "\"-nan", "\"inf", " nan", " inf", "M–", "L–", "\"–\""})
        EXPECT_FALSE(has(html, word)) << word;
    r.samples.assign(1, {0, 0, {0, 0}, {0, 0}, {"", ""}, "0_1"});
    EXPECT_TRUE(has(report_html(r, {}), "<svg"));
}

// The peak is what is scored: thinning that drops it would draw a curve that contradicts the table.
TEST(Report, ThinningKeepsThePeak) {
    const std::string html = report_html(tied(), {});
    EXPECT_LT(html.size(), 200'000u);
    EXPECT_TRUE(has(html, ">1.87</text>"));
    const std::string start = "class=\"curve\" d=\"";
    const std::size_t begin = html.find(start) + start.size();  // tension is the first curve
    std::string path = html.substr(begin, html.find('"', begin) - begin);
    for (char& c : path)
        if (c == 'M' || c == 'L') c = ' ';
    std::istringstream points(path);
    std::vector<double> heights;
    for (double x, y; points >> x >> y;) heights.push_back(y);
    ASSERT_GT(heights.size(), 100u);
    std::sort(heights.begin(), heights.end());
    EXPECT_GT(heights[1] - heights[0], 20);  // the one sample of 1.87 N stands far above the other 2399, at most 0.6 N
}

// Test vectors of RFC 4648, section 10.
TEST(Report, Base64) {
    const auto of = [](const std::string& s) { return base64({s.begin(), s.end()}); };
    EXPECT_EQ(of(""), "");
    EXPECT_EQ(of("f"), "Zg==");
    EXPECT_EQ(of("fo"), "Zm8=");
    EXPECT_EQ(of("foo"), "Zm9v");
    EXPECT_EQ(of("foobar"), "Zm9vYmFy");
    EXPECT_EQ(of("\xff\xfe\xfb"), "//77");
}

// Each figure stands beside its own title: of two that are exchanged both could be shown and neither be right.
TEST(Report, EachFigureStandsBesideItsTitle) {
    Result r = tied();
    r.stretch_settled = 0.001234, r.pass_throughs = 3;
    const std::string html = report_html(r, {});
    const std::pair<const char*, const char*> figures[] = {{"Pass-throughs", "3"},
                                                           {"Stretch, largest", "0.400 %"},
                                                           {"Stretch, at the end", "0.123 %"},
                                                           {"Separation, least", "0.9980 diameters"},
                                                           {"Node step, largest", "1.0000 of its bound"},
                                                           {"Contacts, most", "61"},
                                                           {"Links", "300"},
                                                           {"Ticks", "24000"},
                                                           {"Tick time", "41.0 / 63.0 / 120.0 µs"},
                                                           {"State hash", "0123456789abcdef"}};
    for (const auto& [title, value] : figures)
        EXPECT_TRUE(has(html, std::string("<th scope=\"row\">") + title + "</th><td>" + value + "</td>")) << title;
    EXPECT_TRUE(has(html, "In 61234 substeps."));
    EXPECT_TRUE(has(html, "24.0 s of simulated time."));
    r.separation_min = 1e300;
    EXPECT_TRUE(has(report_html(r, {}), "never near"));
}

// How many were missed of how many that were judged, and what an item's row says of it.
TEST(Report, CountsWhatWasMissedAndJudged) {
    Result r = tied();
    EXPECT_TRUE(has(report_html(r, {}), "2 of 3 judged items outside their band."));
    r.items[0].passed = true;
    EXPECT_TRUE(has(report_html(r, {}), "1 of 3 judged items outside their band."));
    EXPECT_TRUE(has(report_html(r, {}),
                    "<th scope=\"row\">Time</th><td>131.0 s</td><td>at most 120 s</td><td "
                    "class=\"sign fail\">✗ fail</td><td class=\"number\">131.0 s</td>"));
    EXPECT_TRUE(has(report_html(r, {}),
                    "<th scope=\"row\">Shorter tail</th><td>6.1 mm</td><td>3 to 8 mm</td><td "
                    "class=\"sign pass\">✓ pass</td><td class=\"number\">24.0 s</td>"));
    r.items[2].passed = true;
    EXPECT_FALSE(has(report_html(r, {}), "judged items outside"));
}

// The plot is 790 wide, from 150 on: an event at half of the session stands in its middle, a bar from one to the other
// moment, and the largest value at its own moment.
TEST(Report, ThingsStandAtTheirMoments) {
    const std::string html = report_html(tied(), {});
    EXPECT_TRUE(has(html, "d=\"M248.8 30.0l5 7")) << "a grasp at 3 of 24 s";
    EXPECT_TRUE(has(html, "<title>12.30 s: slip, right</title>"));
    EXPECT_TRUE(has(html, "d=\"M554.9 ")) << "at 12.3 of 24 s";
    EXPECT_TRUE(has(html, "<title>9.00 to 18.00 s: 3_1</title>"));
    EXPECT_TRUE(has(html, "<rect x=\"446.3\"") || has(html, "<rect x=\"446.2\"")) << "from 9 of 24 s";
    EXPECT_TRUE(has(html, "<title>3.01 to 24.00 s: thread</title>"));
    EXPECT_TRUE(has(html, "<text x=\"713.6\"")) << "1.87 N at 17 of 24 s, and 4 aside";
}

// The page opens on what to do better: misses first, with their pictures, then all else folded away.
TEST(Report, BeginsWithWhatToWorkOn) {
    Result r = tied();
    r.items[1].value = "3.1";
    const std::string html =
        report_html(r, {{9, "Overhand", {1, 2, 3}}, {22, "Granny", {4, 5, 6}}, {24, "The end", {}}});
    const auto place = [&](const std::string& part) {
        EXPECT_TRUE(has(html, part)) << part;
        return html.find(part);
    };
    const std::size_t knot = place("<h3>✗ Knot</h3>\n<p><strong>granny</strong>, asked: square. At 21.5 s."),
                      time =
                          place("<h3>✗ Time</h3>\n<p><strong>131.0 s</strong>, asked: at most 120 s: 11 s too much."),
                      picture = place("src=\"data:image/png;base64,BAUG\""), fold = place("<details>");
    EXPECT_LT(place("Not passed"), knot);
    EXPECT_LT(knot, picture) << "that of 22 s is nearest to 21.5 s";
    EXPECT_LT(picture, time);
    EXPECT_LT(time, place("close to the edge: Shorter tail 3.1 mm (3 to 8 mm)."));
    EXPECT_LT(place("close to the edge"), fold);
    EXPECT_LT(fold, place("<th scope=\"row\">Shorter tail")) << "what passed is folded away";
    EXPECT_LT(place("<th scope=\"row\">Shorter tail"), place("<th scope=\"row\">Path length, left tool"));
    EXPECT_EQ(html.find("BAUG"), html.rfind("BAUG")) << "a picture is in the page once, however large";
    EXPECT_TRUE(has(html, "Granny (picture above)"));
    EXPECT_FALSE(has(html, "<details open"));
    for (auto& item : r.items) item.passed = true, item.value = "5";
    EXPECT_FALSE(has(report_html(r, {}), "What to work on"));
}
