#include "tissue/block_matrix.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cstring>
#include <random>

#include "tissue/descent.hpp"

namespace {

using namespace tissue;

// A grid of nodes, each coupled with its neighbours and with one far off, and the same matrix dense.
struct Twice {
    static constexpr int side = 6, nodes = side * side;

    explicit Twice(double lift)
        : couplings(pairs()), matrix(nodes, couplings), dense(Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes)) {
        fill(lift);
    }

    static std::vector<std::array<int, 2>> pairs() {
        std::vector<std::array<int, 2>> found{{0, nodes - 1}};
        for (int i = 0; i < nodes; ++i) {
            if (i % side > 0) found.push_back({i, i - 1});
            if (i >= side) found.push_back({i - side, i});
        }
        return found;
    }

    void fill(double lift) {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> any(-1, 1);
        matrix.clear();
        for (const auto& [i, j] : couplings) {
            const Eigen::Matrix3d block = Eigen::Matrix3d::NullaryExpr([&] { return any(random); });
            matrix.add(matrix.place(i, j), block);
            dense.block<3, 3>(3 * i, 3 * j) = block, dense.block<3, 3>(3 * j, 3 * i) = block.transpose();
        }
        for (int i = 0; i < nodes; ++i) matrix.add_diagonal(matrix.place(i, i), lift * Vec3(1, 1.1, 1.2));
        for (int i = 0; i < nodes; ++i) dense.diagonal().segment<3>(3 * i) = lift * Vec3(1, 1.1, 1.2);
    }

    std::vector<std::array<int, 2>> couplings;
    BlockMatrix matrix;
    Eigen::MatrixXd dense;
};

std::vector<Vec3> solved(Twice& twice, long work) {
    while (!twice.matrix.factor(work)) {
    }
    EXPECT_TRUE(twice.matrix.is_positive());
    twice.matrix.use();
    std::vector<Vec3> x;
    for (int i = 0; i < Twice::nodes; ++i) x.push_back(Vec3(i, 1 - i, i % 5));
    twice.matrix.solve(x);
    return x;
}

// Factors are kept to 24 bits: what that changes grows by at most the matrix's condition.
TEST(BlockMatrix, SolvesAsADenseOne) {
    Twice twice(10);
    const std::vector<Vec3> x = solved(twice, twice.matrix.work());
    Eigen::VectorXd right(3 * Twice::nodes);
    for (int i = 0; i < Twice::nodes; ++i) right.segment<3>(3 * i) = Vec3(i, 1 - i, i % 5);
    const Eigen::VectorXd expected = twice.dense.llt().solve(right);
    const Eigen::VectorXd stiffness =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(twice.dense, Eigen::EigenvaluesOnly).eigenvalues();
    const double rounding = std::numeric_limits<float>::epsilon() * stiffness.maxCoeff() / stiffness.minCoeff();
    for (int i = 0; i < Twice::nodes; ++i)
        EXPECT_LE((x[static_cast<std::size_t>(i)] - expected.segment<3>(3 * i)).norm(), rounding * expected.norm());
}

TEST(BlockMatrix, GivesTheSameBitsInSlices) {
    Twice at_once(10), in_slices(10);
    const std::vector<Vec3> a = solved(at_once, at_once.matrix.work()), b = solved(in_slices, 1);
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)), 0);
}

TEST(BlockMatrix, SaysWhenItIsNotPositive) {
    Twice twice(0.5);
    EXPECT_LT(twice.dense.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0);
    while (!twice.matrix.factor(100)) {
    }
    EXPECT_FALSE(twice.matrix.is_positive());
}

TEST(Descent, GoesToTheLowestPoint) {
    EXPECT_NEAR(lowest({-2, 1}), 1, 1e-9);                    // (s - 1)^2
    EXPECT_NEAR(lowest({-1, 0, 0, 0, 0, 1.0 / 6}), 1, 1e-9);  // s^6 / 6 - s
    EXPECT_EQ(lowest({1, 1}), 0);                             // uphill
    EXPECT_EQ(lowest({-1}), 4);                               // for ever: as far as it goes
    const double past = lowest({-0.01, 10, -60, 100});        // a dip, then a hill and a second one
    EXPECT_GT(past, 0);
    EXPECT_LT(past * (-0.01 + past * (10 + past * (-60 + past * 100))), 0);
}

}  // namespace
