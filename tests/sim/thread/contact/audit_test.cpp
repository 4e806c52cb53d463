#include "sim/thread/contact/audit.hpp"

#include <gtest/gtest.h>

#include "sim/geometry/triangle_tree.hpp"
#include "tests/sim/thread/scene.hpp"

// The audit is the witness of "nothing passed through". A witness that cannot say yes proves nothing, and one that
// cries wolf stops a drill that went well.
namespace audits {

using namespace scene;
using sim::geometry::Capsule;
using sim::thread::contact::State;

int audit(const State& state) {
    return sim::thread::contact::Audit(state.most_links()).count_pass_throughs(state);
}

/// A thread in a U: links 0..9 along x at height h over links 13..22, which run back along x under it.
State bent(double height) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= 10; ++i) nodes.emplace_back(i, 0.3, height);
    nodes.emplace_back(14, 0.2, height);
    nodes.emplace_back(14, 0.1, 0);
    for (int i = 10; i >= 0; --i) nodes.emplace_back(i + 0.37, 0.05 * i, 0);  // not parallel to the upper strand
    return State({.radius = 0.05}, nodes);
}

int after_lowering(State state, double by) {
    state.before = state.nodes;
    for (std::size_t i = 0; i <= 10; ++i) state.nodes[i].z() -= by;
    return audit(state);
}

TEST(Audit, CountsAStrandThatWentThroughAnother) {
    EXPECT_EQ(after_lowering(bent(0.1), 0.2), 1);  // they cross once, near x = 6.4
    EXPECT_EQ(after_lowering(bent(-0.1), -0.2), 1);
}

TEST(Audit, DoesNotCountANearMiss) {
    EXPECT_EQ(after_lowering(bent(0.1), 0.0999), 0);
    EXPECT_EQ(after_lowering(bent(0.1), -3), 0);
}

TEST(Audit, DoesNotCountAStrandThatPassesBesideAnEnd) {
    State state(ThreadDef{.radius = 0.05}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0.5),
                                            Vec3(3, -0.5, 0.5), Vec3(-0.01, -0.5, 0.1), Vec3(-0.01, 0.5, 0.1)});
    state.before = state.nodes;
    state.nodes[5].z() = state.nodes[6].z() = -0.1;  // down past the free end at x = 0, a hundredth beside it
    EXPECT_EQ(audit(state), 0);
    state.nodes[5].x() = state.nodes[6].x() = state.before[5].x() = state.before[6].x() = 0.01;
    EXPECT_EQ(audit(state), 1);
}

TEST(Audit, CountsACapsuleThatWentThroughAndNotOneThatOnlyCameNear) {
    State state({}, straight(20));
    const double middle = 21 * radius;
    const auto at = [&](double z) { return Capsule{Vec3(middle, -1e-3, z), Vec3(middle, 1e-3, z), 0.2e-3}; };
    state.before = state.nodes;
    state.capsules_before = {at(1e-4)};
    state.capsules = {at(1e-6)};
    EXPECT_EQ(audit(state), 0);
    state.capsules = {at(-1e-4)};
    EXPECT_EQ(audit(state), 1);
}

TEST(Audit, CountsAThreadThatWentThroughASurfaceAndNotOneBesideIt) {
    const sim::geometry::TriangleTree wall({{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)}});
    State state({}, {Vec3(0, 0, 0.3), Vec3(0, 0, 0.2), Vec3(0, 0, 0.1)});
    state.input.surface = &wall;
    state.before = state.nodes;
    state.nodes[2].z() = 0.001;
    EXPECT_EQ(audit(state), 0);
    state.nodes[2].z() = -0.001;
    EXPECT_GT(audit(state), 0);
    for (std::size_t i = 0; i < 3; ++i) {
        state.before[i].x() += 2;
        state.nodes[i].x() += 2;
    }
    EXPECT_EQ(audit(state), 0);
}

}  // namespace audits
