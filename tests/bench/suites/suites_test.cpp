#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "sim/geometry/closest_points.hpp"
#include "sim/knot/namer.hpp"
#include "tests/bench/lab/gauge.hpp"
#include "tests/bench/lab/shape.hpp"
#include "tests/bench/suites/plot.hpp"
#include "tests/bench/suites/print.hpp"
#include "tests/bench/suites/speed.hpp"
#include "tests/bench/suites/tissue.hpp"
#include "tests/program.hpp"

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

using bench::lab::Gauge;
using bench::lab::Must;
using bench::lab::Row;
using bench::lab::Suite;
using nlohmann::json;
using sim::geometry::Vec3;

Row row(const std::string& id, double value, std::optional<double> bound = {}, Must must = Must::be_at_most) {
    Row made = bench::suites::told(id, "a figure", value, "us", 0.5);
    made.bound = bound, made.must = must;
    return made;
}

json printed(const Suite& suite) {
    std::ostringstream out;
    bench::suites::print_json(out, suite, {"a machine", "a build"});
    return json::parse(out.str());
}

void expect_the_contracts_keys(const json& answer) {
    for (const char* key : {"suite", "machine", "build"}) EXPECT_TRUE(answer.at(key).is_string()) << key;
    std::set<std::string> ids;
    for (const json& row : answer.at("rows")) {
        SCOPED_TRACE(row.dump());
        EXPECT_EQ(row.size(), 8u);
        for (const char* key : {"id", "what", "unit"}) EXPECT_TRUE(row.at(key).is_string()) << key;
        for (const char* key : {"value", "bound", "error"})
            EXPECT_TRUE(row.at(key).is_number() || row.at(key).is_null()) << key;
        EXPECT_TRUE(row.at("pass").is_boolean());
        EXPECT_TRUE(row.at("seconds").is_number());
        EXPECT_TRUE(ids.insert(row.at("id")).second) << "twice";
    }
}

// A figure that is no number must neither pass nor break the file for whoever reads it.
TEST(Bench, RowsArePrintedAsTheContractSays) {
    Suite suite{"speed", {row("told", 1), row("bound", 2, 3), row("nothing", NAN, 3), row("spread", 4)}};
    suite.rows[3].error = 0.25;
    const json answer = printed(suite);
    expect_the_contracts_keys(answer);
    EXPECT_EQ(answer["rows"][0]["bound"], nullptr);
    EXPECT_EQ(answer["rows"][0]["error"], nullptr);
    EXPECT_EQ(answer["rows"][1]["bound"], 3);
    EXPECT_EQ(answer["rows"][2]["value"], nullptr);
    EXPECT_EQ(answer["rows"][2]["pass"], false);
    EXPECT_EQ(answer["rows"][3]["error"], 0.25);
}

TEST(Bench, WhatMissesItsBoundIsNamed) {
    const Suite good{"speed", {row("a", 1), row("b", 2, 2), row("c", 2, 2, Must::be_at_least)}};
    EXPECT_EQ(bench::suites::missed(good), "");
    const Suite bad{"speed", {row("a", 2.1, 2), row("b", 1), row("c", 1.9, 2, Must::be_at_least), row("d", NAN, 2)}};
    EXPECT_EQ(bench::suites::missed(bad), "a, c, d");
    std::ostringstream table;
    bench::suites::print_table(table, bad, {"a machine", "a build"});
    EXPECT_NE(table.str().find("<= 2   MISSED"), std::string::npos) << table.str();
    EXPECT_NE(table.str().find(">= 2   MISSED"), std::string::npos) << table.str();
}

// Links that differ, or no knot, would measure another pull than peers are known by.
TEST(Bench, TheOverhandIsATrefoilOfEqualLinks) {
    for (const int links : {100, 201, 1000}) {
        SCOPED_TRACE(links);
        const double link = 1.0 / links;
        const std::vector<Vec3> nodes = bench::lab::overhand(links, 1);
        ASSERT_EQ(nodes.size(), static_cast<std::size_t>(links) + 1);
        for (std::size_t i = 1; i < nodes.size(); ++i)
            ASSERT_NEAR((nodes[i] - nodes[i - 1]).norm(), link, 1e-12);  // rounding at 1 m
        const Gauge gauge(std::vector<double>(nodes.size() - 1, link), link);
        EXPECT_GT(gauge.gap(nodes), 1.5) << "not loose";  // the nearest that count are two links apart along the rope
        EXPECT_NEAR(gauge.kappa(nodes), (1 - (nodes.back() - nodes.front()).norm()) / link, 1e-6);
        const std::string knot = sim::knot::name_knot(nodes).knot;
        EXPECT_TRUE(knot == "3_1" || knot == "m3_1") << knot;
    }
}

