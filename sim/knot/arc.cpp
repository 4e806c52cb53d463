#include "sim/knot/arc.hpp"

#include <cmath>

namespace sim::knot {

Vec3 at_radius(const Vec3& from, const Vec3& along, double radius) {
    const double b = from.dot(along), c = from.squaredNorm() - radius * radius;
    return from + (std::sqrt(b * b - c) - b) * along;
}

Vec3 half_way(const Vec3& a, const Vec3& b, double radius) {
    Vec3 half = a + b;
    if (half.norm() < 0.1 * radius) half = a.unitOrthogonal();
    return radius * half.normalized();
}

// No more than 60 degrees apart.
void append_arc(std::vector<Vec3>& points, const Vec3& a, const Vec3& b, double radius) {
    const Vec3 half = half_way(a, b, radius);
    if (a.dot(half) < 0.5 * radius * radius) {
        append_arc(points, a, half, radius);
        points.push_back(half);
        append_arc(points, half, b, radius);
    } else if (a.dot(b) < 0.5 * radius * radius) {
        points.push_back(half);
    }
}

}  // namespace sim::knot
