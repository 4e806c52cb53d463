// Vessels that give way from meshes as people have them, from clean to broken: each is a run, or one line that says
// what is wrong with it.
#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/program.hpp"

namespace {

using program::Folder;
using Point = std::array<double, 3>;

struct Surface {
    std::vector<Point> vertices;  // [mm]
    std::vector<std::array<int, 3>> triangles;

    std::string obj(double unit = 1) const {
        std::ostringstream text;
        for (const auto& [x, y, z] : vertices) text << "v " << unit * x << ' ' << unit * y << ' ' << unit * z << '\n';
        for (const auto& [a, b, c] : triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
        return text.str();
    }
};

// A ring of a tube of 4 mm about a circle of 20, closed in itself or with a piece cut out.
Surface bent_tube(bool closed, int along = 24) {
    constexpr int around = 12;
    constexpr double turn = 2 * std::numbers::pi;
    Surface s;
    for (int i = 0; i < along; ++i)
        for (int k = 0; k < around; ++k) {
            const double at = turn * i / along, roll = turn * k / around, out = 10 + 2 * std::cos(roll);
            s.vertices.push_back({out * std::cos(at), out * std::sin(at), 2 * std::sin(roll)});
        }
    const auto node = [&](int i, int k) { return (i % along) * around + k % around; };
    for (int i = 0; i < (closed ? along : along - 1); ++i)
        for (int k = 0; k < around; ++k) {
            s.triangles.push_back({node(i, k), node(i + 1, k), node(i + 1, k + 1)});
            s.triangles.push_back({node(i, k), node(i + 1, k + 1), node(i, k + 1)});
        }
    return s;
}

// A closed tool that comes down on the ring by a millimetre.
const char* const motion =
    "t_s,instrument,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw\n"
    "0,tool,-10,4,2.3,0.707106781,-0.707106781,0,0,0\n"
    "0.1,tool,-10,4,1.2,0.707106781,-0.707106781,0,0,0\n";

std::string drill(const std::string& sha, const std::string& wall) {
    return R"({"carrel_drill": 1, "title": "A mesh that gives way",
 "thread": {"length_mm": 6, "links": 12, "start_mm": [[0, -20, 30], [6, -20, 30]]},
 "vessels": [{"name": "ring", "mesh": {"file": "vessel.obj", "sha256": ")" +
           sha + "\"" + wall + R"(}}],
 "instruments": [{"name": "tool", "kind": "forceps"}], "effects": {"tissue": "elastic", "bending": false},
 "motion": "motion.csv", "time_limit_s": 5})";
}

// What `carrel validate` and `carrel run` say of it: "runs", or their one line after the file's name.
std::string outcome(const std::string& obj, const std::string& wall = ", \"wall_mm\": 0.5") {
    const Folder folder;
    folder.write("vessel.obj", obj);
    folder.write("motion.csv", motion);
    const std::string wrong(64, '0'), file = folder.write("drill.json", drill(wrong, wall));
    const std::string told = program::run({"validate", file}).said;
    if (told.find("/sha256") != std::string::npos)
        folder.write("drill.json", drill(told.substr(told.size() - 65, 64), wall));
    std::vector<std::string> said;
    for (const std::string command : {"validate", "run"}) {
        const auto ending = program::run({command, file});
        EXPECT_TRUE(ending.in_time && ending.signal == 0) << command;
        said.push_back(ending.exit == 0 ? "runs" : ending.said);
        if (ending.exit != 0)
            program::expect_one_line_naming(
                told.find("/sha256") != std::string::npos ? folder.path("vessel.obj") : file, ending);
    }
    EXPECT_EQ(said[0], said[1]) << "what validate lets pass, runs";
    return said[0].substr(said[0].find("error: ") == std::string::npos ? 0 : said[0].find("error: ") + 7);
}

void expect_said(const std::string& words, const std::string& said) {
    EXPECT_NE(said.find(words), std::string::npos) << words << "\nsaid: " << said;
}

TEST(WallMesh, RunsOrSaysWhatIsWrong) {
    const Surface closed = bent_tube(true), open = bent_tube(false);
    EXPECT_EQ(outcome(closed.obj()), "runs");
    EXPECT_EQ(outcome(open.obj()), "runs");

    Surface holed = closed;  // a branch cut off
    holed.triangles.erase(holed.triangles.begin() + 100, holed.triangles.begin() + 102);
    EXPECT_EQ(outcome(holed.obj()), "runs");

    Surface flipped = closed;
    std::swap(flipped.triangles[100][0], flipped.triangles[100][1]);
    expect_said("faces the other way than its neighbour", outcome(flipped.obj()));

    Surface inwards = closed;
    for (auto& t : inwards.triangles) std::swap(t[0], t[1]);
    EXPECT_EQ(outcome(inwards.obj()), "runs") << "it is turned around";

    Surface finned = closed;  // not a manifold
    finned.vertices.push_back({10, 0, 8});
    finned.triangles.push_back({0, 1, static_cast<int>(finned.vertices.size()) - 1});
    expect_said("an edge of more than two triangles", outcome(finned.obj()));

    Surface flat = open;
    for (const double x : {0.0, 1.0, 2.0}) flat.vertices.push_back({x, 0, 9});
    const int last = static_cast<int>(flat.vertices.size()) - 1;
    flat.triangles.push_back({last - 2, last - 1, last});
    EXPECT_EQ(outcome(flat.obj()), "runs") << "it is left out";

    Surface touching = open;  // in a vertex of its rim and nowhere else
    for (const double z : {0.0, 1.0}) touching.vertices.push_back({14, -3, z});
    touching.triangles.push_back({0, last - 2, last - 1});
    expect_said("alone, part them", outcome(touching.obj()));

    expect_said("is it written in mm?", outcome(closed.obj(1e-3)));
    expect_said("is it written in mm?", outcome(closed.obj(1e3)));
    expect_said("triangles, of a wall that gives way at most", outcome(bent_tube(true, 60).obj()));
    expect_said("the wall is too thick for how its surface curves", outcome(closed.obj(), ", \"wall_mm\": 3"));
    expect_said("the key \"wall_mm\" is missing", outcome(closed.obj(), ""));
}

}  // namespace
