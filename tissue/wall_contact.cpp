// Walls against each other and themselves.
//
// Method: node to surface penalty contact with averaged normals (Yang, Laursen and Meng 2005). Nodes are sorted into a
// uniform grid; each triangle looks at the nodes in the cells near it, and each node keeps its nearest triangle. Cost:
// linear in nodes and triangles that are near each other.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/geometry/closest_points.hpp"
#include "tissue/contact.hpp"

namespace tissue {

namespace {

Box box_of(const Skin& skin) {
    Box all;
    for (const Vec3& node : skin.nodes()) all.include(node);
    return all;
}

}  // namespace

std::array<int, 3> WallContact::cell(const Vec3& at) const {
    std::array<int, 3> found{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        found[k] = static_cast<int>(std::clamp((at[axis] - grid_.low[axis]) / edge_, 0.0, size_[k] - 1.0));
    }
    return found;
}

// Nodes of the surface in `where`, by cells of a grid; those of a column follow each other.
void WallContact::sort_nodes(const Mesh& rest, const Skin& skin, const Box& where) {
    constexpr int most_along = 64, most_columns = (most_along + 1) * (most_along + 1);
    grid_ = where;
    const Vec3 extent = grid_.high - grid_.low;
    edge_ = std::max(0.5 * thickness_, extent.maxCoeff() / most_along);
    for (std::size_t k = 0; k < 3; ++k) size_[k] = 1 + static_cast<int>(extent[static_cast<Eigen::Index>(k)] / edge_);
    face_.assign(skin.nodes().size(), -1);
    for (std::size_t f = 0; f < rest.faces.size(); ++f)
        for (const int i : rest.faces[f].nodes) face_[static_cast<std::size_t>(i)] = static_cast<int>(f);
    sorted_.reserve(face_.size()), first_.reserve(most_columns + 1);
    sorted_.clear(), first_.assign(static_cast<std::size_t>(size_[0] * size_[1] + 1), 0);
    for (std::size_t i = 0; i < face_.size(); ++i) {
        const Vec3& at = skin.nodes()[i];
        if (face_[i] < 0 || !grid_.overlaps({at, at})) continue;
        const auto [x, y, z] = cell(at);
        sorted_.push_back({number(x, y, z), static_cast<int>(i)});
        ++first_[static_cast<std::size_t>(column(x, y) + 1)];
    }
    std::sort(sorted_.begin(), sorted_.end());
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    about_ = about_bent_ = {};
    for (const auto& of_cell : sorted_) {
        const auto node = static_cast<std::size_t>(of_cell[1]);
        about_.include(skin.nodes()[node]);
        if (is_bent_[node]) about_bent_.include(skin.nodes()[node]);
    }
    nearest_.assign(face_.size(), {-1, 0.5 * thickness_, 0, Vec3::Zero()});
}

// A wall that is thin is not through itself.
static bool is_next_to(const Mesh& rest, int node, const Face& face, double thickness) {
    const auto at = [&](int i) -> const Vec3& { return rest.nodes[static_cast<std::size_t>(i)]; };
    double longest = 0, nearest = 1e300;
    for (std::size_t k = 0; k < 3; ++k) {
        longest = std::max(longest, (at(face.nodes[k]) - at(face.nodes[(k + 1) % 3])).norm());
        nearest = std::min(nearest, (at(face.nodes[k]) - at(node)).norm());
    }
    return nearest < longest || nearest < 1.5 * thickness;
}

// Beyond an edge two triangles are as near: which side the node is on says the one that sees it less aslant. Of its own
// wall over a triangle's inside alone: about a hole that a needle dents the skins come near to each other.
void WallContact::look_at(const Mesh& rest, const Skin& nodes_of, int node, const Skin& triangles_of, int triangle,
                          const Vec3& up, bool same) {
    constexpr double rounding =
        1e-9;  // of a distance: thousands of times what two triangles make of the edge they share
    Nearest& known = nearest_[static_cast<std::size_t>(node)];
    const Vec3& at = nodes_of.nodes()[static_cast<std::size_t>(node)];
    const double depth = up.dot(triangles_of[triangle].a - at);
    if (!(std::abs(depth) < known.distance)) return;
    if (same && (weights_in(triangles_of[triangle], at).minCoeff() < 0 ||
                 is_next_to(rest, node, rest.faces[static_cast<std::size_t>(triangles_of.face(triangle))], thickness_)))
        return;
    const Vec3 place = sim::geometry::closest_point(at, triangles_of[triangle]);
    const double distance = (place - at).norm(), nearer = known.distance - distance, equal = rounding * distance;
    if (nearer > equal || (nearer >= -equal && std::abs(depth) > std::abs(known.depth)))
        known = {triangle, distance, depth, place};
}

void WallContact::find(const Mesh& rest, const Skin& nodes_of, const Skin& triangles_of, bool same) {
    for (int t = 0; t < triangles_of.size(); ++t) {
        const auto& corners = rest.faces[static_cast<std::size_t>(triangles_of.face(t))].nodes;
        const bool all = !same || std::any_of(corners.begin(), corners.end(),
                                              [&](int i) { return is_bent_[static_cast<std::size_t>(i)]; });
        const Box around = triangles_of.box(t).grown(0.5 * thickness_);
        if (!around.overlaps(all ? about_ : about_bent_)) continue;
        const Vec3 up = triangles_of.normal(t);
        const auto low = cell(around.low), high = cell(around.high);
        for (int x = low[0]; x <= high[0]; ++x)
            for (int y = low[1]; y <= high[1]; ++y) {
                const auto in_column = static_cast<std::size_t>(column(x, y));
                for (int k = first_[in_column]; k < first_[in_column + 1]; ++k) {
                    const auto [in_cell, node] = sorted_[static_cast<std::size_t>(k)];
                    if (in_cell < number(x, y, low[2]) || in_cell > number(x, y, high[2]) ||
                        !(all || is_bent_[static_cast<std::size_t>(node)]))
                        continue;
                    look_at(rest, nodes_of, node, triangles_of, t, up, same);
                }
            }
    }
}

// Of each node, for each side of the wall that it is on, the sum of its faces' normals, each as long as its area.
void WallContact::find_normals(const Mesh& rest, const Skin& skin) {
    for (auto& of_side : normals_) of_side.assign(rest.nodes.size(), Vec3::Zero());
    for (const Face& face : rest.faces) {
        const auto at = [&](std::size_t k) -> const Vec3& {
            return skin.nodes()[static_cast<std::size_t>(face.nodes[k])];
        };
        const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0));
        for (const int node : face.nodes)
            normals_[static_cast<std::size_t>(face.side)][static_cast<std::size_t>(node)] += normal;
    }
}

