#include "tests/bench/lab/throws.hpp"

#include <numbers>

#include "sim/geometry/portable_math.hpp"

namespace bench::lab {

static void append_throw(std::vector<Vec3>& strand, const sim::knot::Throw& t, double side, double z) {
    using std::numbers::pi;
    constexpr double half_width = 2;
    const double turn = (t.right_handed ? 1.0 : -1.0) * (2 * t.turns + 1) * pi;
    const int steps = 12 * (2 * t.turns + 1);
    for (int i = 0; i <= steps; ++i) {
        const auto phase = sim::geometry::portable_sin_cos(-pi / 2 + turn * -side * i / steps);
        strand.emplace_back(side * half_width * (1.0 - 2.0 * i / steps), phase.cos, z + phase.sin);
    }
}

std::vector<Vec3> tied(const std::vector<sim::knot::Throw>& throws, const std::vector<Vec3>& loop, const Vec3& lead) {
    std::vector<Vec3> a{{-2.5, 0, -3}}, b{{2.5, 0, -3}};
    double side = -1, z = 0;
    for (const auto& t : throws) {
        append_throw(a, t, side, z);
        append_throw(b, t, -side, z);
        side = -side;
        z += 3;
    }
    a.emplace_back(side * lead.x(), 0, z + lead.z());
    b.emplace_back(-side * lead.x(), 0, z + lead.z());
    std::vector<Vec3> path(a.rbegin(), a.rend());
    path.insert(path.end(), loop.begin(), loop.end());
    path.insert(path.end(), b.begin(), b.end());
    return path;
}

}  // namespace bench::lab
