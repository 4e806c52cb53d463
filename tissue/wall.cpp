#include "tissue/wall.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/triangle_tree.hpp"

namespace tissue {

namespace {

using Triangle = std::array<int, 3>;
using Problem = std::optional<std::string>;

struct Surface {
    std::span<const Vec3> vertices;
    std::span<const Triangle> triangles;

    const Vec3& at(int i) const { return vertices[static_cast<std::size_t>(i)]; }
    Vec3 area(const Triangle& t) const { return 0.5 * (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])); }
};

std::string name(std::size_t triangle) {
    return "triangle " + std::to_string(triangle + 1);
}

Problem problem_with_triangles(const Surface& surface) {
    if (surface.triangles.empty()) return "the surface has no triangles";
    std::vector<bool> used(surface.vertices.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const Triangle& triangle = surface.triangles[t];
        double edge = 0;
        for (const int i : triangle) {
            if (i < 0 || i >= static_cast<int>(surface.vertices.size()))
                return name(t) + " has a corner that does not exist";
            if (!surface.at(i).allFinite()) return name(t) + " has a corner that is not a finite number";
            used[static_cast<std::size_t>(i)] = true;
        }
        for (std::size_t k = 0; k < 3; ++k)
            edge = std::max(edge, (surface.at(triangle[k]) - surface.at(triangle[(k + 1) % 3])).norm());
        constexpr double thinnest = 1e-6;  // height over length: that of what was meant as a line and written as float
        if (!(2 * surface.area(triangle).norm() > thinnest * edge * edge)) return name(t) + " has no area, remove it";
    }
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end())
        return "vertex " + std::to_string(unused - used.begin() + 1) + " belongs to no triangle, remove it";
    return {};
}

Problem problem_with_edges(const Surface& surface) {
    std::set<std::array<int, 2>> edges;
    std::map<std::array<int, 2>, int> uses;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = surface.triangles[t][k], to = surface.triangles[t][(k + 1) % 3];
            if (++uses[{std::min(from, to), std::max(from, to)}] > 2)
                return name(t) + " has an edge of more than two triangles, a surface has at most two";
            if (!edges.insert({from, to}).second)
                return name(t) + " faces the other way than its neighbour, turn one around";
        }
    return {};
}

// The triangles about a vertex must be one fan: closed, or open between two rims.
Problem problem_with_fans(const Surface& surface) {
    std::vector<std::map<int, int>> next(
        surface.vertices.size());  // of a vertex: from which neighbour to which a triangle leads about it
    for (const Triangle& t : surface.triangles)
        for (std::size_t k = 0; k < 3; ++k) next[static_cast<std::size_t>(t[k])][t[(k + 1) % 3]] = t[(k + 2) % 3];
    for (std::size_t v = 0; v < next.size(); ++v) {
        std::set<int> reached;
        for (const auto& [from, to] : next[v]) reached.insert(to);
        int first = next[v].begin()->first;
        for (const auto& [from, to] : next[v])
            if (!reached.contains(from)) first = from;  // at a rim
        std::size_t steps = 0;
        for (auto at = next[v].find(first); at != next[v].end() && steps < next[v].size();
             at = next[v].find(at->second)) {
            ++steps;
            if (at->second == first) break;
        }
        if (steps < next[v].size())
            return "parts of the surface meet in vertex " + std::to_string(v + 1) + " alone, part them";
    }
    return {};
}

// A vessel must be one piece: of two, start, end and cut say nothing.
Problem problem_with_pieces(const Surface& surface) {
    std::vector<int> piece(surface.vertices.size());
    std::iota(piece.begin(), piece.end(), 0);
    const auto up = [&](int v) -> int& { return piece[static_cast<std::size_t>(v)]; };
    const auto first_of = [&](int v) {
        while (up(v) != v) v = up(v) = up(up(v));
        return v;
    };
    for (const Triangle& t : surface.triangles)
        for (std::size_t k = 1; k < 3; ++k) {
            const auto [low, high] = std::minmax({first_of(t[0]), first_of(t[k])});
            up(high) = low;
        }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        if (first_of(surface.triangles[t][0]) != first_of(surface.triangles[0][0]))
            return name(t) + " is not joined to the first one, a wall is one piece";
    return {};
}

// For each vertex the mean of its triangles' normals by their angles there, as long as it takes to be 1 above them in
// the mean.
std::vector<Vec3> normals_of(const Surface& surface) {
    std::vector<Vec3> normals(surface.vertices.size(), Vec3::Zero());
    std::vector<double> above(normals.size()), angles(normals.size());
    const auto for_corners = [&](const auto& visit) {
        for (const Triangle& t : surface.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 a = (surface.at(t[(k + 1) % 3]) - surface.at(t[k])).normalized(),
                           b = (surface.at(t[(k + 2) % 3]) - surface.at(t[k])).normalized();
                visit(static_cast<std::size_t>(t[k]), surface.area(t).normalized(),
                      a.cross(b).norm());  // the sine serves as well as the angle
            }
    };
    for_corners([&](std::size_t v, const Vec3& normal, double angle) { normals[v] += angle * normal; });
    for (Vec3& normal : normals) normal = normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3::Zero();
    for_corners([&](std::size_t v, const Vec3& normal, double angle) {
        above[v] += angle * normal.dot(normals[v]), angles[v] += angle;
    });
    for (std::size_t v = 0; v < normals.size(); ++v) normals[v] *= above[v] > 0 ? angles[v] / above[v] : 0;
    return normals;
}

