#include "sim/rod/rod.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "tests/bench/lab/rod_capstan.hpp"
#include "tests/bench/lab/rod_cases.hpp"

namespace rods {

using namespace sim::rod;

std::vector<Vec3> straight(int links, double length) {
    std::vector<Vec3> nodes;
    for (int i = 0; i <= links; ++i) nodes.emplace_back(length * i / links, 0, 0);
    return nodes;
}

// A matrix a rod could have, of 17 nodes, beside the same one as Eigen knows it. The band is left out between node
// `cut_behind` and the next.
struct Twins {
    static constexpr int n = 17;

    Twins(std::mt19937& random, int cut_behind) {
        std::normal_distribution<double> normal;
        matrix.clear(n);
        for (int i = 0; i < n; ++i)
            for (int j = i; j < std::min(n, i + 3); ++j) {
                if (i <= cut_behind && j > cut_behind) continue;
                ChainMatrix::Block block;
                for (double& x : block.reshaped()) x = normal(random);
                if (i == j) block = (block * block.transpose() + 40 * ChainMatrix::Block::Identity()).eval();
                matrix.add(static_cast<std::size_t>(i), static_cast<std::size_t>(j), block);
                dense.block(3 * i, 3 * j, 3, 3) = block;
                dense.block(3 * j, 3 * i, 3, 3) = block.transpose();
            }
    }

    void lead_and_fix(int fixed) {
        const Vec3 there(1, 2, 3);
        std::vector<Vec3> led(n, Vec3::Zero());
        matrix.lead(static_cast<std::size_t>(fixed), there, led);
        for (int i = 0; i < n; ++i)
            if (i != fixed) {
                EXPECT_LT((led[static_cast<std::size_t>(i)] + dense.block(3 * i, 3 * fixed, 3, 3) * there).norm(),
                          1e-12);
            }
        matrix.fix(static_cast<std::size_t>(fixed));
        dense.middleRows(3 * fixed, 3).setZero(), dense.middleCols(3 * fixed, 3).setZero();
        dense.block(3 * fixed, 3 * fixed, 3, 3).setIdentity();
    }

    ChainMatrix matrix;
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * n, 3 * n);
};

void expect_same_solution(Twins& twins, const Eigen::MatrixXd& inverse, std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::vector<Vec3> x(Twins::n);
    Eigen::VectorXd right(3 * Twins::n);
    for (int i = 0; i < Twins::n; ++i)
        for (int c = 0; c < 3; ++c) right[3 * i + c] = x[static_cast<std::size_t>(i)][c] = normal(random);
    twins.matrix.solve(x);
    const Eigen::VectorXd expected = inverse * right;
    for (int i = 0; i < Twins::n; ++i)
        EXPECT_LT((x[static_cast<std::size_t>(i)] - expected.segment<3>(3 * i)).norm(), 1e-12);
}

void expect_same_inverse(Twins& twins, const Eigen::MatrixXd& inverse, const std::vector<int>& touching) {
    const auto size = static_cast<Eigen::Index>(3 * touching.size());
    Eigen::MatrixXd found(size, size);
    twins.matrix.inverse_at(touching, found.data());
    for (std::size_t a = 0; a < touching.size(); ++a)
        for (std::size_t b = 0; b < touching.size(); ++b)
            EXPECT_LT((found.block(3 * static_cast<int>(a), 3 * static_cast<int>(b), 3, 3) -
                       inverse.block(3 * touching[a], 3 * touching[b], 3, 3))
                          .norm(),
                      1e-12);
}

// Against Eigen's dense solver, with nodes that touch at the chain's ends, beside each other, one apart, all over, and
// more of them than go up the chain together; whole and cut, with what touches before, behind and on both sides.
TEST(ChainMatrix, SolvesAsADenseMatrixDoes) {
    constexpr int fixed = 14;
    const std::vector<std::vector<int>> touchings{{},
                                                  {0, 1},
                                                  {15, 16},
                                                  {0, 1, 15, 16},
                                                  {2, 3, 5, 6},
                                                  {3, 4, 9, 10, 11},
                                                  {0, 1, 2, 7, 8, 12, 13},
                                                  {0, 1, 3, 4, 5, 6, 7, 9, 10, 11, 12, 13, 15, 16}};
    std::mt19937 random(3);
    for (const int cut_behind : {-1, 4, 8, 11}) {
        for (const std::vector<int>& touching : touchings) {
            Twins twins(random, cut_behind);
            if (std::find(touching.begin(), touching.end(), fixed) == touching.end()) twins.lead_and_fix(fixed);
            ASSERT_TRUE(twins.matrix.factor());
            const Eigen::MatrixXd inverse = twins.dense.inverse();
            expect_same_solution(twins, inverse, random);
            expect_same_inverse(twins, inverse, touching);
        }
    }
}

TEST(ChainMatrix, SaysWhenItIsNotPositive) {
    ChainMatrix matrix;
    matrix.clear(2);
    matrix.add(0, 0, ChainMatrix::Block::Identity());
    matrix.add(1, 1, ChainMatrix::Block::Identity());
    matrix.add(0, 1, 1.01 * ChainMatrix::Block::Identity());
    EXPECT_FALSE(matrix.factor());
    EXPECT_TRUE(matrix.factor(0.02));
}

