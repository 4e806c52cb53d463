#include "sim/thread/band.hpp"

#include <cmath>

namespace sim::thread {

namespace {

// L of pivot = L L^T; false when it is not positive definite. An inverse instead would lose the soft directions of a rod, a
// millionth as stiff as the links.
bool root_of(Band::Block& pivot) {
    for (int j = 0; j < 3; ++j) {
        double square = pivot(j, j);
        for (int k = 0; k < j; ++k) square -= pivot(j, k) * pivot(j, k);
        if (!(square > 0)) return false;
        pivot(j, j) = std::sqrt(square);
        for (int i = j + 1; i < 3; ++i) {
            for (int k = 0; k < j; ++k) pivot(i, j) -= pivot(i, k) * pivot(j, k);
            pivot(i, j) /= pivot(j, j);
            pivot(j, i) = 0;
        }
    }
    return true;
}

// L^-1 x and L^-T x of one or several columns.
template <class Columns>
void divide(const Band::Block& root, Columns& x) {
    x.row(0) /= root(0, 0);
    x.row(1) = (x.row(1) - root(1, 0) * x.row(0)) / root(1, 1);
    x.row(2) = (x.row(2) - root(2, 0) * x.row(0) - root(2, 1) * x.row(1)) / root(2, 2);
}
void divide_by_transpose(const Band::Block& root, Band::Vec3& x) {
    x[2] /= root(2, 2);
    x[1] = (x[1] - root(2, 1) * x[2]) / root(1, 1);
    x[0] = (x[0] - root(1, 0) * x[1] - root(2, 0) * x[2]) / root(0, 0);
}

}  // namespace

void Band::fix(std::size_t i) {
    diagonal_[i].setIdentity();
    next_[i].setZero();
    second_[i].setZero();
    if (i >= 1) next_[i - 1].setZero();
    if (i >= 2) second_[i - 2].setZero();
}

bool Band::factor() {
    const std::size_t n = diagonal_.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (!root_of(diagonal_[i])) return false;
        divide(diagonal_[i], next_[i]);
        divide(diagonal_[i], second_[i]);
        if (i + 1 < n) diagonal_[i + 1].noalias() -= next_[i].transpose() * next_[i];
        if (i + 1 < n) next_[i + 1].noalias() -= next_[i].transpose() * second_[i];
        if (i + 2 < n) diagonal_[i + 2].noalias() -= second_[i].transpose() * second_[i];
    }
    return true;
}

void Band::solve(std::vector<Vec3>& x) const {
    const std::size_t n = diagonal_.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (i >= 1) x[i].noalias() -= next_[i - 1].transpose() * x[i - 1];
        if (i >= 2) x[i].noalias() -= second_[i - 2].transpose() * x[i - 2];
        divide(diagonal_[i], x[i]);
    }
    for (std::size_t i = n; i-- > 0;) {
        if (i + 1 < n) x[i].noalias() -= next_[i] * x[i + 1];
        if (i + 2 < n) x[i].noalias() -= second_[i] * x[i + 2];
        divide_by_transpose(diagonal_[i], x[i]);
    }
}

}  // namespace sim::thread
