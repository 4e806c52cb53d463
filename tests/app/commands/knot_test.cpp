#include <nlohmann/json.hpp>

#include "tests/program.hpp"

namespace {

program::Ending knot(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "knot");
    return program::run(arguments);
}

std::string curve(const std::string& id) {
    return std::string(CARREL_SOURCE) + "/tests/data/curves/" + id + ".xyz";
}

}  // namespace

// Scripts read this object: every key of the contract, and nothing else on stdout.
TEST(KnotCommand, PrintsTheAgreedJson) {
    const auto output = knot({"--json", curve("p103"), curve("p099")});
    ASSERT_EQ(output.exit, 0);
    EXPECT_EQ(output.said, "");
    const auto curves = nlohmann::json::parse(output.out).at("curves");
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
    EXPECT_EQ(knot({curve("p109")}).out, curve("p109") + ": m3_1#5_1, surgeon's (2=1)\n");
    EXPECT_EQ(knot({"--closed", curve("p009")}).out, curve("p009") + ": 5_2\n");
}

TEST(KnotCommand, NamesTheLinkWithWhatItIsTiedRound) {
    const program::Folder folder;
    const auto ring = folder.write("ring.xyz", "0 -1 -3\n0 9 -3\n0 9 -99\n0 -9 -99\n0 -9 -3\n0 -1 -3\n");
    const auto rope = folder.write("rope.xyz", "-20 0 0\n-5 0 0\n0 1 -6\n5 0 0\n20 0 0.5\n");
    const auto apart = knot({"--json", rope, "--around", ring});
    ASSERT_EQ(apart.exit, 0);
    const auto json = nlohmann::json::parse(apart.out).at("curves")[0];
    EXPECT_EQ(json.at("components"), 2);
    EXPECT_EQ(json.at("component_knots"), (nlohmann::json{"0_1", "0_1"}));
    EXPECT_EQ(json.at("knot"), json.at("linking_numbers")[0] == 1 ? "L2a1" : "unlink");
}

// Whatever a file holds: exit 2 and one line that begins with its name.
TEST(KnotCommand, RefusesBadFilesWithOneLine) {
    const program::Folder folder;
    const std::string junk = program::junk(1, 5000);
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
        const auto path = folder.write(name, text);
        const auto output = knot({path});
        program::expect_one_line_naming(path, output);
        EXPECT_EQ(output.said.rfind(path, 0), 0u) << output.said;
    }
    EXPECT_EQ(knot({"no-such-file.xyz"}).said, "no-such-file.xyz: error: no such file\n");
    EXPECT_EQ(knot({folder.path("")}).exit, 2);
    EXPECT_EQ(knot({}).exit, 2);
}

TEST(KnotCommand, ATouchNamesBothPlaces) {
    const program::Folder folder;
    const auto path = folder.write("both.xyz", "0 0 0\n1 0 0\n1 1 0\n0.5 0 0\n0.5 -1 0\n");
    EXPECT_EQ(knot({path}).said, path + ":1: error: the edge from here touches the edge from " + path +
                                     ":3, so the knot is undefined; expected strands apart\n");
}
