#include "sim/knot/curve.hpp"

#include <algorithm>

namespace sim::knot {

std::uint64_t mixed(std::uint64_t counter) {
    std::uint64_t z = (counter + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

namespace {

double uniform(std::uint64_t counter) {  // in (-1, 1)
    return static_cast<double>(mixed(counter) >> 11) * 0x1p-52 - 1.0;
}

// Any rotation that lines nothing up with anything: Euler-Rodrigues from four unrelated numbers.
geometry::Quat general_turn() {
    return geometry::Quat(0.6180339887, 0.3819660113, -0.4142135624, 0.5477225575).normalized();
}

}  // namespace

Vec3 direction(int i) {
    for (auto k = static_cast<std::uint64_t>(i) * 1000;; k += 3) {
        const Vec3 v(uniform(k), uniform(k + 1), uniform(k + 2));
        const double length = v.norm();
        if (length > 0.1 && length < 1.0) return v / length;
    }
}

std::vector<std::vector<Vec3>> in_general_position(const std::vector<Component>& components) {
    geometry::Box box;
    for (const Component& c : components)
        for (const Vec3& p : c.vertices) box.include(p);
    const Vec3 centre = 0.5 * (box.low + box.high);
    const double size = (box.high - box.low).maxCoeff();
    const double scale = size > 0.0 ? 1.0 / size : 1.0;
    const geometry::Quat turn = general_turn();
    std::uint64_t counter = 0;
    std::vector<std::vector<Vec3>> result;
    for (const Component& c : components) {
        auto& points = result.emplace_back();
        points.reserve(c.vertices.size());
        const Vec3* last = nullptr;
        for (const Vec3& p : c.vertices) {
            counter += 3;
            if (last && (p - *last).norm() * scale <= same_place) continue;
            last = &p;
            const Vec3 shift(uniform(counter), uniform(counter + 1), uniform(counter + 2));
            points.push_back(turn * Vec3(scale * (p - centre)) + 1e-9 * shift);
        }
        while (c.closed && points.size() > 1 && (points.front() - points.back()).norm() <= same_place + 4e-9)
            points.pop_back();
    }
    return result;
}

}  // namespace sim::knot