// Every closed form of `carrel bench accuracy`, at the resolution where it must hold. Chains that swing take long; one
// tick is enough here.
TEST(Rod, AgreesWithClosedForms) {
    for (const bench::lab::RodCase& c : bench::lab::rod_cases()) {
        if (c.id == "swing-250us") continue;
        EXPECT_LT(std::abs(c.at(c.bound_links).error()), c.bound) << c.what;
    }
}

// What holds pull with carries the weight, to what is left unbalanced at each node.
TEST(Rod, HoldsCarryItsWeight) {
    RodDef def{.gravity = {0, 0, -9.81}};
    const std::vector<Vec3> nodes = straight(50, 0.05);
    Rod rod(def, nodes);
    const Hold ends[] = {{0, nodes[0]}, {50, nodes[50] - Vec3(0.02, 0, 0)}};
    RodReport report;
    for (int i = 0; i < 50 && !(report = rod.step({ends}, 0, 50)).settled; ++i) {
    }
    ASSERT_TRUE(report.settled);
    const double weight = 9.81 * def.mass_per_length() * 0.05;
    EXPECT_NEAR(rod.hold_force(0).z() + rod.hold_force(50).z(), weight, 50 * report.residual + 1e-9 * weight);
}

// Stiffness against stretch over that against bending from 1e3 to 1e7, a tool that jerks one end about at 300 mm/s,
// ticks of 1 ms: every tick ends in balance, no link gives more than a rod so stiff does, and it comes to rest when the
// tool does.
TEST(Rod, SurvivesAnyStiffness) {
    for (const double ratio : {1e3, 1e5, 1e7}) {
        SCOPED_TRACE(ratio);
        const std::vector<Vec3> nodes = straight(100, 0.0085);
        Rod rod({.axial_over_bending = ratio, .gravity = {0, 0, -9.81}}, nodes);
        Vec3 end = nodes[100];
        double moved = 0;
        for (int tick = 0; tick < 300; ++tick) {
            if (tick < 100) end += 3e-4 * (tick / 10 % 2 == 0 ? Vec3(-1, 0.3, 0) : Vec3(0.8, 0, -0.3));
            const Vec3 before = rod.nodes()[50];
            const Hold holds[] = {{0, nodes[0]}, {100, end}};
            const RodReport report = rod.step({holds}, 1e-3);
            ASSERT_TRUE(report.settled) << tick << ", " << report.residual << " N left";
            moved = (rod.nodes()[50] - before).norm();
            // It never carries more than a hundredth of what bends a link by a radian; that stretches it by so little.
            for (int k = 0; k < 100; ++k)
                ASSERT_LT(std::abs(rod.tension(k)) / rod.def().axial_stiffness(8.5e-5), 0.01 / ratio) << tick;
        }
        EXPECT_LT(moved, 1e-3 * 4.25e-5);  // of its radius
    }
}

// The same tick gives the same bits, whatever was before in memory.
TEST(Rod, IsTheSameEveryTime) {
    const auto play = [] {
        const std::vector<Vec3> nodes = straight(40, 0.004);
        Rod rod({}, nodes);
        for (int tick = 1; tick <= 20; ++tick) {
            const Hold holds[] = {{0, nodes[0]}, {1, nodes[1]}, {40, nodes[40] - 1e-5 * tick * Vec3(1, -0.5, 0.2)}};
            rod.step({.holds = holds, .turn = 0.1 * tick}, 1e-3);
        }
        return std::vector<Vec3>(rod.nodes().begin(), rod.nodes().end());
    };
    EXPECT_EQ(play(), play());
}

// Euler and Eytelwein to the 5 % that links of 20 degrees may take, whatever the tick; 95 % of what slides is held for
// a second without creeping by a millionth of the thickness, 105 % is not.
TEST(Rod, SlidesOverACylinderAsACapstanDoes) {
    constexpr double pi = 3.14159265358979, degree = pi / 180;
    for (const auto& [friction, wrap, tick] :
         {std::tuple(0.1, pi / 2, 1e-3), std::tuple(0.3, 2 * pi, 4e-3), std::tuple(0.2, 4 * pi, 4e-3)})
        EXPECT_LT(std::abs(bench::lab::rod_capstan(friction, wrap, 20 * degree, tick).error()), 0.05)
            << friction << ' ' << wrap;
    EXPECT_LT(bench::lab::rod_slides(0.2, pi, 10 * degree, 0.95), 1e-6);
    EXPECT_GT(bench::lab::rod_slides(0.2, pi, 10 * degree, 1.05), 1);
}

// With contacts solved once a tick: in ticks of 4 ms normals that stay where the tick began drag by 7 % more, and at
// friction 0.3 corners of 20 degrees by 9 % less. Both halves of what is asked of a capstan would hide what is left, so
// less is asked for.
TEST(ElasticThread, SlidesOverACylinderAsACapstanDoes) {
    constexpr double pi = 3.14159265358979, degree = pi / 180;
    for (const auto& [friction, tick] : {std::tuple(0.1, 4e-3), std::tuple(0.3, 1e-3), std::tuple(0.3, 4e-3)})
        EXPECT_LT(std::abs(bench::lab::elastic_capstan(friction, 4 * pi, 20 * degree, tick).error()), 0.03)
            << friction << ' ' << tick;
}

}  // namespace rods
