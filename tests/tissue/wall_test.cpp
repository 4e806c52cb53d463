#include "tissue/wall.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>

#include "assets/mesh.hpp"
#include "tissue/tissue.hpp"

namespace walls {

using namespace tissue;

constexpr double pi = std::numbers::pi;

struct Surface {
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 3>> triangles;
};

// Rings of a torus or, where it does not close, of a bent tube: radius 2 mm about a circle of 10 mm, `turns` of it.
// Counter-clockwise from outside.
Surface bent_tube(bool closed, double turns = 1) {
    constexpr int along = 24, around = 12;
    Surface s;
    for (int i = 0; i < along; ++i)
        for (int k = 0; k < around; ++k) {
            const double turn = turns * 2 * pi * i / along, roll = 2 * pi * k / around,
                         out = 10e-3 + 2e-3 * std::cos(roll);
            s.vertices.push_back({out * std::cos(turn), out * std::sin(turn), 2e-3 * std::sin(roll)});
        }
    for (int i = 0; i < (closed ? along : along - 1); ++i)
        for (int k = 0; k < around; ++k) {
            const auto at = [&](int a, int b) { return (a % along) * around + b % around; };
            s.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            s.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    return s;
}

double volume_of(const Mesh& mesh) {
    double sum = 0;
    for (const Tetrahedron& tet : mesh.tetrahedra) sum += volume(tet, mesh.nodes);
    return sum;
}

// As the faces close round it: to rounding the sum of the tetrahedra, which a gap or a wrong diagonal would not be.
double volume_inside_faces(const Mesh& mesh) {
    double sum = 0;
    for (const Face& face : mesh.faces) {
        const auto at = [&](std::size_t k) -> const Vec3& {
            return mesh.nodes[static_cast<std::size_t>(face.nodes[k])];
        };
        sum += at(0).dot(at(1).cross(at(2))) / 6;
    }
    return sum;
}

bool is_watertight(const Mesh& mesh) {
    std::map<std::pair<int, int>, int> ways;
    for (const Face& face : mesh.faces)
        for (std::size_t k = 0; k < 3; ++k) ++ways[{face.nodes[k], face.nodes[(k + 1) % 3]}];
    for (const auto& [way, uses] : ways)
        if (uses != 1 || !ways.contains({way.second, way.first})) return false;
    return true;
}

TEST(Wall, OfATubeHasItsThickness) {
    for (const bool closed : {true, false}) {
        SCOPED_TRACE(closed);
        const Surface s = bent_tube(closed);
        const Wall wall = make_wall(s.vertices, s.triangles, {});
        ASSERT_FALSE(wall.problem) << *wall.problem;
        for (const Tetrahedron& tet : wall.mesh.tetrahedra) ASSERT_GT(volume(tet, wall.mesh.nodes), 0);
        EXPECT_TRUE(is_watertight(wall.mesh));
        EXPECT_NEAR(volume_of(wall.mesh), volume_inside_faces(wall.mesh), 1e-9 * volume_of(wall.mesh));
        const double expected = pi * (2 * 2 - 1.5 * 1.5) * 2 * pi * 10 * 1e-9 * (closed ? 1 : 23.0 / 24);
        EXPECT_NEAR(volume_of(wall.mesh), expected,
                    0.1 * expected);  // twelve sides lack a twentieth of a circle's area
    }
}

TEST(Wall, GivesWayAndComesBack) {
    const Surface s = bent_tube(false);
    const Wall wall = make_wall(s.vertices, s.triangles, {});
    Tissue tissue({}, wall.mesh);
    std::vector<Hold> holds;
    for (int i = 0; i < 20 * 12 * 3; ++i) holds.push_back({i, wall.mesh.nodes[static_cast<std::size_t>(i)]});
    const auto last = static_cast<int>(wall.mesh.tetrahedra.size()) - 1;
    const auto farthest = [&] {
        double most = 0;
        for (std::size_t i = 0; i < tissue.nodes().size(); ++i)
            most = std::max(most, (tissue.nodes()[i] - wall.mesh.nodes[i]).norm());
        return most;
    };
    const PointForce forces[] = {{{last, {0.25, 0.25, 0.25, 0.25}}, {0, 0, 1e-2}}};
    for (int i = 0; i < 200; ++i) tissue.step({.holds = holds, .forces = forces}, 2e-3);
    EXPECT_GT(farthest(), 1e-4);
    for (int i = 0; i < 1000; ++i) tissue.step({.holds = holds}, 2e-3);
    EXPECT_LT(farthest(), 5e-6);  // a hundredth of its thickness
}

// From clean to broken, in millimetres as files are: each makes a wall that steps, or one line that says why not.
class Files : public testing::Test {
  protected:
    std::string outcome(const Surface& s, double unit = 1e3, const WallDef& def = {}) const {
        const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "wall.obj";
        std::ofstream out(file);
        for (const Vec3& v : s.vertices)
            out << "v " << unit * v.x() << ' ' << unit * v.y() << ' ' << unit * v.z() << '\n';
        for (const auto& [a, b, c] : s.triangles) out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
        out.close();
        try {
            const assets::Mesh mesh = assets::load_mesh(file);
            const Wall wall = make_wall(mesh.vertices, mesh.triangles, def);
            if (wall.problem) return *wall.problem;
            Tissue tissue({}, wall.mesh);
            for (int i = 0; i < 5; ++i) tissue.step({.pressure = 100}, 1e-3);
            for (const Vec3& p : tissue.nodes())
                if (!p.allFinite()) return "lost";
            return "runs";
        } catch (const assets::AssetError& error) {
            const std::string line = error.what();
            EXPECT_EQ(line.find('\n'), std::string::npos);
            return line.substr(line.find("error: ") + 7);
        }
    }
};

TEST_F(Files, RunOrSayWhatIsWrong) {
    const Surface clean = bent_tube(true), open = bent_tube(false);
    EXPECT_EQ(outcome(clean), "runs");
    EXPECT_EQ(outcome(open), "runs");

    Surface holed = clean;
    holed.triangles.erase(holed.triangles.begin() + 100, holed.triangles.begin() + 102);
    EXPECT_EQ(outcome(holed), "runs");  // a branch cut off

    Surface flipped = clean;
    std::swap(flipped.triangles[100][0], flipped.triangles[100][1]);
    EXPECT_TRUE(outcome(flipped).ends_with("faces the other way than its neighbour, turn one around"))
        << outcome(flipped);

    Surface inwards = clean;
    for (auto& t : inwards.triangles) std::swap(t[0], t[1]);
    EXPECT_EQ(outcome(inwards), "runs") << "the loader turns it around";

    Surface open_inwards = open;
    for (auto& t : open_inwards.triangles) std::swap(t[0], t[1]);
    EXPECT_EQ(outcome(open_inwards), "runs") << "the loader turns it around";

    Surface flat = clean;
    flat.vertices[14] = flat.vertices[13];
    EXPECT_EQ(outcome(flat), "runs") << "the loader joins two vertices at one place";

    EXPECT_TRUE(outcome(clean, 1).find("is it written in mm?") != std::string::npos ||
                outcome(clean, 1e-3).find("is it written in mm?") != std::string::npos);
    EXPECT_TRUE(outcome(clean, 1e6).find("is it written in mm?") != std::string::npos);

    EXPECT_TRUE(outcome(clean, 1e3, {.thickness = 3e-3})
                    .starts_with("the wall is too thick for how its surface curves at triangle"));
}

TEST_F(Files, MustBeOneSurfaceThatMeetsItselfInEdges) {
    const Surface clean = bent_tube(true), open = bent_tube(false);
    const auto twice_with = [&](const Vec3& way) {
        Surface both = open;
        for (const Vec3& v : open.vertices) both.vertices.push_back(v + way);
        for (auto t : open.triangles) {
            for (int& corner : t) corner += static_cast<int>(open.vertices.size());
            both.triangles.push_back(t);
        }
        return both;
    };
    EXPECT_EQ(outcome(twice_with({0, 0, 6e-3})), "triangle 553 is not joined to the first one, a wall is one piece");

    const Surface spiral = bent_tube(false, 1.1);  // its end goes into its beginning
    EXPECT_TRUE(outcome(spiral).starts_with("the wall goes through itself at triangle")) << outcome(spiral);

    Surface finned = clean;
    finned.vertices.push_back({10e-3, 0, 8e-3});
    finned.triangles.push_back({0, 1, static_cast<int>(finned.vertices.size()) - 1});
    EXPECT_TRUE(outcome(finned).find("has an edge of more than two triangles") != std::string::npos) << outcome(finned);

    Surface twice = open;
    twice.triangles.push_back(twice.triangles[7]);
    EXPECT_TRUE(outcome(twice).ends_with("is there twice, remove one")) << outcome(twice);

    Surface touching = open;  // two triangles more that share a vertex of the rim with it, and nothing else
    const int first = static_cast<int>(touching.vertices.size());
    for (const double x : {0.0, 1e-3, 2e-3}) touching.vertices.push_back({10e-3, -5e-3, x});
    touching.triangles.push_back({0, first, first + 1});
    touching.triangles.push_back({0, first + 1, first + 2});
    EXPECT_EQ(outcome(touching), "parts of the surface meet in vertex 1 alone, part them");
}

// What a loader would have found already is found again: this room takes any numbers.
TEST(Wall, SaysWhatIsWrongWithNumbers) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}, {1e-3, 1e-3, 0}};
    const auto problem = [&](std::vector<std::array<int, 3>> triangles, std::size_t used, const WallDef& def = {}) {
        return make_wall(std::span(vertices).first(used), triangles, def).problem.value_or("none");
    };
    EXPECT_EQ(problem({{0, 1, 2}, {1, 3, 2}}, 4), "none");
    EXPECT_EQ(problem({}, 4), "the surface has no triangles");
    EXPECT_EQ(problem({{0, 1, 7}}, 4), "triangle 1 has a corner that does not exist");
    EXPECT_EQ(problem({{0, 1, 1}}, 2), "triangle 1 has no area, remove it");
    EXPECT_EQ(problem({{0, 1, 2}}, 4), "vertex 4 belongs to no triangle, remove it");
    EXPECT_EQ(problem({{0, 1, 2}, {3, 1, 2}}, 4), "triangle 2 faces the other way than its neighbour, turn one around");
    EXPECT_EQ(problem({{0, 1, 2}}, 3, {.thickness = 0}),
              "a wall must be thicker than 0 and have at least one cell through it");
}

}  // namespace walls
