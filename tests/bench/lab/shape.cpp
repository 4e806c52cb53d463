#include "tests/bench/lab/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/geometry/portable_math.hpp"
#include "tests/bench/lab/start_shapes.hpp"

namespace bench::lab {

using std::numbers::pi;

namespace {

// On the torus knot T(2, 3), the cut lies at angle 0; x is the way the ends leave.
Vec3 trefoil(double angle) {
    constexpr double height = 1.5;  // of the tube over its width: open enough for the thickest rope measured
    const double out = 2 + std::cos(3 * angle);
    return {out * std::sin(2 * angle), -out * std::cos(2 * angle), height * std::sin(3 * angle)};
}

// So fine that a link spans a dozen pieces and more.
std::vector<Vec3> overhand_path(int links, double length) {
    constexpr double cut = 0.2, knotted = 0.4;  // [rad] left out on either side; share of the length in the knot
    const int pieces = 2 * std::max(10000, 10 * links);
    std::vector<Vec3> path;
    for (int i = 0; i <= pieces; ++i) path.push_back(trefoil(cut + 2 * (pi - cut) * i / pieces));
    const double scale = knotted * length / length_of(path);
    for (Vec3& p : path) p *= scale;
    path.insert(path.begin(), path.front() - length * Vec3::UnitX());
    path.push_back(path.back() + length * Vec3::UnitX());
    return path;
}

// Steps of one length along a path whose pieces are far shorter, or straight: between two vertices it leaves the sphere
// about the last node just once.
class Walk {
  public:
    Walk(const std::vector<Vec3>& path, int way)
        : path_(path), vertex_(path.size() / 2), way_(way), at_(path[vertex_]) {}

    Vec3 next(double step) {
        while ((path_[ahead()] - at_).norm() < step) vertex_ = ahead();
        const Vec3 piece = path_[ahead()] - path_[vertex_], from = path_[vertex_] - at_;
        const double a = piece.squaredNorm(), b = from.dot(piece), c = from.squaredNorm() - step * step;
        at_ = path_[vertex_] + (std::sqrt(b * b - a * c) - b) / a * piece;
        return at_;
    }

  private:
    std::size_t ahead() const { return vertex_ + static_cast<std::size_t>(way_); }

    const std::vector<Vec3>& path_;
    std::size_t vertex_;
    int way_;
    Vec3 at_;
};

}  // namespace

std::vector<Vec3> overhand(int links, double length) {
    const std::vector<Vec3> path = overhand_path(links, length);
    const double link = length / links;
    Walk backwards(path, -1), forwards(path, 1);
    std::vector<Vec3> nodes;
    for (int i = 0; i < links / 2; ++i) nodes.push_back(backwards.next(link));
    std::reverse(nodes.begin(), nodes.end());
    nodes.push_back(path[path.size() / 2]);
    for (int i = links / 2; i < links; ++i) nodes.push_back(forwards.next(link));
    return nodes;
}

std::vector<Vec3> coil(int links, double link, double radius, double pitch) {
    const double advance = pitch / (2 * pi), step = link / std::hypot(radius, advance);  // [m/rad], [rad]
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) {
        const auto angle = sim::geometry::portable_sin_cos(std::remainder(step * i, 2 * pi));
        nodes.emplace_back(advance * step * i, radius * angle.cos, radius * angle.sin);
    }
    return nodes;
}

}  // namespace bench::lab
