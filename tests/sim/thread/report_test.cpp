// Every figure of a TickReport from both sides, what bounds a node's move, Coulomb's limit, and the sizes that a thread
// has when nobody says otherwise.
#include <gtest/gtest.h>

#include "sim/geometry/closest_points.hpp"
#include "sim/geometry/triangle_tree.hpp"
#include "sim/thread/contact/detection.hpp"
#include "sim/thread/contact/gaps.hpp"
#include "sim/thread/ftl/resolve.hpp"
#include "tests/sim/thread/scene.hpp"

namespace reports {

using namespace scene;
using sim::geometry::TriangleTree;
using sim::rod::RodDef;
using sim::thread::contact::Detection;
using sim::thread::contact::State;

ThreadDef elastic(double axial_over_bending = 1e4) {
    return {.elastic = RodDef{.axial_over_bending = axial_over_bending}};
}

// A tick in which both ends of a straight thread of 20 links go by `way` [m].
TickReport led(Thread& thread, const Vec3& way, const TriangleTree* surface = nullptr) {
    const Hold holds[] = {{0, thread.nodes()[0] + way}, {20, thread.nodes()[20] + way}};
    const int owners[] = {-1, -1};
    return thread.tick({.holds = holds, .hold_owners = owners, .capsules = {}, .surface = surface});
}

// Carried freely a thread gives up nothing; at rest it does nothing at all.
TEST(Report, OfAThreadThatIsCarried) {
    for (const ThreadDef& def : {ThreadDef{}, elastic()}) {
        SCOPED_TRACE(def.elastic ? "elastic" : "ftl");
        Thread thread(def, straight(20));
        const TickReport moved = led(thread, Vec3(0, 0.5 * radius, 0));
        EXPECT_EQ(moved.fraction, 1);
        EXPECT_GE(moved.substeps, 1);
        EXPECT_EQ(moved.contacts, 0);
        EXPECT_LT(moved.stretch_max, 1e-3);
        EXPECT_EQ(moved.separation_min, 1e300) << "nothing is near";
        EXPECT_GT(moved.step_over_bound, 0.05);
        EXPECT_LE(moved.step_over_bound, 1 + 1e-12);
        EXPECT_EQ(moved.pass_throughs, 0);
        EXPECT_EQ(moved.sweeps, 0);
        EXPECT_FALSE(moved.not_finite);
        const TickReport fast = led(thread, Vec3(0, 12 * radius, 0));
        EXPECT_GT(fast.substeps, moved.substeps) << "one step may not go so far";
        EXPECT_LE(fast.step_over_bound, 1 + 1e-12);
        for (int i = 0; i < 20; ++i) led(thread, Vec3::Zero());
        const TickReport still = led(thread, Vec3::Zero());
        EXPECT_EQ(still.fraction, 1);
        EXPECT_EQ(still.substeps, def.elastic ? 1 : 0);
        EXPECT_LT(still.step_over_bound, 1e-6);
    }
}

// Drawn apart by a fiftieth: who cannot stretch waits, who can is longer by that.
TEST(Report, OfAThreadThatIsTaut) {
    for (const bool stretches : {false, true}) {
        Thread thread(stretches ? elastic(0) : ThreadDef{}, straight(20));
        const double length = 40 * radius;
        TickReport report;
        for (int i = 1; i <= 40; ++i) {
            const Hold holds[] = {{0, Vec3(-0.01 * length * i / 40, 0, 0)},
                                  {20, Vec3(length + 0.01 * length * i / 40, 0, 0)}};
            const int owners[] = {-1, -1};
            report = thread.tick({holds, owners, {}, nullptr});
        }
        if (stretches) {
            EXPECT_EQ(report.fraction, 1);
            EXPECT_NEAR(report.stretch_max, 0.02, 0.001);
        } else {
            EXPECT_LT(report.fraction, 0.5);
            EXPECT_LE(report.stretch_max, 1e-3);
        }
    }
}

// One tool pulls a thread that is taut, and waits; the other gives way, and need not: what is told is the share of the
// first.
TEST(Report, TellsTheLeastShareThatAnyToolMade) {
    Thread thread({}, straight(20));
    const int owners[] = {0, 1};
    Vec3 left = thread.nodes()[0], right = thread.nodes()[20];
    const auto pulled = [&](double left_by, double right_by) {
        const Hold holds[] = {{0, left + Vec3(left_by, 0, 0)}, {20, right + Vec3(right_by, 0, 0)}};
        const TickReport report = thread.tick({holds, owners, {}, nullptr});
        left.x() += thread.progress(0) * left_by, right.x() += thread.progress(1) * right_by;
        return report.fraction;
    };
    for (int i = 0; i < 40; ++i) pulled(0, 0.1 * radius);
    int one_waits = 0;
    for (int i = 0; i < 12; ++i) {
        const double fraction = pulled(0.01 * radius, 0.1 * radius);
        EXPECT_EQ(fraction, std::min(thread.progress(0), thread.progress(1)));
        one_waits += thread.progress(0) - thread.progress(1) > 0.5;
    }
    EXPECT_GT(one_waits, 2);
}

// Follow-The-Leader has no forces: what a taut thread carries is what one of its stiffness would that is as much longer
// as a hand lags, 15.9 N times a hundredth here.
TEST(Tension, IsThatOfAThreadAsMuchLonger) {
    Thread thread({}, straight(20));
    const double length = 40 * radius;
    const Hold holds[] = {{0, Vec3::Zero()}, {20, Vec3(1.01 * length, 0, 0)}};
    const int owners[] = {-1, -1};
    for (int i = 0; i < 20; ++i) thread.tick({holds, owners, {}, nullptr});
    const double lag = 1.01 * length - thread.nodes()[20].x();
    EXPECT_GT(lag, 0.0095 * length) << "it does not stretch";
    for (const double tension : thread.tension()) EXPECT_NEAR(tension, 15.9 * lag / length, 0.001);
}

// Drawn tight, strands lie on each other and no nearer.
TEST(Report, OfAKnotThatIsTight) {
    for (const ThreadDef& def : {ThreadDef{}, elastic()}) {
        SCOPED_TRACE(def.elastic ? "elastic" : "ftl");
        Thread thread(def, overhand(120));
        Pull pull(thread);
        TickReport report;
        int most = 0, sweeps = 0;
        double over = 0, nearest = 1e300;
        for (int i = 0; i < 140; ++i) {
            report = pull.by(thread, 0.05e-3);
            most = std::max(most, report.contacts), sweeps = std::max(sweeps, report.sweeps);
            over = std::max(over, report.step_over_bound), nearest = std::min(nearest, report.separation_min);
        }
        EXPECT_GT(most, 5);
        EXPECT_EQ(sweeps > 0, def.elastic.has_value());
        EXPECT_LE(over, 1 + 1e-12) << "rounding";
        EXPECT_GT(over, 0.2);
        EXPECT_GT(nearest, 0.99);
        EXPECT_LT(nearest, 1.1);
    }
}

// A wall that leaps, untold, to just in front of a moving thread, is passed by the first of the tick's steps. Nothing
// else may pass: what the audit finds in any step must come out in the report.
TEST(Report, CountsWhatPassesInAnyStepOfATick) {
    for (const ThreadDef& def : {ThreadDef{}, elastic()}) {
        SCOPED_TRACE(def.elastic ? "elastic" : "ftl");
        const auto wall_at = [](double y) {
            return std::vector<sim::geometry::Triangle>{{Vec3(-1, y, -1), Vec3(1, y, -1), Vec3(-1, y, 1)},
                                                        {Vec3(1, y, -1), Vec3(1, y, 1), Vec3(-1, y, 1)}};
        };
        TriangleTree wall(wall_at(1));
        Thread thread(def, straight(20));
        EXPECT_EQ(led(thread, Vec3::Zero(), &wall).pass_throughs, 0);
        wall.move(wall_at(0.3 * radius));
        const TickReport report = led(thread, Vec3(0, 6 * radius, 0), &wall);
        EXPECT_GT(report.substeps, 1);
        EXPECT_GE(report.pass_throughs, 1);
    }
}

double gap(const State& state, std::size_t i, std::size_t j) {
    return std::sqrt(
        sim::geometry::closest_points(state.nodes[i], state.nodes[i + 1], state.nodes[j], state.nodes[j + 1])
            .distance_squared);
}

// Two strands that cross, six tenths of a thickness of air between them, the one or the other first along the thread:
// none of the four nodes of any pair may go farther than its share of the gap, 0.45, and the nearest pair may use it.
TEST(Bounds, OfAllFourNodesAreTheirShareOfTheGap) {
    for (const bool other_first : {false, true}) {
        std::vector<Vec3> nodes;
        for (int i = -10; i <= 10; ++i) nodes.emplace_back(2 * radius * i, 0.1 * radius, 0);
        for (int i = 1; i <= 12; ++i) nodes.push_back(nodes[20] + i * radius * Vec3(1, 0, 1));
        for (int i = -10; i <= 10; ++i) nodes.emplace_back(0.3 * radius, 2 * radius * i, 3.2 * radius);
        if (other_first) std::reverse(nodes.begin(), nodes.end());
        State state({}, nodes);
        Detection(static_cast<std::size_t>(state.links())).look_around(state, 0);
        sim::thread::contact::measure_gaps(state, 1);
        double nearest = 1;
        std::array<std::size_t, 4> nearest_nodes{};
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
            for (std::size_t j = i + 10; j + 1 < nodes.size(); ++j) {
                const double most = 0.45 * gap(state, i, j);
                for (const std::size_t node : {i, i + 1, j, j + 1})
                    ASSERT_LE(state.bound[node], most * (1 + 1e-12)) << i << ' ' << j << ' ' << node;
                if (most < nearest) nearest = most, nearest_nodes = {i, i + 1, j, j + 1};
            }
        EXPECT_NEAR(nearest, 0.45 * 3.2 * radius, 0.01 * radius);
        for (const std::size_t node : nearest_nodes) EXPECT_NEAR(state.bound[node], nearest, 1e-9 * radius);
    }
}

// Coulomb's cone: friction takes what is wanted against a slip while that is less than the coefficient times the push,
// and exactly so much where it is more.
TEST(Friction, TakesWhatIsWantedUpToCoulombsLimit) {
    sim::thread::contact::Row row{};
    row.friction = 0.15, row.normal_push = 2;
    const Vec3 little(0.29, 0, 0), more(0.4, 0.3, 0);
    EXPECT_LT((sim::thread::ftl::add_tangent_push(row, -little, little) - little).norm(), 1e-15);
    EXPECT_EQ(row.tangent_push, little);
    row.tangent_push.setZero();
    sim::thread::ftl::add_tangent_push(row, -more, more);
    EXPECT_LT((row.tangent_push - 0.3 * more.normalized()).norm(), 1e-15);
    row.normal_push = 0;
    sim::thread::ftl::add_tangent_push(row, Vec3::Zero(), Vec3::Zero());
    EXPECT_EQ(row.tangent_push.norm(), 0) << "what does not press does not rub";
}

// Thread on thread and on walls by the one coefficient, on tools by the other.
TEST(Friction, IsThatOfWhatIsTouched) {
    std::vector<Vec3> nodes;
    for (int i = -10; i <= 10; ++i) nodes.emplace_back(2 * radius * i, 0.1 * radius, 0);
    for (int i = 1; i <= 12; ++i) nodes.push_back(nodes[20] + i * radius * Vec3(1, 0, 1));
    for (int i = -10; i <= 10; ++i) nodes.emplace_back(0.3 * radius, 2 * radius * i, 2.1 * radius);
    State state({.friction = 0.21, .friction_tool = 0.34}, nodes);
    const TriangleTree floor({{Vec3(-1, -1, -1.1 * radius), Vec3(1, -1, -1.1 * radius), Vec3(0, 1, -1.1 * radius)}});
    state.input.surface = &floor;
    const sim::geometry::Capsule tool{Vec3(-8 * radius, 0, 2.1 * radius), Vec3(-8 * radius, 0, 1), radius};
    const sim::thread::MovingCapsule tools[] = {{tool, tool, 0}};
    state.input.capsules = tools;
    state.capsules = {tool};
    Detection(static_cast<std::size_t>(state.links())).look_around(state, 0);
    sim::thread::contact::measure_gaps(state, radius);
    std::array<int, 3> found{};
    for (const sim::thread::contact::Row& row : state.rows) {
        ++found[static_cast<std::size_t>(row.against)];
        EXPECT_EQ(row.friction, row.against == sim::thread::contact::Against::capsule ? 0.34 : 0.21);
    }
    for (const int rows : found) EXPECT_GT(rows, 0);
}

// 6-0 polypropylene: 0.085 mm thick, the middle of USP's 0.070 to 0.099; 905 kg/m^3; other sources stand in
// rod_def.hpp.
TEST(Sizes, OfAThreadOfWhichNothingIsSaid) {
    const ThreadDef thread;
    EXPECT_EQ(thread.radius, 0.0425e-3);
    EXPECT_EQ(thread.friction, 0.15);
    EXPECT_EQ(thread.friction_tool, 0.15);
    EXPECT_EQ(thread.axial_stiffness, 15.9);
    EXPECT_EQ(thread.shortest_link, 0);
    EXPECT_EQ(thread.contacts_per_tick, 0);
    const RodDef rod;
    EXPECT_EQ(rod.radius, 0.0425e-3);
    EXPECT_EQ(rod.young, 2.8e9);
    EXPECT_EQ(rod.bending_share, 1);
    EXPECT_EQ(rod.poisson, 0.5);
    EXPECT_EQ(rod.friction, 0.15);
    EXPECT_EQ(rod.density, 905);
    EXPECT_EQ(rod.axial_over_bending, 1e4);
    EXPECT_EQ(rod.yield_strain, 0);
    EXPECT_EQ(rod.halting_time, 0);
    EXPECT_EQ(rod.most_strain, 0.1);
    EXPECT_NEAR(2.8e9 * 5.6745e-9, thread.axial_stiffness, 0.02) << "pi r^2 is 5.6745e-9 m^2";
}

// By the book: pi r^4 / 4 times Young's modulus, two thirds of that for twist at Poisson's ratio of one half, weight by
// section, and a tenth of what its material pulls with at a strain of one.
TEST(Sizes, OfWhatARodBearsAreThoseOfARoundSection) {
    const RodDef rod;
    EXPECT_NEAR(rod.bending_stiffness(), 7.1745e-9, 1e-12);
    EXPECT_NEAR(rod.twisting_stiffness(), 4.7831e-9, 1e-12);
    EXPECT_NEAR(rod.mass_per_length(), 5.1354e-6, 1e-9);
    EXPECT_NEAR(rod.most_pull(), 1.5889, 1e-3);
    EXPECT_NEAR(rod.contact_stiffness(0.1e-3), 10 * rod.axial_stiffness(0.1e-3) / 0.085e-3, 1e-3);
    EXPECT_NEAR(rod.axial_stiffness(0.1e-3), 1e4 * 7.1747e-9 / 1e-8, 1) << "practically inextensible";
    RodDef yields = rod;
    yields.yield_strain = 0.03;
    EXPECT_NEAR(yields.yield_curvature() * rod.radius / 0.03, 16 / (3 * 3.14159265358979), 1e-6);
}

}  // namespace reports
