#include "assets/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

using namespace assets;

static std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

// Someone edits the tool, or the file: either way what is committed is no longer what the README says.
TEST(Meshes, TheCommittedVesselIsWhatTheToolMakes) {
    const auto made = std::filesystem::path(testing::TempDir()) / "vessel-4mm-made.obj";
    ASSERT_EQ(std::system((std::string(CARREL_MAKE_TUBE) + " 4 0.6 30 48 30 > '" + made.string() + "'").c_str()), 0);
    EXPECT_GT(text_of(made).size(), 1000u);
    EXPECT_EQ(text_of(made), text_of(CARREL_SOURCE "/assets/meshes/vessel-4mm.obj"));
}

// A tube with a hole lets thread in; one that faces inwards pushes it to the wrong side.
TEST(Meshes, ATubeIsClosedFacesOutwardsAndHasItsVolume) {
    for (const auto& [around, along] : {std::pair(3, 1), std::pair(8, 5), std::pair(48, 30)}) {
        const double outer = 4e-3, wall = 0.6e-3, length = 30e-3;
        const Mesh tube = make_tube(outer, wall, length, around, along);
        std::map<std::pair<int, int>, int> uses;
        for (const auto& t : tube.triangles)
            for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
        for (const auto& [edge, count] : uses) {
            EXPECT_EQ(count, 1);
            EXPECT_EQ(uses.count({edge.second, edge.first}), 1u);
        }
        const auto disc = [n = around](double radius) {
            return n / 2.0 * radius * radius * std::sin(2 * EIGEN_PI / n);
        };
        const double expected = length * (disc(outer / 2) - disc(outer / 2 - wall));
        EXPECT_NEAR(volume(tube), expected, 1e-12 * expected);
    }
}

// Written in mm and read back in m, corner by corner the same to the nanometre it is written in and to float rounding.
TEST(Meshes, AFileReadBackIsTheMeshThatWasWritten) {
    const Mesh tube = make_tube(4e-3, 0.6e-3, 30e-3, 48, 30);
    const Mesh read = load_mesh(CARREL_SOURCE "/assets/meshes/vessel-4mm.obj");
    EXPECT_EQ(read.vertices.size(), tube.vertices.size());
    const auto expected = tube.soup(), found = read.soup();
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_LT((found[i].a - expected[i].a).norm(), 2e-9);
        EXPECT_LT((found[i].b - expected[i].b).norm(), 2e-9);
        EXPECT_LT((found[i].c - expected[i].c).norm(), 2e-9);
    }
}

static std::string error_of(const std::filesystem::path& file) {
    try {
        load_mesh(file);
    } catch (const AssetError& error) {
        return error.what();
    }
    return "";
}

static std::string error_in(const std::string& text, const std::string& name = "bad.obj") {
    const auto file = std::filesystem::path(testing::TempDir()) / name;
    std::ofstream(file) << text;
    const std::string error = error_of(file);
    if (!error.empty()) {
        EXPECT_EQ(error.find(file.string() + ": error: "), 0u) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
    return error;
}

// Every one of these has crashed, hung or silently emptied some program's scene. The author must learn which triangle.
TEST(Meshes, ABadFileIsOneClearLine) {
    const std::string square = "v 0 0 0\nv 5 0 0\nv 5 5 0\nv 0 5 0\n", third = "v 2 2 3\nv 2 2 -3\n";
    const auto has = [](const std::string& error, const char* what) {
        return error.find(what) != std::string::npos ? testing::AssertionSuccess()
                                                     : testing::AssertionFailure() << error;
    };
    EXPECT_EQ(error_in(square + "f 1 2 3 4\n"), "");
    EXPECT_EQ(error_in(square + "f 1 2 3\nf 1 3 4\n"), "");
    EXPECT_TRUE(has(error_of("no/such/file.obj"), "no such file"));
    EXPECT_TRUE(has(error_of(testing::TempDir()), "directory"));
    EXPECT_TRUE(has(error_in(square, "bad.txt"), "'.txt'"));
    EXPECT_FALSE(error_in("").empty());
    EXPECT_FALSE(error_in("hello\n").empty());
    EXPECT_FALSE(error_in("solid\0garbage", "bad.stl").empty());
    const std::string ply = "ply\nformat ascii 1.0\nelement vertex ", axes = "property float x\nproperty float y\n";
    EXPECT_TRUE(has(error_in(ply + "3\n" + axes, "bad.ply"), "end_header"));
    EXPECT_TRUE(has(error_in(ply + "999999999\n" + axes + "end_header\n0 0\n", "bad.ply"), "999999999"));
    EXPECT_FALSE(error_in(ply + "3\n" + axes + "end_header\n0 0\n", "bad.ply").empty());
    const std::string face =
        axes + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 ";
    EXPECT_EQ(error_in(ply + "3\n" + face + "2\n", "good.ply"), "");
    for (const std::string corner : {"3", "999999", "-1"})
        EXPECT_TRUE(has(error_in(ply + "3\n" + face + corner + "\n", "bad.ply"), "a corner that does not exist"))
            << corner;
    EXPECT_FALSE(error_in(square).empty());
    EXPECT_FALSE(error_in(square + "f 1 2 9\n").empty());
    EXPECT_TRUE(has(error_in("v nan 0 0\nv 5 0 0\nv 5 5 0\nf 1 2 3\n"), "not a finite number"));
    EXPECT_TRUE(has(error_in("v 0 0 0\nv 5000 0 0\nv 5 5 0\nf 1 2 3\n"), "5000"));
    EXPECT_TRUE(has(error_in("v 0 0 0\nv 0.005 0 0\nv 0.005 0.005 0\nf 1 2 3\n"), "is it written in mm?"));
    EXPECT_EQ(error_in(square + "f 1 2 3\nf 1 2 1\n"), "");
    EXPECT_TRUE(has(error_in("v 0 0 0\nv 5 5 5\nv 1 1 1\nf 1 2 3\n"), "no triangle with an area"));
    EXPECT_TRUE(has(error_in(square + "f 1 2 3\nf 2 3 1\n"), "triangle 2 is there twice"));
    EXPECT_TRUE(has(error_in(square + "f 1 2 3\nf 1 4 3\n"), "triangle 2 faces the other way"));
    EXPECT_TRUE(has(error_in(square + third + "f 1 3 2\nf 1 3 4\nf 3 1 5\n"), "triangle 2 faces the other way"));
    EXPECT_TRUE(has(error_in(square + third + "f 1 2 3\nf 1 3 4\nf 3 1 5\n"), "triangle 3 has an edge"));
    EXPECT_EQ(error_in("v 0 0 0\nv 5 0 0\nv 0 5 0\nv 0 0 5\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n"), "");
    EXPECT_EQ(error_in("v 0 0 0\nv 5 0 0\nv 0 5 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"), "");
}

// From a tenth of a millimetre to a metre: beyond that it was written in another unit.
TEST(Meshes, AreATenthToAThousandMillimetresLarge) {
    const auto error = [](const char* size) {
        return error_in(std::string("v 0 0 0\nv ") + size + " 0 0\nv 0 " + size + " 0\nf 1 2 3\n");
    };
    EXPECT_EQ(error("0.101"), "");
    EXPECT_EQ(error("999"), "");
    EXPECT_NE(error("0.099").find("at least 0.1 mm is right"), std::string::npos);
    EXPECT_NE(error("1001").find("at most 1000 mm is right"), std::string::npos);
}
