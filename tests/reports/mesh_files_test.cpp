#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>

#include "assets/mesh.hpp"
#include "tests/program.hpp"
#include "tests/reports/made_mesh.hpp"

// Meshes from scanners and from programs that write a format in their own way. What is right is a tube's own volume,
// n / 2 sin(2 pi / n) (R^2 - r^2) L, and that it has as many triangles as it was made of.
namespace mesh_files {

using assets::Mesh;
using assets::Vec3;

struct Tube {
    double outer, wall, length;  // [m]
    int around, along;

    Mesh mesh() const { return assets::make_tube(outer, wall, length, around, along); }
    double volume() const {
        const double R = outer / 2, r = R - wall;
        return around / 2.0 * std::sin(2 * EIGEN_PI / around) * (R * R - r * r) * length;
    }
};

const Tube tubes[] = {{4e-3, 0.6e-3, 30e-3, 16, 6}, {1e-3, 0.1e-3, 3e-3, 12, 3}, {60e-3, 5e-3, 400e-3, 24, 9}};
const Vec3 places[] = {Vec3(0, 0, 0), Vec3(0.22, 0.14, 0.024), Vec3(-0.9, 0.03, 0.5)};

class MeshFiles : public ::testing::Test {
  protected:
    Mesh load(const std::string& name, const std::string& bytes) const {
        return assets::load_mesh(folder_.write(name, bytes));
    }

    void expect_tube(const Tube& tube, const std::string& name, const std::string& bytes) const {
        SCOPED_TRACE(name + ", " + std::to_string(bytes.size()) + " bytes");
        try {
            const Mesh read = load(name, bytes);
            EXPECT_EQ(read.triangles.size(), tube.mesh().triangles.size());
            EXPECT_NEAR(assets::volume(read), tube.volume(), 1e-3 * tube.volume());
            EXPECT_EQ(read.mended, std::vector<std::string>());
        } catch (const assets::AssetError& error) {
            ADD_FAILURE() << error.what();
        }
    }

    std::string refusal(const std::string& name, const std::string& bytes) const try {
        load(name, bytes);
        return "read";
    } catch (const assets::AssetError& error) {
        return error.what();
    }

