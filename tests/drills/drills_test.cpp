#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;

struct Played {
    int exit;
    nlohmann::json result;
};

int run(const std::string& arguments) { return WEXITSTATUS(std::system((std::string(CARREL_PROGRAM) + " " + arguments).c_str())); }

fs::path scratch(const std::string& drill) {
    const fs::path dir = fs::temp_directory_path() / ("carrel-drills-" + drill);
    fs::create_directories(dir);
    return dir;
}

Played play(const std::string& drill) {
    const fs::path out = scratch(drill) / "result.json";
    const int exit = run("run " CARREL_SOURCE "/scenarios/drills/" + drill + ".json --json --record " +
                         (scratch(drill) / "session.carrel").string() + " > " + out.string());
    return {exit, nlohmann::json::parse(std::ifstream(out), nullptr, false)};
}

// What every drill must keep to whatever is tied: a thread that passes through something, stretches or jumps its bound
// makes every score worthless.
void expect_sound(const nlohmann::json& result) {
    const auto& thread = result["thread"];
    EXPECT_EQ(thread["pass_throughs"], 0);
    EXPECT_LE(thread["stretch"]["max"].get<double>(), 0.01);
    EXPECT_LE(thread["stretch"]["settled"].get<double>(), 0.001);
    EXPECT_LE(thread["node_step"]["max_over_bound"].get<double>(), 1 + 1e-12);  // rounding of one division
}

// A second process must reach the same bits, and a recording that was tampered with must not.
void expect_replays(const std::string& drill) {
    const std::string file = (scratch(drill) / "session.carrel").string();
    EXPECT_EQ(run("replay --verify " + file + " 2> /dev/null"), 0);
}

TEST(Drills, SquareIsTiedNamedAndReplayed) {
    const Played played = play("square-knot");
    ASSERT_EQ(played.exit, 0);
    EXPECT_EQ(played.result["surgical"], "square");
    EXPECT_EQ(played.result["throws"], "1=1");
    EXPECT_TRUE(played.result["passed"]);
    expect_sound(played.result);
    expect_replays("square-knot");
}

// The same two throws without crossing hands: a drill that calls this a square knot would teach a knot that slips.
TEST(Drills, GrannyFailsItsGoalAndSaysWhy) {
    const Played played = play("granny-knot");
    ASSERT_EQ(played.exit, 0);
    EXPECT_EQ(played.result["surgical"], "granny");
    EXPECT_FALSE(played.result["passed"]);
    for (const auto& item : played.result["items"])
        if (item["name"] == "knot") {
            EXPECT_NE(item["why"].get<std::string>().find("granny"), std::string::npos);
        }
    expect_sound(played.result);
    expect_replays("granny-knot");
}

}  // namespace
