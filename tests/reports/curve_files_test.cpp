#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "assets/curve.hpp"
#include "tests/program.hpp"

// Curves as modelling programs write them: edges in the order in which they were drawn, endings in capitals.
namespace curve_files {

using assets::Vec3;

using Edge = std::array<int, 2>;  // of vertices, from 1

// Vertices of strands of these lengths, each place once, and the edges along them; a closed one ends where it begins.
struct Drawing {
    std::string vertices;
    std::vector<Edge> edges;
    int closed = 0;

    void add(int count, bool is_closed) {
        const int first = 1 + static_cast<int>(std::count(vertices.begin(), vertices.end(), '\n'));
        for (int i = 0; i < count; ++i) {
            const double turn = 2 * EIGEN_PI * i / count;
            vertices += "v " + std::to_string(first + 10 * std::cos(turn)) + " " + std::to_string(10 * std::sin(turn)) +
                        " " + std::to_string(first) + "\n";
            if (i > 0) edges.push_back({first + i - 1, first + i});
        }
        if (is_closed) edges.push_back({first + count - 1, first}), ++closed;
    }
};

std::string written(const Drawing& drawing, const std::string& how) {
    std::string text = drawing.vertices;
    for (const auto& [a, b] : drawing.edges)
        text += how == "from the last"
                    ? "l " +
                          std::to_string(
                              a - 1 -
                              static_cast<int>(std::count(drawing.vertices.begin(), drawing.vertices.end(), '\n'))) +
                          " " +
                          std::to_string(
                              b - 1 -
                              static_cast<int>(std::count(drawing.vertices.begin(), drawing.vertices.end(), '\n'))) +
                          "\n"
                : how == "with texture" ? "l " + std::to_string(a) + "/1 " + std::to_string(b) + "/2\n"
                                        : "l " + std::to_string(a) + " " + std::to_string(b) + "\n";
    return text;
}

// Edges in any order and direction make the strands that they make in order.
TEST(CurveFiles, EdgesThatShareAVertexAreJoined) {
    const program::Folder folder;
    Drawing drawing;
    drawing.add(60, true), drawing.add(7, false), drawing.add(3, true), drawing.add(2, false);
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const char* how : {"as numbers", "from the last", "with texture"}) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << how);
            Drawing shuffled = drawing;
            std::mt19937 random(seed);
            if (seed > 0) std::shuffle(shuffled.edges.begin(), shuffled.edges.end(), random);
            for (Edge& edge : shuffled.edges)
                if (seed > 1 && random() % 2) std::swap(edge[0], edge[1]);
            const auto curve = assets::load_curve(folder.write("c.obj", written(shuffled, how)));
            ASSERT_EQ(curve.components.size(), 4u);
            std::set<Edge> passed;
            int closed = 0;
            for (const auto& strand : curve.components) {
                closed += strand.closed;
                for (std::size_t i = 0; i + !strand.closed < strand.lines.size(); ++i) {
                    const int a = strand.lines[i], b = strand.lines[(i + 1) % strand.lines.size()];
                    EXPECT_TRUE(passed.insert({std::min(a, b), std::max(a, b)}).second);
                }
            }
            EXPECT_EQ(closed, drawing.closed);
            std::set<Edge> drawn;
            for (const auto& [a, b] : drawing.edges) drawn.insert({std::min(a, b), std::max(a, b)});
            EXPECT_EQ(passed, drawn);
        }
}

// Some programs write two vertices for every edge.
TEST(CurveFiles, EdgesThatEndInOnePlaceAreJoined) {
    const program::Folder folder;
    std::string text;
    for (const int i : {2, 0, 3, 1})
        text += "v " + std::to_string(i) + " 0 0\nv " + std::to_string(i + 1) + " 0 0\nl -2 -1\n";
    const auto curve = assets::load_curve(folder.write("c.obj", text));
    ASSERT_EQ(curve.components.size(), 1u);
    ASSERT_EQ(curve.components[0].vertices.size(), 5u);
    EXPECT_FALSE(curve.components[0].closed);
    EXPECT_NEAR((curve.components[0].vertices[0] - curve.components[0].vertices[4]).norm(), 4e-3, 1e-15);
}

TEST(CurveFiles, WhatIsNoStrandIsNamedByItsLine) {
    const program::Folder folder;
    const auto refusal = [&](const std::string& text) -> std::string {
        const std::string file = folder.write("c.obj", text);
        try {
            assets::load_curve(file);
            return "read";
        } catch (const assets::AssetError& error) {
            return std::string(error.what()).substr(file.size());
        }
    };
    const std::string star = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    EXPECT_EQ(refusal(star + "l 1 2\nl 3 1\nl 1 4\n"),
              ":7: error: a third edge meets the vertex of line 1; expected at most two, as along a strand");
    EXPECT_EQ(refusal(star + "l 1 5\n"), ":5: error: expected the number of a vertex above, 1 to 4, found '5'");
    EXPECT_EQ(refusal(star + "l 1 2\nf 1 2 3\n"), ":6: error: holds faces, not lines; expected a curve");
    EXPECT_EQ(refusal(star), ": error: holds no lines 'l'; expected those of a curve");
    EXPECT_EQ(refusal("v 0 0 nan\n"), ":1:7: error: expected a finite coordinate within 1e9 mm, found 'nan'");
    EXPECT_EQ(refusal("v 0 0\n"), ":1: error: expected 'v x y z' in mm, found 'v?0?0'");
}

// All of a trefoil, however it is written.
TEST(CurveFiles, TheFilesThatWereReportedAreNamed) {
    const std::string folder = CARREL_SOURCE "/tests/reports/";
    for (const char* name : {"edges-in-order.obj", "edges-last-first.obj", "edges-one-reversed.obj",
                             "edges-two-swapped.obj", "LINE.OBJ", "UPPER.PLY"}) {
        const std::string file = folder + "curve-obj/" + name;
        const auto ending = program::run({"knot", file});
        EXPECT_EQ(ending.exit, 0) << ending.said;
        EXPECT_NE(ending.out.find(": 3_1"), std::string::npos) << ending.out;
    }
    const auto commented = program::run({"knot", folder + "mesh-text/curve-comment-after-element.ply"});
    EXPECT_EQ(commented.exit, 0) << commented.said;
}

// Two empty lines too many are the commonest slip of a script that prints vertices.
TEST(CurveFiles, EmptyLinesBetweenVerticesAreNamed) {
    const program::Folder folder;
    const std::string file = folder.write("c.xyz", "0 0 0\n\n1 0 0\n\n1 1 0\n");
    program::expect_one_line_naming(
        file + ":1: error: one vertex between empty lines, which end a curve; expected at least two, or no empty line",
        program::run({"knot", file}));
}

}  // namespace curve_files
