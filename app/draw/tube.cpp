#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/draw/surface.hpp"
#include "sim/geometry/portable_math.hpp"

namespace app::draw {

std::vector<Vec3> smooth_curve(const std::vector<Vec3>& points, int pieces, double straight) {
    const int last = static_cast<int>(points.size()) - 1;
    const auto chord = [&](int i) { return (points[i + 1] - points[i]).norm(); };
    const auto slope = [&](int i) -> Vec3 {
        if (i == 0 || i == last)
            return (points[std::min(i + 1, last)] - points[std::max(i - 1, 0)]) / chord(i ? i - 1 : 0);
        const double before = chord(i - 1), after = chord(i);
        return (after / before * (points[i] - points[i - 1]) + before / after * (points[i + 1] - points[i])) /
               (before + after);
    };
    const double bent = std::cos(straight);
    const auto turns = [&](int i) {
        if (i == 0 || i == last) return false;
        return (points[i + 1] - points[i]).dot(points[i] - points[i - 1]) < bent * chord(i) * chord(i - 1);
    };
    std::vector<Vec3> curve{points.front()};
    for (int i = 0; i < last; ++i) {
        const int steps = straight > 0 && !turns(i) && !turns(i + 1) ? 1 : pieces;
        const Vec3 from = chord(i) * slope(i), to = chord(i) * slope(i + 1), span = points[i + 1] - points[i];
        for (int k = 1; k < steps; ++k) {  // Hermite's cubic
            const double t = static_cast<double>(k) / steps;
            curve.push_back(points[i] + t * t * (3 - 2 * t) * span + t * (1 - t) * ((1 - t) * from - t * to));
        }
        curve.push_back(points[i + 1]);
    }
    return curve;
}

namespace {

/// Skin that grows ring by ring.
class Skin {
  public:
    explicit Skin(int around) : around_(static_cast<unsigned>(around)) {
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * k / around;
            circle_.emplace_back(std::cos(angle), std::sin(angle));
        }
    }
    /// A ring about `centre` square to u and v, whose normals lean by sine along the tube; joined to the one before.
    void ring(const Vec3& centre, const Vec3& u, const Vec3& v, double radius, double sine) {
        const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
        const Vec3 lean = sine * u.cross(v);
        const auto first = static_cast<unsigned>(surface.vertices.size());
        for (const auto& [c, s] : circle_) {
            const Vec3 out = c * u + s * v;
            surface.vertices.push_back(
                {(centre + radius * out).cast<float>(), (cosine * out + lean).eval().cast<float>()});
        }
        if (first == 0) return;
        for (unsigned k = 0; k < around_; ++k) {
            const unsigned next = (k + 1) % around_, a = first - around_ + k, b = first - around_ + next;
            for (const unsigned i : {a, b, first + next, a, first + next, first + k}) surface.indices.push_back(i);
        }
    }
    Surface surface;

  private:
    struct OnCircle {
        double c, s;
        OnCircle(double cosine, double sine) : c(cosine), s(sine) {}
    };
    unsigned around_;
    std::vector<OnCircle> circle_;
};

}  // namespace

Surface tube(const std::vector<Vec3>& points, const std::function<double(const Vec3&)>& radius_at,
             const Roundness& roundness) {
    // Nodes nearer than a thousandth of the radius cannot be told apart in any picture that shows the radius.
    std::vector<Vec3> nodes;
    for (const Vec3& p : points)
        if (nodes.empty() || (p - nodes.back()).norm() > 1e-3 * radius_at(p)) nodes.push_back(p);
    if (nodes.empty()) return {};
    const std::vector<Vec3> curve = smooth_curve(nodes, roundness.pieces, roundness.straight);
    const std::size_t last = curve.size() - 1;
    const auto direction = [&](std::size_t i) -> Vec3 {
        if (last == 0) return Vec3::UnitX();
        return (curve[std::min(i + 1, last)] - curve[i ? i - 1 : 0]).normalized();
    };

    Skin skin(roundness.around);
    Vec3 along = direction(0), u = along.unitOrthogonal();
    const auto cap = [&](const Vec3& centre, double side,
                         int i) {  // ring i of cap_rings, 0 the equator, the last the pole
        const double angle = std::numbers::pi / 2 * i / roundness.cap_rings, radius = radius_at(centre);
        const double sine = side * std::sin(angle), cosine = i == roundness.cap_rings ? 0 : std::cos(angle);
        skin.ring(centre + sine * radius * along, u, along.cross(u), radius * cosine, sine);
    };
    for (int i = roundness.cap_rings; i > 0; --i) cap(curve.front(), -1, i);
    for (std::size_t i = 0; i <= last; ++i) {
        const Vec3 next = direction(i);
        u = sim::geometry::rotation_between(along, next) * u;
        u = (u - u.dot(next) * next).normalized();
        along = next;
        cap(curve[i], 1, 0);
    }
    for (int i = 1; i <= roundness.cap_rings; ++i) cap(curve.back(), 1, i);
    return std::move(skin.surface);
}

Surface band(const std::vector<Vec3>& points, const std::function<double(const Vec3&)>& radius_at,
             const Vec3& to_lamp) {
    Surface surface;
    const std::size_t last = points.size() - 1;
    Vec3 side = to_lamp.unitOrthogonal();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 across = (points[std::min(i + 1, last)] - points[i ? i - 1 : 0]).cross(to_lamp);
        if (across.norm() > 0) side = across.normalized();
        const double radius = radius_at(points[i]);
        for (const double way : {-radius, radius})
            surface.vertices.push_back({(points[i] + way * side).eval().cast<float>(), to_lamp.cast<float>()});
        const auto a = static_cast<unsigned>(2 * i);
        if (i < last)
            for (const unsigned v : {a, a + 1, a + 3, a, a + 3, a + 2}) surface.indices.push_back(v);
    }
    return surface;
}

}  // namespace app::draw
