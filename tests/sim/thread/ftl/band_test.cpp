#include "sim/thread/ftl/band.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace {

using sim::thread::ftl::Band;

// What elimination fills beyond a row's stretch would be lost, and the answer wrong by a little: every length and push
// along a wrap would be. Stretches of all widths, unsymmetric, against a dense solve.
TEST(Band, SolvesWhatADenseMatrixDoes) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const std::size_t n : {1UL, 2UL, 7UL, 40UL}) {
        Band band;
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
        for (std::size_t i = 0, first = 0, end = 0; i < n; ++i) {
            first = std::max(first, std::min(i, i / 2 + random() % 3 * i / 4));
            end = std::min(n, std::max(end, i + 1 + random() % 4));
            band.add_row(first, end);
            for (std::size_t j = first; j < end; ++j) {
                band(i, j) = number(random) + (i == j ? 40 : 0);
                dense(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = band(i, j);
            }
        }
        std::vector<double> x(n);
        for (double& value : x) value = number(random);
        const Eigen::VectorXd expected =
            dense.partialPivLu().solve(Eigen::Map<Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(n)));
        band.solve(x);
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_NEAR(x[i], expected[static_cast<Eigen::Index>(i)], 1e-14) << n << ' ' << i;
    }
}

}  // namespace
