// The field about what is operated on: cloth, and vessels that go on.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/draw/scene.hpp"

namespace app::draw {

Surface cloth() {
    constexpr int cells = 28;
    // Folds: waves of some 25 to 60 mm and up to 0.5 mm high, in the normals alone. The cells are finest in the middle.
    constexpr double waves[][4] = {{105, 170, 0.3, 0.5e-3}, {-190, 95, 1.9, 0.35e-3}, {60, -255, 4.0, 0.2e-3}};
    const auto place = [&](int i) {
        const double s = 2.0 * i / cells - 1;
        return cloth_reach * s * (0.25 + 0.75 * s * s);
    };
    Surface surface;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const double x = place(i), y = place(j);
            const Vec3 at(x, y, 0);
            Vec3 normal = Vec3::UnitZ();
            for (const auto& [kx, ky, phase, height] : waves) {
                const double angle = kx * x + ky * y + phase;
                normal -= height * std::cos(angle) * Vec3(kx, ky, 0);
            }
            surface.vertices.push_back({at.cast<float>(), normal.normalized().cast<float>()});
        }
    for (unsigned j = 0; j < cells; ++j)
        for (unsigned i = 0; i < cells; ++i) {
            const unsigned a = j * (cells + 1) + i, b = a + cells + 1;
            for (const unsigned v : {a, a + 1, b + 1, a, b + 1, b}) surface.indices.push_back(v);
        }
    return surface;
}

namespace {

/// The rim's outer corners, in their order about the outward axis.
std::vector<Vec3> rim_of(const assets::Mesh& mesh, const Continued& end) {
    constexpr double flat = 20e-6;  // [m] Half a thin wall's cell; a clamped end is flat to rounding.
    const Vec3 u = end.outwards.unitOrthogonal(), v = end.outwards.cross(u);
    std::vector<std::pair<double, Vec3>> found;
    double radius = 0;
    for (const Vec3& p : mesh.vertices) {
        const Vec3 off = p - end.centre;
        if (std::abs(off.dot(end.outwards)) > flat) continue;
        found.emplace_back(std::atan2(off.dot(v), off.dot(u)), p);
        radius = std::max(radius, off.norm());
    }
    std::erase_if(found, [&](const auto& one) { return (one.second - end.centre).norm() < 0.93 * radius; });
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Vec3> rim;
    for (const auto& one : found) rim.push_back(one.second);
    return rim;
}

}  // namespace

assets::Mesh continuation(const Picture& picture, const Continued& end) {
    const std::vector<Vec3> rim = rim_of(picture.vessels[end.vessel], end);
    if (rim.size() < 3) return {};
    constexpr double straight = 16e-3, bend = 25e-3, dip = 0.9;  // [m] Length of the one, radius of the other [rad].
    constexpr int steps = 4;
    // A vessel that stands upright goes straight on.
    const bool bends = std::abs(end.outwards.z()) < 0.7;
    const Vec3 level = bends ? Vec3(end.outwards.x(), end.outwards.y(), 0).normalized() : end.outwards;
    const Vec3 side = bends ? Vec3(level.cross(-Vec3::UnitZ()).normalized()) : level.unitOrthogonal();
    std::vector<std::vector<Vec3>> rings;
    const auto add = [&](const Vec3& centre, double angle) {
        const Eigen::AngleAxisd turn(angle, side);
        auto& ring = rings.emplace_back();
        for (const Vec3& p : rim) ring.push_back(centre + turn * (p - end.centre));
    };
    add(end.centre, 0);
    const Vec3 from = end.centre + straight * end.outwards;
    add(from, 0);
    for (int i = 1; bends && i <= steps; ++i) {
        const double angle = dip * i / steps;
        add(from + bend * (std::sin(angle) * end.outwards - (1 - std::cos(angle)) * Vec3::UnitZ()), angle);
    }
    Vec3 last = Vec3::Zero();
    for (const Vec3& p : rings.back()) last += p / static_cast<double>(rim.size());
    const double drop = bends && picture.drape ? last.z() - *picture.drape + (rim[0] - end.centre).norm() : 0;
    if (drop > 0) {
        last += drop / std::sin(dip) * (std::cos(dip) * end.outwards - std::sin(dip) * Vec3::UnitZ());
        add(last, dip);
    }
    return loft(end.centre, rings, last);
}

}  // namespace app::draw
