#include "assets/curve.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace assets {

namespace {

std::filesystem::path written(const std::string& text, const std::string& type = ".xyz") {
    const auto file = std::filesystem::path(testing::TempDir()) / ("carrel-curve" + type);
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

std::string error_of(const std::filesystem::path& file) {
    try {
        load_curves(file);
    } catch (const AssetError& error) {
        return error.what();
    }
    return "none";
}

// Millimetres in the file, metres inside; blank lines part components, comments do not.
TEST(Curves, ComponentsCommentsAndSeparatorsAreRead) {
    const auto curves =
        load_curves(written("# head\r\n1 2 3\r\n+4,5 , 6e0 # inline\n#\n7\t8\t9\n\n\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n"));
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_FALSE(curves[0].closed);
    ASSERT_EQ(curves[0].vertices.size(), 3u);
    EXPECT_EQ(curves[0].vertices[1], Vec3(4e-3, 5e-3, 6e-3));
    EXPECT_TRUE(curves[1].closed);
    EXPECT_EQ(curves[1].vertices.size(), 3u);  // A repeated first vertex would be an edge without length.
}

// Each mistake is told in one line with its place; a file of junk is not echoed to the terminal.
TEST(Curves, BadFilesAreToldWithTheirLine) {
    const auto bad = [](const std::string& text) { return error_of(written(text)); };
    EXPECT_NE(bad("0 0 0\n1 nan 0\n").find("xyz:2: error: a coordinate is not finite"), std::string::npos);
    EXPECT_NE(bad("0 0 0\n1 inf 0\n").find("xyz:2: error: a coordinate is not finite"), std::string::npos);
    EXPECT_NE(bad("0 0 0\n1 1e999 0\n").find("xyz:2: error: not a vertex"), std::string::npos);
    EXPECT_NE(bad("0 0 0\n1 0\n").find("xyz:2: error: not a vertex"), std::string::npos);
    EXPECT_NE(bad("0 0 0\n1 0 0 0\n").find("xyz:2: error: more than three"), std::string::npos);
    EXPECT_NE(bad("\n1 2 3\n").find("xyz:2: error: a curve of one place"), std::string::npos);
    EXPECT_NE(bad("").find("xyz: error: no vertices"), std::string::npos);
    EXPECT_NE(error_of(testing::TempDir()).find("error: is no file"), std::string::npos);
    EXPECT_NE(error_of("missing.xyz").find("error: no such file"), std::string::npos);
    EXPECT_NE(error_of(written("1 2 3\n", ".stl")).find("'.stl' is not a known kind"), std::string::npos);
    const std::string junk =
        bad(std::string("\x7f"
                        "ELF\0\1\x1b[31m\xff",
                        12));
    EXPECT_NE(junk.find("xyz:1: error: not a vertex"), std::string::npos);
    EXPECT_EQ(junk.find('\x1b'), std::string::npos);
    EXPECT_EQ(junk.find('\n'), std::string::npos);
}

// The program itself: one line on stderr and exit code 2, nothing on stdout.
TEST(Curves, TheProgramAnswersABadFileWithExitTwo) {
    const auto file = written("0 0 0\n1 nan 0\n");
    const auto out = std::filesystem::path(testing::TempDir()) / "carrel-curve-out";
    const std::string command =
        std::string(CARREL_PROGRAM) + " knot --json '" + file.string() + "' > '" + out.string() + "'";
    EXPECT_EQ(std::system((command + " 2> /dev/null").c_str()), 2 * 256);
    EXPECT_EQ(std::filesystem::file_size(out), 0u);
}

}  // namespace

}  // namespace assets
