// How open a vessel is next to its cut: plane sections through the lumen's triangles, whose outlines' areas are summed
// edge by edge, against the same sections at rest. Cost: linear in the faces about the cut, for each of 17 sections.
#include "tissue/lumen.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tissue {

namespace {

double diameter(const Rim& rim) {
    return rim.length / std::numbers::pi;
}

std::vector<Face> inner_faces(const Mesh& mesh, const Vec3& centre, double reach) {
    std::vector<Face> found;
    const auto is_near = [&](int node) {
        return (mesh.nodes[static_cast<std::size_t>(node)] - centre).norm() <= reach;
    };
    for (const Face& face : mesh.faces)
        if (face.side == Side::inner && std::all_of(face.nodes.begin(), face.nodes.end(), is_near))
            found.push_back(face);
    return found;
}

// Area of a rim's polygon, seen along the normal [m^2].
double area(const Rim& rim, std::span<const Vec3> nodes, const Vec3& normal) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < rim.nodes.size(); ++k) {
        const auto at = [&](std::size_t i) -> const Vec3& {
            return nodes[static_cast<std::size_t>(rim.nodes[i % rim.nodes.size()])];
        };
        sum += (at(k) - at(0)).cross(at(k + 1) - at(0));
    }
    return std::abs(0.5 * sum.dot(normal));
}

}  // namespace

// Where a triangle has one corner on one side, the plane cuts the two edges there. An outline closes where each cut
// edge has two triangles. Its area is the sum of what its pieces span with any point, the same way round in all.
std::optional<double> section_area(std::span<const Face> inner, std::span<const Vec3> nodes, const Vec3& point,
                                   const Vec3& normal) {
    std::vector<std::pair<int, int>> edges;
    Vec3 sum = Vec3::Zero();
    for (const Face& face : inner) {
        const auto at = [&](std::size_t k) -> const Vec3& {
            return nodes[static_cast<std::size_t>(face.nodes[k % 3])];
        };
        const auto height = [&](std::size_t k) { return normal.dot(at(k) - point); };
        const auto crossing = [&](std::size_t from, std::size_t to) {
            edges.push_back(std::minmax(face.nodes[from % 3], face.nodes[to % 3]));
            return Vec3(at(from) + height(from) / (height(from) - height(to)) * (at(to) - at(from)) - point);
        };
        for (std::size_t k = 0; k < 3; ++k) {
            const bool above = height(k) > 0;
            if ((height(k + 1) > 0) == above || (height(k + 2) > 0) == above) continue;
            const Vec3 first = crossing(k, k + 1), second = crossing(k, k + 2);
            sum += above ? first.cross(second) : second.cross(first);
        }
    }
    if (edges.empty()) return {};
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size(); i += 2)
        if (i + 1 == edges.size() || edges[i] != edges[i + 1]) return {};
    return std::abs(0.5 * sum.dot(normal));
}

Axis axis_at(const Rim& inner, const Mesh& rest, std::span<const Vec3> nodes, const Vec3& axis) {
    const Vec3 cut = middle(inner, rest.nodes);
    std::vector<std::size_t> all;
    Vec3 mean_rest = Vec3::Zero(), mean_now = Vec3::Zero();
    for (std::size_t i = 0; i < rest.nodes.size(); ++i) {
        if ((rest.nodes[i] - cut).norm() > diameter(inner)) continue;
        all.push_back(i);
        mean_rest += rest.nodes[i], mean_now += nodes[i];
    }
    mean_rest /= static_cast<double>(all.size()), mean_now /= static_cast<double>(all.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero(), carried = Eigen::Matrix3d::Zero();
    for (const std::size_t i : all) {
        const Vec3 off = rest.nodes[i] - mean_rest;
        spread += off * off.transpose(), carried += (nodes[i] - mean_now) * off.transpose();
    }
    const Vec3 away = (mean_rest - cut).dot(axis) < 0 ? Vec3(-axis) : axis;
    return {away, (carried * (spread.inverse() * away)).normalized()};
}

double lumen_ratio(const Rim& inner, const Mesh& rest, std::span<const Vec3> nodes, const Vec3& axis) {
    constexpr int sections = 16;
    const Axis along = axis_at(inner, rest, nodes, axis);
    const Vec3 cut_rest = middle(inner, rest.nodes), cut_now = middle(inner, nodes);
    const std::vector<Face> faces = inner_faces(rest, cut_rest, 2.5 * diameter(inner));
    double least = area(inner, nodes, along.now) / area(inner, rest.nodes, along.rest);
    for (int k = 1; k <= sections; ++k) {
        const double off = diameter(inner) * k / sections;
        const auto before = section_area(faces, rest.nodes, cut_rest + off * along.rest, along.rest);
        const auto after = section_area(faces, nodes, cut_now + off * along.now, along.now);
        if (before && after) least = std::min(least, *after / *before);
    }
    return least;
}

double depth_in_lumen(const Vec3& point, const Skin& a, const Skin& b, double reach) {
    const Skin::Spot on_a = a.closest(point, point, reach),
                     on_b = b.closest(point, point, on_a.triangle >= 0 ? on_a.distance : reach);
    const Skin& skin = on_b.triangle >= 0 ? b : a;
    const Skin::Spot& spot = on_b.triangle >= 0 ? on_b : on_a;
    if (spot.triangle < 0 || skin.side(spot.triangle) != Side::inner) return 0;
    const double above = skin.normal(spot.triangle).dot(point - spot.at);
    return above > std::sqrt(0.5) * spot.distance ? spot.distance : 0;
}

}  // namespace tissue
