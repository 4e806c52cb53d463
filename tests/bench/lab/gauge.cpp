#include "tests/bench/lab/gauge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/geometry/closest_points.hpp"

namespace bench::lab {

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

Gauge::Gauge(std::vector<double> rest, double diameter) : rest_(std::move(rest)), arc_{0}, diameter_(diameter) {
    for (const double link : rest_) arc_.push_back(arc_.back() + link);
}

Gauge::Gauge(const sim::thread::Thread& thread)
    : Gauge({thread.rest_lengths().begin(), thread.rest_lengths().end()}, 2 * thread.def().radius) {}

double Gauge::stretch(std::span<const Vec3> nodes) const {
    if (!is_finite(nodes)) return NAN;
    double most = -1;
    for (std::size_t i = 0; i < rest_.size(); ++i)
        most = std::max(most, (nodes[i + 1] - nodes[i]).norm() / rest_[i] - 1);
    return most;
}

double Gauge::gap(std::span<const Vec3> nodes) const {
    if (!is_finite(nodes)) return NAN;
    const double step = longest(nodes), half_turn = 0.5 * std::numbers::pi * diameter_;
    double least = 3 * diameter_;
    const auto middle = [&](std::size_t i) { return Vec3(0.5 * (nodes[i] + nodes[i + 1])); };
    for (std::size_t i = 0; i < rest_.size(); ++i) {
        for (std::size_t j = i + 2; j < rest_.size(); ++j) {
            // Middles of neighbouring links are at most `step` apart, so what is far off lets us skip as many.
            const double spare = (middle(i) - middle(j)).norm() - step - least;
            if (spare > 0) {
                j += static_cast<std::size_t>(spare / step);
                continue;
            }
            if (arc_[j] - arc_[i + 1] < half_turn) continue;
            const auto pair = sim::geometry::closest_points(nodes[i], nodes[i + 1], nodes[j], nodes[j + 1]);
            least = std::min(least, std::sqrt(pair.distance_squared));
        }
    }
    return least / diameter_;
}

double Gauge::kappa(std::span<const Vec3> nodes) const {
    return (length() - (nodes.back() - nodes.front()).norm()) / diameter_;
}

double percentile(std::vector<double> values, double share) {
    if (std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); })) return NAN;
    if (values.empty()) return NAN;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace bench::lab
