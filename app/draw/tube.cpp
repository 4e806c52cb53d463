#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/draw/surface.hpp"
#include "sim/geometry/portable_math.hpp"

namespace app::draw {

constexpr int around = 16, cap_rings = 4, pieces = 5;

std::vector<Vec3> smooth_curve(const std::vector<Vec3>& points, int steps) {
    const int last = static_cast<int>(points.size()) - 1;
    const auto chord = [&](int i) { return (points[i + 1] - points[i]).norm(); };
    const auto slope = [&](int i) -> Vec3 {
        if (i == 0 || i == last)
            return (points[std::min(i + 1, last)] - points[std::max(i - 1, 0)]) / chord(i ? i - 1 : 0);
        const double before = chord(i - 1), after = chord(i);
        return (after / before * (points[i] - points[i - 1]) + before / after * (points[i + 1] - points[i])) /
               (before + after);
    };
    std::vector<Vec3> curve{points.front()};
    for (int i = 0; i < last; ++i) {
        const Vec3 from = chord(i) * slope(i), to = chord(i) * slope(i + 1), span = points[i + 1] - points[i];
        for (int k = 1; k < steps; ++k) {  // Hermite's cubic
            const double t = static_cast<double>(k) / steps;
            curve.push_back(points[i] + t * t * (3 - 2 * t) * span + t * (1 - t) * ((1 - t) * from - t * to));
        }
        curve.push_back(points[i + 1]);
    }
    return curve;
}

static std::vector<Vec3> ring(const Vec3& centre, const Vec3& u, const Vec3& v, double radius) {
    std::vector<Vec3> points;
    for (int k = 0; k < around; ++k) {
        const double angle = 2 * std::numbers::pi * k / around;
        points.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return points;
}

assets::Mesh tube(const std::vector<Vec3>& points, const std::function<double(const Vec3&)>& radius_at) {
    // Nodes nearer than a thousandth of the radius cannot be told apart in any picture that shows the radius.
    std::vector<Vec3> nodes;
    for (const Vec3& p : points)
        if (nodes.empty() || (p - nodes.back()).norm() > 1e-3 * radius_at(p)) nodes.push_back(p);
    if (nodes.empty()) return {};
    const std::vector<Vec3> curve = smooth_curve(nodes, pieces);
    const std::size_t last = curve.size() - 1;
    const auto direction = [&](std::size_t i) -> Vec3 {
        if (last == 0) return Vec3::UnitX();
        return (curve[std::min(i + 1, last)] - curve[i ? i - 1 : 0]).normalized();
    };

    std::vector<std::vector<Vec3>> rings;
    Vec3 along = direction(0), u = along.unitOrthogonal();
    const auto cap = [&](const Vec3& centre, double side, int i) {  // ring i of cap_rings, 0 the equator
        const double angle = std::numbers::pi / 2 * i / cap_rings, radius = radius_at(centre);
        rings.push_back(
            ring(centre + side * radius * std::sin(angle) * along, u, along.cross(u), radius * std::cos(angle)));
    };
    for (int i = cap_rings - 1; i > 0; --i) cap(curve.front(), -1, i);
    const Vec3 first_pole = curve.front() - radius_at(curve.front()) * along;
    for (std::size_t i = 0; i <= last; ++i) {
        const Vec3 next = direction(i);
        u = sim::geometry::rotation_between(along, next) * u;
        u = (u - u.dot(next) * next).normalized();
        along = next;
        cap(curve[i], 1, 0);
    }
    for (int i = 1; i < cap_rings; ++i) cap(curve.back(), 1, i);
    return loft(first_pole, rings, curve.back() + radius_at(curve.back()) * along);
}

}  // namespace app::draw
