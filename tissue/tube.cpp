#include "tissue/tube.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "sim/geometry/portable_math.hpp"

namespace tissue {

namespace {

using sim::geometry::portable_sin_cos;
using Place = std::array<int, 3>;  // of a node in the grid: along, around, through

constexpr double degree = EIGEN_PI / 180;

// The six orders in which three edges lead from a corner of a cell to the opposite one, each a tetrahedron (Kuhn 1960).
constexpr int paths[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                             {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};  // the last three go round the other way
constexpr std::size_t opposite[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};  // seen from outside

// Adds one cell after another; node(place) tells a node's number, side(places) whose surface three of them are on, if
// any. `turns_left`: the axes along, around and through of the grid are a left-handed system.
template <class Node, class Side>
void add_cell(Mesh& mesh, const Place& cell, bool turns_left, const Node& node, const Side& side) {
    // Every other cell is mirrored, so that diagonals meet on the faces between them and none prevails. Two axes change
    // places where that would turn tetrahedra inside out, so that all cells are split alike.
    const bool mirrored = (cell[0] + cell[1] + cell[2]) & 1;
    for (std::size_t way = 0; way < 6; ++way) {
        const auto& path = paths[way];
        Place corner = cell;
        for (std::size_t k = 0; k < 3; ++k) corner[k] += cell[k] & 1;
        std::array<Place, 4> places{corner};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(mirrored && path[k] < 2 ? 1 - path[k] : path[k]);
            corner[axis] += cell[axis] & 1 ? -1 : 1;
            places[k + 1] = corner;
        }
        if ((way >= 3) != turns_left) std::swap(places[2], places[3]);
        Tetrahedron tet;
        for (std::size_t k = 0; k < 4; ++k) tet[k] = node(places[k]);
        mesh.tetrahedra.push_back(tet);
        for (const auto& [a, b, c] : opposite)
            if (const auto found = side(places[a], places[b], places[c]))
                mesh.faces.push_back({{tet[a], tet[b], tet[c]}, *found});
    }
    mesh.cells.push_back(static_cast<int>(mesh.tetrahedra.size()));
}

bool all_at(const Place& a, const Place& b, const Place& c, std::size_t axis, int value) {
    return a[axis] == value && b[axis] == value && c[axis] == value;
}

// Share of the length at which each section lies, from the cut on.
std::vector<double> sections(const TubeDef& def) {
    const double first = def.near_length / def.near;
    std::vector<double> at;
    for (int i = 0; i <= def.near; ++i) at.push_back(i * first);
    const auto reach = [&](double factor) {
        double end = def.near_length, cell = first;
        for (int i = 0; i < def.far; ++i) end += cell *= factor;
        return end;
    };
    double low = 0, high = 1;
    while (def.far > 0 && reach(high) < def.length) high *= 2;
    constexpr int halvings = 60;  // to the last bit
    for (int i = 0; i < halvings; ++i) (reach(0.5 * (low + high)) < def.length ? low : high) = 0.5 * (low + high);
    double cell = first;
    for (int i = 0; i < def.far; ++i) at.push_back(at.back() + (cell *= high));
    for (double& x : at) x /= at.back();
    return at;
}

}  // namespace

std::optional<std::string> problem_with(const TubeDef& def) {
    if (!(def.wall > 0 && def.wall < def.diameter / 2 && def.diameter < 1))
        return "wall must be above 0 and below half of the diameter";
    if (!(def.cut_angle >= 45 && def.cut_angle <= 90)) return "cut angle must be 45 to 90 degrees";
    if (def.around < 6 || def.around % 2 != 0) return "cells around must be an even number, at least 6";
    if (def.through < 1 || def.near < 1 || def.far < 0) return "cells through and along must be at least 1";
    if (!(def.length < 1 && def.near_length > 0) ||
        (def.far > 0 ? def.near_length >= def.length : def.near_length != def.length))
        return "the near length must be above 0 and below the length, or all of it when no cells are far";
    if (def.length <= 0.5 * def.diameter / std::sqrt(2) + 0.5 * def.diameter)
        return "the tube must be longer than its slanted cut";
    return {};
}

Mesh make_tube(const TubeDef& def) {
    assert(def.wall > 0 && def.around >= 3 && def.through >= 1 && def.near >= 1 && def.far >= 0);
    Mesh mesh;
    const std::vector<double> section = sections(def);
    const int along = def.near + def.far, layers = def.through + 1;
    const double turn = 2 * EIGEN_PI / def.around, corners_out = std::sqrt(turn / portable_sin_cos(turn).sin);
    const auto [slant_sin, slant_cos] = portable_sin_cos(def.cut_angle * degree);
    const double slope = def.cut_angle == 90 ? 0 : slant_cos / slant_sin;
    for (const double share : section)
        for (int a = 0; a < def.around; ++a)
            for (int t = 0; t < layers; ++t) {
                const auto [sin, cos] = portable_sin_cos(turn * a);
                const double radius = corners_out * (def.diameter / 2 - def.wall + def.wall * t / def.through);
                mesh.nodes.emplace_back(share * def.length + (1 - share) * slope * radius * cos, radius * cos,
                                        radius * sin);
            }
    const auto node = [&](const Place& p) { return (p[0] * def.around + p[1] % def.around) * layers + p[2]; };
    const auto side = [&](const Place& a, const Place& b, const Place& c) -> std::optional<Side> {
        if (all_at(a, b, c, 2, 0)) return Side::inner;
        if (all_at(a, b, c, 2, def.through)) return Side::outer;
        if (all_at(a, b, c, 0, 0)) return Side::cut;
        if (all_at(a, b, c, 0, along)) return Side::far_end;
        return {};
    };
    for (int i = 0; i < along; ++i)
        for (int a = 0; a < def.around; ++a)
            for (int t = 0; t < def.through; ++t) add_cell(mesh, {i, a, t}, true, node, side);
    return mesh;
}

Mesh make_box(std::array<int, 3> counts, double edge) {
    assert(counts[0] > 0 && counts[1] > 0 && counts[2] > 0 && edge > 0);
    Mesh mesh;
    for (int i = 0; i <= counts[0]; ++i)
        for (int j = 0; j <= counts[1]; ++j)
            for (int k = 0; k <= counts[2]; ++k) mesh.nodes.push_back(edge * Vec3(i, j, k));
    const auto node = [&](const Place& p) { return (p[0] * (counts[1] + 1) + p[1]) * (counts[2] + 1) + p[2]; };
    const auto side = [&](const Place& a, const Place& b, const Place& c) -> std::optional<Side> {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (all_at(a, b, c, axis, 0) || all_at(a, b, c, axis, counts[axis])) return Side::outer;
        return {};
    };
    for (int i = 0; i < counts[0]; ++i)
        for (int j = 0; j < counts[1]; ++j)
            for (int k = 0; k < counts[2]; ++k) add_cell(mesh, {i, j, k}, false, node, side);
    return mesh;
}

}  // namespace tissue