    program::Folder folder_;
};

std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

std::string with_dos_ends(const std::string& text) {
    std::string dos;
    for (const char c : text) dos += c == '\n' ? "\r\n" : std::string(1, c);
    return dos;
}

// Whether every edge has one triangle on either side: nothing is open.
bool is_closed(const Mesh& mesh) {
    std::map<std::array<int, 2>, int> edges;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    for (const auto& [edge, count] : edges)
        if (count != 1 || edges.count({edge[1], edge[0]}) == 0) return false;
    return true;
}

TEST_F(MeshFiles, AnStlIsReadInEveryWayThatProgramsWriteIt) {
    for (const Tube& tube : tubes) {
        const Mesh mesh = tube.mesh();
        const std::string text = made::text_stl(mesh), binary = made::binary_stl(mesh);
        for (const char* before : {"", "\n", "  \n\t\n", "\xef\xbb\xbf"}) {
            expect_tube(tube, "t.stl", before + text);
            expect_tube(tube, "T.STL", before + upper(text));
            expect_tube(tube, "t.Stl", before + with_dos_ends(text));
        }
        for (const std::string& after : {std::string("\n\n"), std::string(3, '\0'), std::string("\x1a")})
            expect_tube(tube, "t.stl", text + after);
        for (const std::size_t more : {0u, 1u, 7u, 50u, 600u})
            for (const char* header : {"binary", "solid tube", "SOLID TUBE"})
                expect_tube(tube, "t.stl", made::binary_stl(mesh, header) + std::string(more, '\x5a'));
    }
}

TEST_F(MeshFiles, APlyIsReadWithCommentsAnywhereInItsHeader) {
    for (const Tube& tube : tubes)
        for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
            for (const char* between : {"", "comment Points\n", "obj_info scanned\ncomment end_header is below\n"})
                for (const char* name : {"t.ply", "T.PLY"})
                    expect_tube(tube, name, made::ply(tube.mesh(), format, between));
}

// Whoever copied half a file must not look for a fault in its form.
TEST_F(MeshFiles, AFileThatIsCutOffIsCalledThat) {
    const Mesh mesh = tubes[0].mesh();
    const std::string text = made::text_stl(mesh), two = text + text;
    const std::pair<std::string, std::string> whole[] = {{"t.stl", text},
                                                         {"t.stl", upper(text)},
                                                         {"t.stl", made::binary_stl(mesh)},
                                                         {"t.stl", made::binary_stl(mesh, "solid tube")},
                                                         {"t.ply", made::ply(mesh)},
                                                         {"t.ply", made::ply(mesh, "binary_little_endian")},
                                                         {"t.ply", made::ply(mesh, "binary_big_endian")}};
    for (const auto& [name, bytes] : whole)
        for (const std::size_t left : {bytes.size() / 100, bytes.size() / 10, bytes.size() / 2, bytes.size() - 20})
            EXPECT_NE(refusal(name, bytes.substr(0, left)).find("is cut off"), std::string::npos)
                << name << " " << left << ": " << refusal(name, bytes.substr(0, left));
    EXPECT_NE(refusal("t.stl", two.substr(0, two.size() - 200)).find("is cut off: no 'endsolid' ends the last"),
              std::string::npos);
    EXPECT_EQ(refusal("t.stl", made::binary_stl(mesh).substr(0, 84 + 50 * 100 + 7)),
              folder_.path("t.stl") + ": error: is cut off or no .stl file: says " +
                  std::to_string(mesh.triangles.size()) + " triangles and has bytes for 100");
    EXPECT_EQ(refusal("t.ply", made::ply(mesh).substr(0, made::ply(mesh).size() - 30)),
              folder_.path("t.ply") + ": error: is cut off: says 'element face " +
                  std::to_string(mesh.triangles.size()) + "' and holds " + std::to_string(mesh.triangles.size() - 3) +
                  " of them");
}

TEST_F(MeshFiles, OneThatFacesInwardsIsTurnedAroundAndTold) {
    for (const Tube& tube : tubes)
        for (const Vec3& place : places) {
            SCOPED_TRACE(place.transpose());
            const Mesh inwards = made::moved(made::turned_around(tube.mesh()), place);
            const Mesh read = load("t.stl", made::binary_stl(inwards));
            EXPECT_NEAR(assets::volume(read), tube.volume(), 2e-3 * tube.volume());
            EXPECT_EQ(read.mended,
                      std::vector<std::string>{"faced inwards everywhere: its triangles were turned around"});
            EXPECT_EQ(load("t.stl", made::binary_stl(made::moved(tube.mesh(), place))).mended,
                      std::vector<std::string>());
        }
}

// The outside of a vessel alone, open at both ends: away from its axis is out.
TEST_F(MeshFiles, AnOpenOneIsTurnedAroundToo) {
    Mesh outside = tubes[0].mesh();
    outside.triangles.resize(outside.triangles.size());
    std::erase_if(outside.triangles, [&](const auto& t) {
        for (const int corner : t) {
            const Vec3& p = outside.vertices[static_cast<std::size_t>(corner)];
            if (std::hypot(p.y(), p.z()) < tubes[0].outer / 2 - 1e-6) return true;
        }
        return false;
    });
    for (const Vec3& place : places) {
        const Mesh read = load("t.stl", made::binary_stl(made::moved(made::turned_around(outside), place)));
        EXPECT_EQ(read.mended.size(), 1u);
        for (const auto& t : read.soup()) {
            const Vec3 out = (t.a + t.b + t.c) / 3 - place;
            EXPECT_GT((t.b - t.a).cross(t.c - t.a).dot(Vec3(0, out.y(), out.z())), 0);
        }
    }
}

// A corner that lies on its neighbour's edge leaves a triangle without area between them; two corners a rounding apart
// leave two. Either way the surface stays whole, wherever it lies.
TEST_F(MeshFiles, SliversGoAndLeaveNoHole) {
    for (const Tube& tube : tubes)
        for (const Vec3& place : places)
            for (unsigned seed = 0; seed < 8; ++seed) {
                SCOPED_TRACE(testing::Message() << tube.outer << " at " << place.transpose() << ", seed " << seed);
                Mesh mesh = made::moved(tube.mesh(), place);
                std::mt19937 random(seed);
                for (int times = 0; times < 3; ++times) {
                    const std::size_t which = random() % mesh.triangles.size();
                    const auto [a, b, c] = mesh.triangles[which];
                    const double along = 0.1 + 0.8 * static_cast<double>(random() % 1000) / 1000;
                    const int middle = static_cast<int>(mesh.vertices.size());
                    const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(i)]; };
                    mesh.vertices.push_back(at(a) + along * (at(b) - at(a)));
                    mesh.triangles[which] = {a, middle, c};
                    mesh.triangles.push_back({middle, b, c}), mesh.triangles.push_back({a, b, middle});
                }
                const Mesh read = load("t.stl", made::binary_stl(mesh));
                EXPECT_TRUE(is_closed(read));
                EXPECT_NEAR(assets::volume(read), tube.volume(), 2e-3 * tube.volume());
                const Mesh turned = load("t.stl", made::binary_stl(made::turned_around(mesh)));
                EXPECT_EQ(turned.triangles.size(), read.triangles.size());
                EXPECT_NEAR(assets::volume(turned), tube.volume(), 2e-3 * tube.volume());
                EXPECT_TRUE(is_closed(turned));
            }
}

