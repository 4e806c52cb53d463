// Thread and walls that give way are moved in turn: what presses between them must come to rest all the same.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/thread.hpp"

namespace soft_wall {

using sim::geometry::Triangle;
using sim::geometry::TriangleTree;
using sim::thread::RodDef;
using sim::thread::Thread;
using sim::thread::Vec3;

constexpr double radius = 0.0425e-3, far = 0.1;  // [m]
constexpr double reckoned = 5000;                // [N/m]: what an edge takes the strand for

// A strand squeezed by two edges on springs, as one is between the lips of a bite.
struct Vice {
    Vice(double spring_given, double squeeze_given) : spring(spring_given), squeeze(squeeze_given) {}

    static Triangle edge(double z) { return {{0.75e-3, -far, z}, {0.75e-3, far, z}, {0.75e-3, 0, z + std::copysign(far, z)}}; }
    static std::vector<Vec3> line() {
        std::vector<Vec3> points;
        for (int i = 0; i <= 3; ++i) points.emplace_back(0.5e-3 * i, 0, 0);
        return points;
    }

    // What the strand presses each edge with, up above and down below [N].
    std::array<double, 2> tick() {
        const std::array holds{sim::thread::Hold{0, line().front()}, sim::thread::Hold{3, line().back()}};
        const std::array owners{-1, -1};
        thread.tick({.holds = holds, .hold_owners = owners, .capsules = {}, .surface = &edges, .surface_moved = moved, .sheathed = {}, .soft_from = 0, .soft_give = 1e-3});
        std::array<double, 2> pushed{}, deeper{};
        for (const auto& force : thread.surface_forces()) {
            const auto k = static_cast<std::size_t>(force.triangle);
            pushed[k] = std::abs(force.force.z());
            deeper[k] = k == 0 ? force.deeper.z() : -force.deeper.z();
        }
        moved = 0;
        for (std::size_t k = 0; k < 2; ++k) {
            // Implicitly, against its spring, from where the strand is; nearer to that by no more than it may.
            const double way = (pushed[k] + reckoned * deeper[k] - squeeze - spring * (out[k] - radius)) / (spring + reckoned);
            const double goes = std::max(way, -0.45 * std::max(0.0, out[k] - 0.6 * radius));
            out[k] += goes, moved = std::max(moved, std::abs(goes));
        }
        edges.move(std::vector{edge(out[0]), edge(-out[1])});
        return pushed;
    }

    double spring, squeeze;                                 ///< Of an edge [N/m], [N].
    std::array<double, 2> out{1.2 * radius, 1.2 * radius};  ///< Of each edge from the middle [m].
    double moved = 0;
    TriangleTree edges{{edge(1.2 * radius), edge(-1.2 * radius)}};
    Thread thread{{.radius = radius, .friction = 0.2, .elastic = RodDef{}}, line()};
};

// By the springs' law, whatever they are. Were the edges taken for rigid by the strand, which is 2 N a um stiff to them, it would be thrown to and fro between
// them, and pressed with up to 65 times as much.
TEST(SoftWalls, PressAStrandBetweenThemWithWhatTheyAreDrawnBy) {
    for (const double spring : {100, 1000})
        for (const double squeeze : {0.01, 0.05, 0.2}) {
            Vice vice(spring, squeeze);
            for (int t = 0; t < 200; ++t) vice.tick();
            for (int t = 0; t < 100; ++t)
                for (const double pushed : vice.tick()) EXPECT_NEAR(pushed, squeeze, 1e-3 * squeeze) << spring << " N/m";
            for (const double out : vice.out) EXPECT_NEAR(out, radius, 1e-3 * radius) << spring << " N/m";  // the contact's own 0.1 um at 0.2 N
        }
}

}  // namespace soft_wall
