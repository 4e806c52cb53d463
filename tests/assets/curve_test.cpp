#include "assets/curve.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace {

// A file of this text in the test's own folder, gone afterwards.
class File {
  public:
    explicit File(const std::string& text, const std::string& name = "curve.xyz")
        : path_(std::filesystem::path(testing::TempDir()) / ("carrel_curve_test_" + std::to_string(getpid()) + name)) {
        std::ofstream(path_, std::ios::binary) << text;
    }
    ~File() { std::filesystem::remove(path_); }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

std::string fault(const std::string& text, const std::string& name = "curve.xyz") {
    const File file(text, name);
    try {
        assets::load_curve(file.path());
    } catch (const assets::AssetError& error) {
        return std::string(error.what()).substr(file.path().string().size());
    }
    return "no fault";
}

}  // namespace

TEST(LoadCurve, ReadsComponentsInMillimetres) {
    const File file("# two\n1 2 3\r\n4,5,6 # end\n\n\n0 0 0\n1 0 0\n# a comment parts nothing\n1 1 0\n0 0 0\n");
    const auto curve = assets::load_curve(file.path());
    ASSERT_EQ(curve.components.size(), 2u);
    EXPECT_FALSE(curve.components[0].closed);
    EXPECT_EQ(curve.components[0].vertices[1], 1e-3 * assets::Vec3(4, 5, 6));
    EXPECT_TRUE(curve.components[1].closed);
    EXPECT_EQ(curve.components[1].vertices.size(), 3u);
    EXPECT_EQ(curve.place(1, 2), file.path().string() + ":9");
}

TEST(LoadCurve, ReadsLinesOfObjAndVerticesOfPly) {
    const File obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 5 5\nv 6 6 6\nl 1 2 3 1\nl 4 5\n", "lines.obj");
    const auto lines = assets::load_curve(obj.path());
    ASSERT_EQ(lines.components.size(), 2u);
    EXPECT_TRUE(lines.components[0].closed);
    EXPECT_EQ(lines.components[0].vertices.size(), 3u);
    const File ply(
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 "
        "0 0\n1 0 0\n",
        "v.ply");
    EXPECT_EQ(assets::load_curve(ply.path()).components.at(0).vertices.size(), 2u);
}

// Every way a file can be wrong names the line and says what would be right.
TEST(LoadCurve, SaysWhereAndWhatIsWrong) {
    EXPECT_EQ(fault(""), ": error: holds no vertices; expected one 'x y z' in mm a line");
    EXPECT_EQ(fault("0 0 0\n"), ":1: error: a curve of one vertex; expected at least two");
    EXPECT_EQ(fault("0 0 0\n1 nan 0\n"), ":2:3: error: expected a finite coordinate within 1e9 mm, found 'nan'");
    EXPECT_EQ(fault("0 0 0\n1 0 1e999\n"), ":2:5: error: expected a finite coordinate within 1e9 mm, found '1e999'");
    EXPECT_EQ(fault("0 0 0\n1 0x 0\n"), ":2:3: error: expected a number, found '0x'; a line is 'x y z' in mm");
    EXPECT_EQ(fault("0 0\n"), ":1: error: expected three numbers 'x y z' in mm, found 2");
    for (const char* point : {"1 1 1\n1 1 1\n", "0 0 0\n1e-200 0 0\n1e-200 1e-200 0\n0 0 1e-200\n"})
        EXPECT_EQ(fault(point), ":1: error: all vertices of this component are in one place; expected a curve");
    EXPECT_EQ(fault("\xffx"), ":1:1: error: expected a number, found '?x'; a line is 'x y z' in mm");
    EXPECT_EQ(fault(std::string(100000, '1')),
              ":1: error: a line of more than 4000 characters is not a vertex 'x y z'");
    EXPECT_EQ(fault("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "face.obj"),
              ":4: error: holds faces, not lines; expected a curve");
    EXPECT_NE(fault("\x01\x02\x03", "junk.ply").find(": error: "), std::string::npos);
    EXPECT_THROW(assets::load_curve(testing::TempDir()), assets::AssetError);
    EXPECT_THROW(assets::load_curve("no/such/file.xyz"), assets::AssetError);
    std::string many;
    for (int i = 0; i <= assets::most_curve_vertices; ++i) many += "1 1 1\n";
    EXPECT_EQ(fault(many), ":200001: error: more than 200000 vertices; resample the curve to fewer");
}