// A corner a rounding from another, with a triangle between the two that is hardly longer.
TEST_F(MeshFiles, ACornerThatIsThereTwiceIsOne) {
    for (const Tube& tube : tubes) {
        Mesh mesh = tube.mesh();
        const std::size_t whole = mesh.triangles.size(), which = whole / 2;
        const auto [a, b, c] = mesh.triangles[which];
        const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(i)]; };
        const int twin = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back(at(a) + 1e-6 * tube.length * (at(b) - at(a)).normalized());
        mesh.triangles[which] = {a, twin, c};
        mesh.triangles.push_back({twin, b, c}), mesh.triangles.push_back({a, b, twin});
        const Mesh read = load("t.stl", made::binary_stl(mesh));
        EXPECT_EQ(read.triangles.size(), whole);
        EXPECT_TRUE(is_closed(read));
        EXPECT_EQ(read.mended, std::vector<std::string>{"lost 2 slivers, triangles that have no area"});
    }
}

// A sliver on a sheet's rim has nothing beyond its edge; what has no area at all is no mesh.
TEST_F(MeshFiles, ASliverOnARimGoesAlone) {
    const std::string sheet = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 5 0 0\nf 1 3 4\nf 1 5 3\nf 5 2 3\n";
    EXPECT_EQ(load("t.obj", sheet).mended, std::vector<std::string>());
    const Mesh read = load("t.obj", sheet + "f 1 2 5\n");
    EXPECT_EQ(read.triangles.size(), 3u);
    EXPECT_EQ(read.mended, std::vector<std::string>{"lost 1 sliver, triangles that have no area"});
    EXPECT_NE(refusal("t.obj", "v 0 0 0\nv 5 5 5\nv 1 1 1\nf 1 2 3\n").find("has no triangle with an area"),
              std::string::npos);
}

// As they were found. What is right: the tube is 26 mm long or 52 as it was scanned, and is a vessel to sew on.
TEST_F(MeshFiles, TheFilesThatWereReportedAreRead) {
    const std::string reports = CARREL_SOURCE "/tests/reports/";
    for (const char* name : {"mesh-text/same-comment-after-element.ply", "mesh-text/same-comment-before-face-list.ply",
                             "mesh-text/same-trailing-bytes.stl"})
        EXPECT_EQ(assets::load_mesh(reports + name).triangles.size(), 448u) << name;
    for (const char* name : {"inwards", "sliver", "sliver-at-origin"}) {
        SCOPED_TRACE(name);
        const std::string drill = reports + "scan-faces-inwards/" + name + ".json";
        const std::string what = std::string(name) == "inwards"
                                     ? "faced inwards everywhere: its triangles were turned around"
                                     : "lost 1 sliver, triangles that have no area";
        const std::string warning = drill + ": warning: /vessels/0/mesh: " + name + ".stl " + what + "\n";
        const auto validated = program::run({"validate", drill}), played = program::run({"run", drill});
        EXPECT_EQ(validated.exit, 0);
        EXPECT_NE(validated.said.find(warning), std::string::npos) << validated.said;
        EXPECT_EQ(played.exit, 0);
        EXPECT_EQ(played.said, warning);
    }
}

}  // namespace mesh_files
