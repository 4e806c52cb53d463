#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace {

struct Output {
    std::string text;
    int exit_code;
};

Output carrel(const std::string& arguments) {
    FILE* pipe = popen((CARREL_PROGRAM " " + arguments).c_str(), "r");
    Output output{"", -1};
    std::array<char, 4096> buffer;
    for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) output.text.append(buffer.data(), n);
    const int status = pclose(pipe);
    output.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return output;
}

std::string curve(const std::string& id) {
    return std::string(CARREL_SOURCE) + "/tests/data/curves/" + id + ".xyz";
}

std::filesystem::path written(const std::string& name, const std::string& text) {
    const auto path =
        std::filesystem::path(testing::TempDir()) / ("carrel_knot_test_" + std::to_string(getpid()) + name);
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

}  // namespace

// Scripts read this object: every key of the contract, and nothing else on stdout.
TEST(KnotCommand, PrintsTheAgreedJson) {
    const auto output = carrel("knot --json " + curve("p103") + " " + curve("p099"));
    ASSERT_EQ(output.exit_code, 0);
    const auto curves = nlohmann::json::parse(output.text).at("curves");
    ASSERT_EQ(curves.size(), 2u);
    const auto& square = curves[0];
    EXPECT_EQ(square.at("file"), curve("p103"));
    EXPECT_EQ(square.at("components"), 1);
    EXPECT_EQ(square.at("open"), true);
    EXPECT_EQ(square.at("knot"), "3_1#m3_1");
    EXPECT_EQ(square.at("factors")[1], (nlohmann::json{{"name", "3_1"}, {"mirror", true}, {"crossings", 3}}));
    EXPECT_EQ(square.at("surgical"), (nlohmann::json{{"name", "square"}, {"throws", "1=1"}, {"flat", true}}));
    EXPECT_EQ(square.at("crossings").at("reduced"), 6);
    EXPECT_GE(square.at("crossings").at("projected"), 6);
    EXPECT_EQ(square.at("certain"), true);
    EXPECT_GE(square.at("microseconds"), 0);
    EXPECT_EQ(curves[1].at("knot"), "0_1");
    EXPECT_TRUE(curves[1].at("surgical").is_null());
}

TEST(KnotCommand, PrintsOneLineACurve) {
    const auto output = carrel("knot " + curve("p109"));
    EXPECT_EQ(output.text, curve("p109") + ": m3_1#5_1, surgeon's (2=1)\n");
    EXPECT_EQ(carrel("knot --closed " + curve("p009")).text, curve("p009") + ": 5_2\n");
}

TEST(KnotCommand, NamesTheLinkWithWhatItIsTiedRound) {
    const auto ring = written("ring.xyz", "0 -1 -3\n0 9 -3\n0 9 -99\n0 -9 -99\n0 -9 -3\n0 -1 -3\n");
    const auto rope = written("rope.xyz", "-20 0 0\n-5 0 0\n0 1 -6\n5 0 0\n20 0 0.5\n");
    const auto apart = carrel("knot --json " + rope.string() + " --around " + ring.string());
    ASSERT_EQ(apart.exit_code, 0);
    const auto json = nlohmann::json::parse(apart.text).at("curves")[0];
    EXPECT_EQ(json.at("components"), 2);
    EXPECT_EQ(json.at("component_knots"), (nlohmann::json{"0_1", "0_1"}));
    EXPECT_EQ(json.at("knot"), json.at("linking_numbers")[0] == 1 ? "L2a1" : "unlink");
    std::filesystem::remove(ring);
    std::filesystem::remove(rope);
}

// Whatever a file holds: exit 2 and one line that begins with its name.
TEST(KnotCommand, RefusesBadFilesWithOneLine) {
    std::string junk;
    for (int i = 0; i < 5000; ++i) junk.push_back(static_cast<char>(i * 7919 >> 3));
    const std::vector<std::pair<std::string, std::string>> bad{
        {"empty.xyz", ""},
        {"one.xyz", "1 2 3\n"},
        {"nan.csv", "0,0,0\nnan,0,0\n"},
        {"junk.xyz", junk},
        {"junk.ply", junk},
        {"header.csv", "x,y,z\n0,0,0\n1,1,1\n"},
        {"touch.txt", "0 0 0\n1 0 0\n1 1 0\n0.5 0 0\n0.5 -1 0\n"},
        {"cut.xyz", "0 0 0\n1 0 0\n1 1"},
        {"fold.xyz", "0 0 0\n2 0 0\n1 0 0\n"}};
    for (const auto& [name, text] : bad) {
        SCOPED_TRACE(name);
        const auto path = written(name, text);
        const auto output = carrel("knot " + path.string() + " 2>&1");
        EXPECT_EQ(output.exit_code, 2);
        EXPECT_EQ(output.text.rfind(path.string(), 0), 0u) << output.text;
        EXPECT_EQ(std::count(output.text.begin(), output.text.end(), '\n'), 1) << output.text;
        std::filesystem::remove(path);
    }
    EXPECT_EQ(carrel("knot no-such-file.xyz 2>&1").text, "no-such-file.xyz: error: no such file\n");
    EXPECT_EQ(carrel("knot " + testing::TempDir() + " 2>&1").exit_code, 2);
    EXPECT_EQ(carrel("knot 2>&1").exit_code, 2);
}

TEST(KnotCommand, ATouchNamesBothPlaces) {
    const auto path = written("both.xyz", "0 0 0\n1 0 0\n1 1 0\n0.5 0 0\n0.5 -1 0\n");
    EXPECT_EQ(carrel("knot " + path.string() + " 2>&1").text,
              path.string() + ":1: error: the edge from here touches the edge from " + path.string() +
                  ":3, so the knot is undefined; expected strands apart\n");
    std::filesystem::remove(path);
}