// The gauge skips what its own bound says is far off: every pair, one by one, must not know better.
TEST(Bench, TheSmallestGapIsThatOfEveryPair) {
    constexpr int links = 200;
    std::mt19937 random(1);
    std::normal_distribution<double> shake;
    for (const double share : {0.0, 0.2, 0.8}) {  // of a link
        SCOPED_TRACE(share);
        std::vector<Vec3> nodes = bench::lab::coil(links, 1, 5, 1.05);
        for (Vec3& p : nodes) p += share * Vec3(shake(random), shake(random), shake(random));
        double least = 3;
        constexpr std::size_t neighbours = 3;  // ceil(pi / 2) + 1, as thick as long
        for (std::size_t i = 0; i < links; ++i)
            for (std::size_t j = i + neighbours; j < links; ++j) {
                const auto pair = sim::geometry::closest_points(nodes[i], nodes[i + 1], nodes[j], nodes[j + 1]);
                least = std::min(least, std::sqrt(pair.distance_squared));
            }
        EXPECT_EQ(Gauge(std::vector<double>(links, 1.0), 1).gap(nodes), least);
    }
}

TEST(Bench, WhatIsNoPlaceHasNoFigures) {
    std::vector<Vec3> nodes = bench::lab::overhand(100, 1);
    nodes[50].x() = NAN;
    const Gauge gauge(std::vector<double>(100, 0.01), 0.01);
    EXPECT_TRUE(std::isnan(gauge.stretch(nodes)));
    EXPECT_TRUE(std::isnan(gauge.gap(nodes)));
}

// A point needs its error and its cost; what the quick suite does not measure is left out.
TEST(Bench, ThePictureOfTissueShowsErrorsOverCosts) {
    const std::string step = "pull-n16-30mN-step2-moves1-factor8";
    Suite suite{"tissue",
                {row(step + "-off", 1.5), row("pressure-axial100-n16-growth", 4), row("edge-100mN-n16", 5),
                 row("bite-100mN-n16", 6)}};
    const auto points = [&] {
        const std::string drawn = bench::suites::tissue_picture(suite);
        int count = 0;
        for (auto at = drawn.find("<circle"); at != std::string::npos; at = drawn.find("<circle", at + 1)) ++count;
        return count;
    };
    EXPECT_EQ(points(), 0) << "costs are not known";
    suite.rows.push_back(row(step + "-mean", 300));
    EXPECT_EQ(points(), 4);
    EXPECT_NE(bench::suites::tissue_picture(suite).find(">8</text>"), std::string::npos) << "factored in 8 steps";
}

TEST(Bench, ASuiteThatThereIsNotIsAFaultOfTheCaller) {
    for (const std::string suite : {"nonsense", "Speed", ""})
        program::expect_one_line_naming("SUITE", program::run({"bench", suite}));
}

// One whole run through the real program, peers that were built included. Times are whatever they are here. Not under
// the sanitizers, as the next: minutes, of what rooms' own tests show them.
TEST(Bench, TheQuickSuiteRunsAndItsExitSaysWhetherAllBoundsHold) {
    if (sanitized) GTEST_SKIP();
    const program::Folder folder;
    const std::string plot = folder.path("plot.svg");
    const auto ending =
        program::run({"bench", "speed", "--quick", "--json", "--plot", plot}, std::chrono::seconds(600));
    ASSERT_TRUE(ending.exit == 0 || ending.exit == 3) << ending.said;
    const json answer = json::parse(ending.out);
    EXPECT_EQ(answer.at("suite"), "speed");
    expect_the_contracts_keys(answer);
    std::string missed;
    for (const json& row : answer["rows"])
        if (!row["pass"].get<bool>()) missed += (missed.empty() ? "" : ", ") + row["id"].get<std::string>();
    EXPECT_EQ(ending.exit, missed.empty() ? 0 : 3);
    EXPECT_TRUE(missed.empty() || ending.said.ends_with(": " + missed + "\n")) << ending.said;
    for (const std::string id : {"pull-n200-tick-p50", "pull-n200-fast-lag", "bullet-pull-n200-tick-p50",
                                 "growth-coiled-exponent", "ftl-link1-tick1-cost"})
        EXPECT_NE(ending.out.find('"' + id + '"'), std::string::npos) << id;
    EXPECT_TRUE(program::read(plot).starts_with("<svg "));
}

