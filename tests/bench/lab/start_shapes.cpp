#include "tests/bench/lab/start_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/bench/lab/shape.hpp"
#include "tests/bench/lab/throws.hpp"

namespace bench::lab {

std::vector<Vec3> overhand_path() {
    std::vector<Vec3> path;
    constexpr int points = 400;
    for (int i = 0; i <= points; ++i) {
        const double t = 2.1 * (2.0 * i / points - 1);
        path.emplace_back(t * t * t - 3 * t, t * t * t * t - 4 * t * t, 0.25 * (t * t * t * t * t - 10 * t));
    }
    const auto led_out = [](const Vec3& end, const Vec3& before) {
        return Vec3(end + 4 * (end - before).normalized());
    };
    path.insert(path.begin(), led_out(path[0], path[1]));
    path.push_back(led_out(path.back(), path[path.size() - 2]));
    return path;
}

std::vector<Vec3> tied_path(const std::string& notation) {
    std::vector<sim::knot::Throw> throws;
    for (std::size_t i = 0; i < notation.size(); i += 2) {
        const bool other_hand = i > 0 && notation[i - 1] == '=';  // "=": the other hand; "x": the same again
        throws.push_back({notation[i] - '0', i == 0 || throws.back().right_handed != other_hand});
    }
    std::vector<Vec3> path = tied(throws);
    if (path.front().x() > path.back().x())
        std::reverse(path.begin(), path.end());  // the loop below, however many throws
    return path;
}

std::vector<Vec3> coil_path(double turns, double radius, double pitch) {
    constexpr int points_a_turn = 48;  // a chord within 0.2 % of its arc
    const int points = static_cast<int>(std::ceil(turns * points_a_turn));
    const double piece = turns / points * std::hypot(2 * std::numbers::pi * radius, pitch);
    std::vector<Vec3> path = coil(points, piece, radius, pitch);
    for (Vec3& p : path) p.x() -= pitch * turns / 2;
    return path;
}

std::vector<Vec3> folded_path(int folds, double length, double gap) {
    std::vector<Vec3> path;
    for (int strand = 0; strand <= folds; ++strand) {
        const double way = strand % 2 == 0 ? 1 : -1, y = strand * gap;
        path.emplace_back(-way * length / 2, y, 0);
        path.emplace_back(way * length / 2, y, 0);
    }
    return path;
}

double length_of(const std::vector<Vec3>& path) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) length += (path[i + 1] - path[i]).norm();
    return length;
}

std::vector<Vec3> laid_along_x(std::vector<Vec3> path, double length) {
    const double scale = length / length_of(path);
    const Vec3 middle = (path.front() + path.back()) / 2;
    const auto turn = Eigen::Quaterniond::FromTwoVectors(path.back() - path.front(), Vec3::UnitX());
    for (Vec3& p : path) p = scale * (turn * Vec3(p - middle));
    return path;
}

}  // namespace bench::lab
