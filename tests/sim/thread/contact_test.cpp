#include <gtest/gtest.h>

#include <array>

#include "assets/mesh.hpp"
#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "tests/sim/thread/scene.hpp"

namespace {

using namespace scene;
using sim::geometry::Capsule;
using sim::thread::MovingCapsule;

constexpr double tool_radius = 0.5e-3;  // [m]

Capsule moved(const Capsule& capsule, const Vec3& by) {
    return {capsule.a + by, capsule.b + by, capsule.radius};
}

double gap_to(const Thread& thread, const Capsule& capsule) {
    double least = 1e300;
    for (std::size_t i = 0; i + 1 < thread.nodes().size(); ++i)
        least = std::min(least,
                         sim::geometry::closest_points(thread.nodes()[i], thread.nodes()[i + 1], capsule.a, capsule.b)
                             .distance_squared);
    return std::sqrt(least);
}

/// A capsule across the middle of a thread held at both ends, `slack` of its length to spare, driven sideways.
struct Struck {
    Worst worst;
    double gap = 0;   ///< Between the axes of both in the end [m].
    double lead = 0;  ///< How far the thread's middle is in front of the tool's axis in the end [m].
};

Struck struck(double speed, double slack) {
    Thread thread({}, straight(200));
    const Vec3 left = thread.nodes().front(), right = thread.nodes().back();
    const int owners[] = {-1, -1};
    const auto holds_at = [&](double share) {
        return std::array<Hold, 2>{Hold{0, left}, Hold{200, Vec3(right.x() * (1 - share), 0, 0)}};
    };
    for (int i = 1; i <= 100; ++i) thread.tick({holds_at(slack * i / 100), owners, {}, nullptr});
    const double middle = right.x() * (1 - slack) / 2;
    Capsule tool{Vec3(middle, -5e-3, -30e-3), Vec3(middle, -5e-3, 30e-3), tool_radius};
    Struck result;
    for (int i = 0; i < 20e-3 / (speed * tick); ++i) {
        const Vec3 by(0, speed * tick, 0);
        const MovingCapsule capsules[] = {{tool, moved(tool, by), 0}};
        const TickReport report = thread.tick({holds_at(slack), owners, capsules, nullptr});
        result.worst.add(report);
        tool = moved(tool, report.fraction * by);
    }
    result.gap = gap_to(thread, tool);
    result.lead = thread.nodes()[100].y() - tool.a.y();
    return result;
}

// A needle holder struck across a held thread. Looked at once a tick it would come out on the other side; it has to
// push a slack thread along until it is taut, and then be held up by it.
TEST(Contact, ACapsuleNeverCrossesAHeldThread) {
    for (const double speed : {0.02, 0.1, 0.2, 1.0})
        for (const double slack : {0.0, 0.3}) {
            SCOPED_TRACE(std::to_string(speed) + " m/s, slack " + std::to_string(slack));
            const Struck result = struck(speed, slack);
            EXPECT_EQ(result.worst.pass_throughs, 0);
            EXPECT_LE(result.worst.stretch, 0.01);
            EXPECT_LT(result.worst.fraction, 1);
            EXPECT_GT(result.gap, 0.5 * (tool_radius + radius));
            EXPECT_GT(result.lead, 0);
        }
}

// Where thread runs over steel, friction is what a surgeon feels as a throw that holds. Without it everything must
// slide, with it a strand pinched between two bars comes along.
TEST(Contact, APinchedThreadComesAlongWithFrictionAndStaysWithoutIt) {
    const auto way_with = [](double friction) {
        ThreadDef def;
        def.friction_tool = friction;
        Thread thread(def, straight(60));
        // The bars close by a twentieth of the thread's radius: thread pressed, nothing trapped.
        const double off = tool_radius + 0.95 * radius, middle = 60 * radius;
        Capsule above{Vec3(middle, -2e-3, off), Vec3(middle, 2e-3, off), tool_radius};
        Capsule below{Vec3(middle, -2e-3, -off), Vec3(middle, 2e-3, -off), tool_radius};
        const double start = thread.nodes()[0].x();
        for (int i = 0; i < 100; ++i) {
            const Vec3 by(0.01e-3, 0, 0);
            const MovingCapsule capsules[] = {{above, moved(above, by), 0}, {below, moved(below, by), 0}};
            const TickReport report = thread.tick({{}, {}, capsules, nullptr});
            above = moved(above, report.fraction * by);
            below = moved(below, report.fraction * by);
        }
        return (thread.nodes()[0].x() - start) / (above.a.x() - middle);
    };
    EXPECT_NEAR(way_with(0), 0, 0.01);
    EXPECT_GT(way_with(1), 0.5);
}

// A thread drawn down over a vessel wraps it. If triangles were looked up where the thread is, not where it goes, the
// wall would be cut at the first hurried pull.
TEST(Contact, AThreadPulledOverATubeStaysOutside) {
    const sim::geometry::TriangleTree tube(assets::make_tube(4e-3, 0.6e-3, 20e-3, 32, 10).soup());
    std::vector<Vec3> nodes;  // across the tube, along y, above it
    constexpr int links = 200;
    for (int i = 0; i <= links; ++i) nodes.emplace_back(0.3e-3, (i - links / 2) * 0.1e-3, 2.2e-3);
    Thread thread({}, nodes);
    const int owners[] = {-1, -1};
    Worst worst;
    for (int i = 1; i <= 200; ++i) {
        const double down = i * 0.1e-3;
        const Hold holds[] = {{0, nodes.front() - Vec3(0, 0, down)}, {links, nodes.back() - Vec3(0, 0, down)}};
        worst.add(thread.tick({holds, owners, {}, &tube}));
    }
    EXPECT_EQ(worst.pass_throughs, 0);
    EXPECT_LE(worst.stretch, 0.01);
    EXPECT_LT(worst.fraction, 1);  // a taut thread over a wall holds the tools up
    for (const Vec3& p : thread.nodes())
        EXPECT_GT(std::hypot(p.y(), p.z()), 2e-3 * std::cos(std::numbers::pi / 32) - 0.5 * radius);
}

}  // namespace
