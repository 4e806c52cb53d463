#include "app/bench/start_shapes.hpp"

#include <cmath>
#include <numbers>

namespace app::bench {

constexpr double pi = std::numbers::pi;

std::vector<Vec3> overhand_path() {
    std::vector<Vec3> path;
    constexpr int points = 400;
    for (int i = 0; i <= points; ++i) {
        const double t = 2.1 * (2.0 * i / points - 1);
        path.emplace_back(t * t * t - 3 * t, t * t * t * t - 4 * t * t, 0.25 * (t * t * t * t * t - 10 * t));
    }
    const auto led_out = [](const Vec3& end, const Vec3& before) { return Vec3(end + 4 * (end - before).normalized()); };
    path.insert(path.begin(), led_out(path[0], path[1]));
    path.push_back(led_out(path.back(), path[path.size() - 2]));
    return path;
}

// Two strands run across one another in every throw, twisted (2 turns + 1) half turns about x, right-handed or not.
static void append_throw(std::vector<Vec3>& strand, int turns, bool right_handed, double side, double z) {
    constexpr double half_width = 2;
    const double turn = (right_handed ? 1 : -1) * (2 * turns + 1) * pi;
    const int steps = 12 * (2 * turns + 1);
    for (int i = 0; i <= steps; ++i) {
        const double x = side * half_width * (1 - 2.0 * i / steps);
        const double phase = -pi / 2 + turn * (x - side * half_width) / (2 * half_width);
        strand.emplace_back(x, std::cos(phase), z + std::sin(phase));
    }
}

std::vector<Vec3> tied_path(const std::string& throws) {
    std::vector<Vec3> a{{-2.5, 0, -3}}, b{{2.5, 0, -3}};
    double side = -1, z = 0;
    bool right_handed = true;
    for (std::size_t i = 0; i < throws.size(); i += 2, side = -side, z += 3) {
        if (i > 0 && throws[i - 1] == '=') right_handed = !right_handed;  // "=": the other hand; "x": the same again
        append_throw(a, throws[i] - '0', right_handed, side, z);
        append_throw(b, throws[i] - '0', right_handed, -side, z);
    }
    a.emplace_back(3 * side, 0, z + 4);
    b.emplace_back(-3 * side, 0, z + 4);
    if (a.back().x() > b.back().x()) std::swap(a, b);  // first to last along +x, the loop below, however many throws
    std::vector<Vec3> path(a.rbegin(), a.rend());
    path.emplace_back(0, 0, -6);
    path.insert(path.end(), b.begin(), b.end());
    return path;
}

std::vector<Vec3> coil_path(double turns, double radius, double pitch) {
    constexpr int points_a_turn = 48;  // a chord within 0.2 % of its arc
    const int points = static_cast<int>(std::ceil(turns * points_a_turn));
    std::vector<Vec3> path;
    for (int i = 0; i <= points; ++i) {
        const double turn = turns * i / points, angle = 2 * pi * turn;
        path.emplace_back(pitch * (turn - turns / 2), radius * std::cos(angle), radius * std::sin(angle));
    }
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

}  // namespace app::bench