// Both threads are asked the same, and the elastic one bends as theory says while the other does not bend at all.
TEST(Bench, SpeedVsErrorAsksBothThreadsTheSame) {
    if (sanitized) GTEST_SKIP();
    const program::Folder folder;
    const std::string plots = folder.path("plots");
    const auto ending =
        program::run({"bench", "speed-vs-error", "--quick", "--json", "--plot", plots}, std::chrono::seconds(600));
    ASSERT_EQ(ending.exit, 0) << ending.said;
    const json answer = json::parse(ending.out);
    EXPECT_EQ(answer.at("suite"), "speed-vs-error");
    expect_the_contracts_keys(answer);
    std::map<std::string, double> values;
    for (const json& row : answer["rows"]) {
        ASSERT_TRUE(row["value"].is_number()) << row.dump();  // what is no number is printed as null
        values[row["id"]] = row["value"];
        EXPECT_GE(values[row["id"]], 0) << row.dump();
    }
    for (const std::string problem : {"capstan-half-", "capstan-one-", "cantilever-", "helix-", "loose-overhand-",
                                      "rough-overhand-", "tight-overhand-", "square-granny-mu1-", "square-granny-mu2-"})
        for (const std::string thread : {"ftl-", "elastic-"})
            for (const std::string figure : {problem.starts_with("square") ? "-found" : "-error", "-cost"}) {
                const auto is_it = [&](const auto& row) {
                    return row.first.starts_with(problem + thread) && row.first.ends_with(figure);
                };
                EXPECT_EQ(std::count_if(values.begin(), values.end(), is_it), 1) << problem << thread << figure;
            }
    EXPECT_LT(values.at("cantilever-elastic-link20-tick4-error"), 1);
    EXPECT_GT(values.at("cantilever-ftl-link20-tick4-error"), 99);
    EXPECT_LT(values.at("ring-turn-rod-link40-error"), values.at("ring-turn-rod-link20-error"));
    EXPECT_LT(values.at("capstan-half-elastic-link2-tick4-error"), 5);  // of the ratio, as `carrel bench accuracy` asks
    EXPECT_GT(values.at("drill-square-shipped-knot"), 0);               // it still ties something
    for (const std::string name : {"capstan-half", "square-granny-mu2", "helix-angle"})
        EXPECT_TRUE(program::read(plots + "/" + name + ".svg").starts_with("<svg ")) << name;
}

// Ten times as much is as far along a logarithmic axis everywhere, and what has no logarithm is left out.
TEST(Bench, APlotWithTwoLogarithmicAxesHasEvenDecades) {
    const bench::suites::Series series{"a thread",
                                       {{1, 0.1, "first"}, {10, 1, "second"}, {100, 10, "third"}, {10, 0, "none"}}};
    const std::string picture = bench::suites::svg({{"cost", "error", {series}, true}}), start = "<polyline points=\"";
    std::istringstream points(picture.substr(picture.find(start) + start.size()));
    double x[3], y[3];
    char comma;
    for (int i = 0; i < 3; ++i) points >> x[i] >> comma >> y[i];
    constexpr double digit = 0.11;  // pixels are written to a tenth
    EXPECT_GT(x[1] - x[0], 100);
    EXPECT_NEAR(x[2] - x[1], x[1] - x[0], digit);
    EXPECT_LT(y[1] - y[0], -100);
    EXPECT_NEAR(y[2] - y[1], y[1] - y[0], digit);
    EXPECT_EQ(picture.find(">none<"), std::string::npos);
}

}  // namespace
