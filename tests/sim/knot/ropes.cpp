#include "tests/sim/knot/ropes.hpp"

#include <numbers>

namespace ropes {

constexpr double pi = std::numbers::pi;

std::vector<Labelled> labelled(const std::string& id) {
    return bench::lab::labelled_curves(std::string(CARREL_SOURCE) + "/tests/data/curves", id);
}

Rope torus_knot(int n) {
    Rope rope;
    for (int i = 0; i < 200; ++i) {
        // Two tours, the section turning from outwards to downwards: about the way forward that is right-handed.
        const double along = 2 * pi * 2 * i / 200, around = 2 * pi * n * i / 200;
        const double radius = 2.0 + std::cos(around);
        rope.emplace_back(radius * std::cos(along), radius * std::sin(along), -std::sin(around));
    }
    return rope;
}

Rope mirrored(Rope rope) {
    for (Vec3& p : rope) p.x() = -p.x();
    return rope;
}

Rope turned(Rope rope, std::mt19937& random) {
    std::normal_distribution<double> normal;
    const Eigen::Quaterniond q =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    for (Vec3& p : rope) p = q * p;
    return rope;
}

}  // namespace ropes
