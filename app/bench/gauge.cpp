#include "app/bench/gauge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/geometry/closest_points.hpp"

namespace app::bench {

namespace {

double longest(std::span<const Vec3> nodes) {
    double length = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) length = std::max(length, (nodes[i] - nodes[i - 1]).norm());
    return length;
}

bool is_finite(std::span<const Vec3> nodes) {
    return std::all_of(nodes.begin(), nodes.end(), [](const Vec3& p) { return p.allFinite(); });
}

}  // namespace

double Gauge::stretch(std::span<const Vec3> nodes) const {
    return is_finite(nodes) ? longest(nodes) / link_ - 1 : NAN;
}

double Gauge::gap(std::span<const Vec3> nodes) const {
    if (!is_finite(nodes)) return NAN;
    const auto neighbours = static_cast<std::size_t>(std::ceil(0.5 * std::numbers::pi * diameter_ / link_)) + 1;
    const double step = longest(nodes);
    double least = 3 * diameter_;
    const auto middle = [&](std::size_t i) { return Vec3(0.5 * (nodes[i] + nodes[i + 1])); };
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        for (std::size_t j = i + neighbours; j + 1 < nodes.size(); ++j) {
            // Middles of neighbouring links are at most `step` apart, so what is far off lets us skip as many.
            const double spare = (middle(i) - middle(j)).norm() - step - least;
            if (spare > 0) {
                j += static_cast<std::size_t>(spare / step);
                continue;
            }
            const auto pair = sim::geometry::closest_points(nodes[i], nodes[i + 1], nodes[j], nodes[j + 1]);
            least = std::min(least, std::sqrt(pair.distance_squared));
        }
    }
    return least / diameter_;
}

double Gauge::kappa(std::span<const Vec3> nodes) const {
    return (static_cast<double>(nodes.size() - 1) * link_ - (nodes.back() - nodes.front()).norm()) / diameter_;
}

double percentile(std::vector<double> values, double share) {
    if (std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); })) return NAN;
    if (values.empty()) return NAN;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace app::bench