// Adds the tetrahedra of a prism, over corners in the order of their numbers: diagonals lead down from the lower one,
// so that neighbours agree.
void add_prism(Mesh& mesh, Triangle corners, int layers, int below) {
    const bool even = (corners[0] < corners[1]) + (corners[1] < corners[2]) + (corners[2] < corners[0]) == 2;
    std::sort(corners.begin(), corners.end());
    const auto node = [&](std::size_t corner, int up) { return corners[corner] * layers + below + up; };
    for (const Tetrahedron& tet : {Tetrahedron{node(0, 0), node(1, 0), node(2, 0), node(2, 1)},
                                   Tetrahedron{node(0, 0), node(1, 0), node(2, 1), node(1, 1)},
                                   Tetrahedron{node(0, 0), node(1, 1), node(2, 1), node(0, 1)}}) {
        mesh.tetrahedra.push_back(tet);
        if (!even) std::swap(mesh.tetrahedra.back()[1], mesh.tetrahedra.back()[2]);
    }
    mesh.cells.push_back(static_cast<int>(mesh.tetrahedra.size()));
}

// Adds the faces outside, inside and on what rises from rims, with the same diagonals.
void add_faces(Mesh& mesh, const Surface& surface, int through) {
    const int layers = through + 1;
    std::set<std::array<int, 2>> edges;
    for (const Triangle& t : surface.triangles) {
        mesh.faces.push_back(
            {{t[0] * layers + through, t[1] * layers + through, t[2] * layers + through}, Side::outer});
        mesh.faces.push_back({{t[0] * layers, t[2] * layers, t[1] * layers}, Side::inner});
        for (std::size_t k = 0; k < 3; ++k) edges.insert({t[k], t[(k + 1) % 3]});
    }
    for (const auto& [from, to] : edges) {
        if (edges.contains({to, from})) continue;
        for (int t = 0; t < through; ++t) {
            const int a = from * layers + t, b = to * layers + t;
            mesh.faces.push_back({{a, b, from < to ? b + 1 : a + 1}, Side::cut});
            mesh.faces.push_back({{from < to ? a : b, b + 1, a + 1}, Side::cut});
        }
    }
}

// The first face, by the triangle it comes from, that another goes through which shares no corner with it.
Problem problem_with_faces(const Mesh& mesh, const Surface& surface, double thickness) {
    const auto at = [&](int i) -> const Vec3& { return mesh.nodes[static_cast<std::size_t>(i)]; };
    std::vector<sim::geometry::Triangle> faces;
    for (const Face& face : mesh.faces) faces.push_back({at(face.nodes[0]), at(face.nodes[1]), at(face.nodes[2])});
    const sim::geometry::TriangleTree tree(faces);
    constexpr double rounding = 1e-9;  // of what goes through a face, and has no distance from it
    std::vector<int> near;
    for (std::size_t f = 0; f < 2 * surface.triangles.size(); ++f) {
        const auto& mine = mesh.faces[f].nodes;
        near.clear();
        tree.near(tree.box(static_cast<int>(f)), near);
        for (const int other : near) {
            const auto& its = mesh.faces[static_cast<std::size_t>(other)].nodes;
            if (std::find_first_of(mine.begin(), mine.end(), its.begin(), its.end()) != mine.end()) continue;
            for (std::size_t k = 0; k < 3; ++k)
                if (closest_points(at(its[k]), at(its[(k + 1) % 3]), faces[f]).distance_squared <
                    rounding * rounding * thickness * thickness)
                    return "the wall goes through itself at " + name(f / 2);
        }
    }
    return {};
}

}  // namespace

Wall make_wall(std::span<const Vec3> vertices, std::span<const Triangle> triangles, const WallDef& def) {
    const Surface surface{vertices, triangles};
    Wall wall;
    if (!(def.thickness > 0) || def.through < 1)
        wall.problem = "a wall must be thicker than 0 and have at least one cell through it";
    for (const auto check : {problem_with_triangles, problem_with_edges, problem_with_fans, problem_with_pieces})
        if (!wall.problem) wall.problem = check(surface);
    if (wall.problem) return wall;
    Mesh& mesh = wall.mesh;
    const int layers = def.through + 1;
    const std::vector<Vec3> normals = normals_of(surface);
    for (std::size_t v = 0; v < vertices.size(); ++v)
        for (int t = 0; t < layers; ++t)
            mesh.nodes.push_back(vertices[v] - def.thickness * (def.through - t) / def.through * normals[v]);
    for (const Triangle& triangle : triangles)
        for (int t = 0; t < def.through; ++t) add_prism(mesh, triangle, layers, t);
    // Each tetrahedron must have a hundredth of what it would have over a flat triangle: thinner ones would be stiff
    // beyond measure.
    constexpr double least = 0.01;
    for (std::size_t k = 0; k < mesh.tetrahedra.size(); ++k) {
        const std::size_t t = k / (3 * static_cast<std::size_t>(def.through));
        if (volume(mesh.tetrahedra[k], mesh.nodes) >
            least * surface.area(triangles[t]).norm() * def.thickness / (3 * def.through))
            continue;
        wall.problem = "the wall is too thick for how its surface curves at " + name(t);
        return wall;
    }
    add_faces(mesh, surface, def.through);
    wall.problem = problem_with_faces(mesh, surface, def.thickness);
    return wall;
}

}  // namespace tissue
