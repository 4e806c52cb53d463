#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/thread.hpp"

namespace faceted_bar {

using namespace sim::thread;
using sim::geometry::Triangle;
using sim::geometry::TriangleTree;
using sim::geometry::Vec3;

// A bar along x of 64 flat faces, as a mesh has it [m].
TriangleTree bar_of_facets(double radius) {
    constexpr int faces = 64;
    std::vector<Triangle> triangles;
    const auto corner = [&](double x, int i) {
        const double angle = 2 * std::numbers::pi * i / faces;
        return Vec3(x, radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int i = 0; i < faces; ++i) {
        const Vec3 a = corner(-30e-3, i), b = corner(30e-3, i), c = corner(30e-3, i + 1), d = corner(-30e-3, i + 1);
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
    return TriangleTree(triangles);
}

// A thread once round a bar along x, its ends 60 mm off along -z and z: a helix of slope 0.037 with straight legs [m].
std::vector<Vec3> once_round(double radius, int links) {
    constexpr double leg = 60e-3, slope = 0.037;
    const double arc = 2 * std::numbers::pi * radius;
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) {
        const double on = (2 * leg + arc) * i / links - leg, turned = std::clamp(on, 0.0, arc) / radius;
        const double beyond = std::min(on, 0.0) + std::max(on - arc, 0.0);
        nodes.emplace_back(slope * (on - 0.5 * arc), radius * std::cos(turned), radius * std::sin(turned) + beyond);
    }
    return nodes;
}

// The friction that its ends tell when one leads the thread on at 20 mm/s and the other follows (Euler and Eytelwein),
// less what bending takes of both: B / (2 R^2).
double friction_round_bar(int links) {
    constexpr double thick = 0.3e-3, bar = 2e-3, speed = 20e-3, dt = 1e-3, taut = 1.2e-3;
    ThreadDef def{.radius = thick / 2, .friction = 0.2};
    def.elastic = {.young = 500e6, .axial_over_bending = 0};
    const double round = bar + def.radius;
    const TriangleTree surface = bar_of_facets(bar);
    const std::vector<Vec3> nodes = once_round(round, links);
    Thread thread(def, nodes);
    double first = 0, last = 0;
    for (int t = 1; t <= 400; ++t) {
        const double led = std::min(taut, 6e-3 * t * dt) + speed * dt * std::max(0, t - 200);
        const double let = std::min(0.2e-3, 1e-3 * t * dt) - speed * dt * std::max(0, t - 200);
        const Hold holds[] = {{0, nodes.front() - led * Vec3::UnitZ()}, {links, nodes.back() + let * Vec3::UnitZ()}};
        constexpr int owners[] = {-1, -1};
        thread.tick({holds, owners, {}, &surface, dt});
        if (t > 250) first += thread.tension()[0] / 150, last += thread.tension().back() / 150;
    }
    RodDef rod = *def.elastic;
    rod.radius = def.radius;
    const double bent = rod.bending_stiffness() / (2 * round * round);
    return std::log((first - bent) / (last - bent)) / (2 * std::numbers::pi);
}

// Right is 0.2, within 5 %, however many links go round: 35 to 4 degrees a link. Contacts that are not solved to the
// end lose up to two fifths of it; turn that is taken for a rim's loses an eighth with the longest links.
TEST(FacetedBar, DragsByItsFriction) {
    for (const int links : {100, 133, 200, 266, 400, 600, 888})
        EXPECT_NEAR(friction_round_bar(links), 0.2, 0.01) << links;
}

}  // namespace faceted_bar
