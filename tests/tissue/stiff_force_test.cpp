#include <gtest/gtest.h>

#include "tissue/tissue.hpp"
#include "tissue/tube.hpp"

namespace stiff_forces {

using namespace tissue;

constexpr double step = 2e-3;
constexpr MaterialPoint point{0, {0.25, 0.25, 0.25, 0.25}};  // next to the cut

std::vector<Hold> far_end_held(const Mesh& mesh) {
    std::vector<Hold> holds;
    const int section = TubeDef{}.around * (TubeDef{}.through + 1);
    for (int i = static_cast<int>(mesh.nodes.size()) - section; i < static_cast<int>(mesh.nodes.size()); ++i)
        holds.push_back({i, mesh.nodes[static_cast<std::size_t>(i)]});
    return holds;
}

// How stiff the wall itself is where it is pulled [N/m].
double own_stiffness(const Vec3& way) {
    const Mesh mesh = make_tube({});
    const std::vector<Hold> holds = far_end_held(mesh);
    Tissue tissue({}, mesh, {.iterations = 50, .steps_per_factor = 0, .tolerance = 1e-10});  // a millionth of the force
    const Vec3 before = tissue.position(point), force = 1e-4 * way;
    const PointForce forces[] = {{point, force}};
    for (int i = 0; i < 5; ++i) tissue.step({.holds = holds, .forces = forces}, 1e6);
    return force.norm() / (tissue.position(point) - before).norm();
}

// A spring from the point to where `goal` is, seized when the wall's factors know nothing of it.
struct Drawn {
    std::vector<double> gaps;  // [m]
    bool loses_energy = true;
};
Drawn drawn_to(const Vec3& goal_from_rest, double stiffness, int steps, bool implicit = true) {
    const Mesh mesh = make_tube({});
    const std::vector<Hold> holds = far_end_held(mesh);
    Tissue tissue({}, mesh);
    for (int i = 0; i < 20; ++i) tissue.step({.holds = holds}, step);
    const Vec3 goal = tissue.position(point) + goal_from_rest;
    Drawn drawn;
    double energy = 0.5 * stiffness * goal_from_rest.squaredNorm();
    for (int i = 0; i < steps; ++i) {
        const PointForce forces[] = {{point, stiffness * (goal - tissue.position(point)), implicit ? stiffness : 0}};
        drawn.loses_energy &= tissue.step({.holds = holds, .forces = forces}, step).energy_change <= 0;
        const double gap = (goal - tissue.position(point)).norm(), now = tissue.energy() + 0.5 * stiffness * gap * gap;
        drawn.loses_energy &= now <= energy * (1 + 1e-9);  // rounding
        energy = now;
        drawn.gaps.push_back(gap);
    }
    return drawn;
}

// A thousand newtons a metre: twenty times what the wall itself has and more. Most of the way in one step, though the
// factors know nothing of it, and never back.
TEST(StiffForce, ComesToBalanceInAFewSteps) {
    constexpr double stiffness = 1000, far = 0.3e-3;
    for (const Vec3& way : {Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.6, 0, -0.8)}) {
        SCOPED_TRACE(testing::Message() << way.transpose() << ": own " << own_stiffness(way));
        EXPECT_GT(stiffness, 20 * own_stiffness(way));
        const Drawn drawn = drawn_to(far * way, stiffness, 200);
        EXPECT_TRUE(drawn.loses_energy);
        const double balance = drawn.gaps.back();
        EXPECT_LT(balance, far / 20);
        EXPECT_LT(drawn.gaps[0], 0.25 * far);
        EXPECT_LT(drawn.gaps[4] - balance, 0.02 * far);
        for (std::size_t i = 1; i < drawn.gaps.size(); ++i)
            EXPECT_LE(drawn.gaps[i], drawn.gaps[i - 1] + 1e-4 * far) << i;
    }
}

TEST(StiffForce, WithoutItsStiffnessWouldSwingEverFarther) {
    const Drawn drawn = drawn_to(Vec3(-0.3e-3, 0, 0), 1000, 50, false);
    EXPECT_FALSE(drawn.loses_energy);
}

// Stiff one way, it leaves the others as free as without.
TEST(StiffForce, HoldsBackOneWayAlone) {
    const Mesh mesh = make_tube({});
    const std::vector<Hold> holds = far_end_held(mesh);
    const auto moved = [&](double stiffness) {
        Tissue tissue({}, mesh, {.iterations = 50, .steps_per_factor = 0, .tolerance = 1e-9});
        const Vec3 start = tissue.position(point);
        for (int i = 0; i < 20; ++i) {
            const Vec3 here = tissue.position(point);
            const PointForce forces[] = {
                {point, Vec3(-0.01, 0, 0.01) + Vec3(stiffness * (start - here).x(), 0, 0), stiffness, Vec3::UnitX()}};
            tissue.step({.holds = holds, .forces = forces}, step);
        }
        return Vec3(tissue.position(point) - start);
    };
    const Vec3 free = moved(0), stiff = moved(1e4);
    EXPECT_GT(std::abs(free.x()), 0.1e-3);
    EXPECT_LT(std::abs(stiff.x()), 2e-6);
    EXPECT_NEAR(stiff.z(), free.z(), 0.2 * std::abs(free.z()));
}

}  // namespace stiff_forces