// Turns steadily from triangle to triangle. By each one's own a node in the crease of two was thrown from one to the
// other: ends that a stitch drew together with 50 mN trembled by 25 mm/s for ever.
Vec3 WallContact::steady_normal(const Mesh& rest, const Skin& skin, int triangle, const Vec3& place) const {
    const Face& face = rest.faces[static_cast<std::size_t>(skin.face(triangle))];
    const Vec3 weights = skin.weights_in_face(skin.face(triangle), place).cwiseMax(0).cwiseMin(1);
    const auto& normals = normals_[static_cast<std::size_t>(face.side)];
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        sum +=
            weights[static_cast<Eigen::Index>(k)] * normals[static_cast<std::size_t>(face.nodes[k])].stableNormalized();
    return sum.stableNormalized();
}

void WallContact::push(const Mesh& rest, const Skin& nodes_of, std::vector<PointForce>& on_nodes,
                       const Mesh& rest_of_triangles, const Skin& triangles_of, std::vector<PointForce>& on_triangles) {
    const auto touches = [](const Nearest& nearest) { return nearest.triangle >= 0 && nearest.depth > 0; };
    if (std::any_of(nearest_.begin(), nearest_.end(), touches)) find_normals(rest_of_triangles, triangles_of);
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
        if (!touches(nearest_[i])) continue;
        const auto& [triangle, distance, depth, place] = nearest_[i];
        ++contacts_;
        const auto& nodes = rest.faces[static_cast<std::size_t>(face_[i])].nodes;
        const auto corner = std::find(nodes.begin(), nodes.end(), static_cast<int>(i)) - nodes.begin();
        const Vec3 up = steady_normal(rest_of_triangles, triangles_of, triangle, place),
                   force = def_.stiffness * distance * up;
        on_nodes.push_back({nodes_of.point_of_face(face_[i], Vec3::Unit(corner)), force, 2 * def_.stiffness, up});
        on_triangles.push_back(
            {triangles_of.point(triangle, weights_in(triangles_of[triangle], place)), -force, 2 * def_.stiffness, up});
    }
}

void WallContact::press(const Mesh& rest_a, const Skin& a, std::vector<PointForce>& on_a, const Mesh& rest_b,
                        const Skin& b, std::vector<PointForce>& on_b) {
    contacts_ = 0;
    const Box box_a = box_of(a).grown(0.5 * thickness_), box_b = box_of(b).grown(0.5 * thickness_);
    if (!box_a.overlaps(box_b)) return;
    is_bent_.assign(std::max(rest_a.nodes.size(), rest_b.nodes.size()), false);
    const Box both{box_a.low.cwiseMax(box_b.low), box_a.high.cwiseMin(box_b.high)};
    sort_nodes(rest_a, a, both), find(rest_a, a, b, false), push(rest_a, a, on_a, rest_b, b, on_b);
    sort_nodes(rest_b, b, both), find(rest_b, b, a, false), push(rest_b, b, on_b, rest_a, a, on_a);
}

// What touches was further apart at rest than the wall is thick: one of the two has gone.
void WallContact::press(const Mesh& rest, const Skin& skin, std::vector<PointForce>& forces,
                        const Eigen::Isometry3d& carried) {
    contacts_ = 0;
    const double gone = 0.25 * thickness_;
    is_bent_.resize(rest.nodes.size());
    for (std::size_t i = 0; i < is_bent_.size(); ++i)
        is_bent_[i] = (skin.nodes()[i] - carried * rest.nodes[i]).squaredNorm() > gone * gone;
    if (std::none_of(is_bent_.begin(), is_bent_.end(), [](bool bent) { return bent; })) return;
    sort_nodes(rest, skin, box_of(skin)), find(rest, skin, skin, true), push(rest, skin, forces, rest, skin, forces);
}

}  // namespace tissue
