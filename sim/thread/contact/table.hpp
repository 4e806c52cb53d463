#pragma once
#include <Eigen/Core>
#include <vector>

namespace sim::thread::contact {

/// A matrix in a room that only grows, so that solving allocates nothing once it has grown.
class Table {
  public:
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /// Room for so many numbers, each `number` until written.
    void reserve(std::size_t numbers, double number) { room_.assign(numbers, number); }
    /// So many rows and columns of it, with whatever numbers were there.
    Eigen::Map<Matrix> resized(Eigen::Index rows, Eigen::Index columns) {
        if (room_.size() < static_cast<std::size_t>(rows * columns))
            room_.resize(static_cast<std::size_t>(rows * columns));
        return {room_.data(), rows, columns};
    }

    /// Its numbers, row by row.
    const double* data() const { return room_.data(); }

  private:
    std::vector<double> room_;
};

}  // namespace sim::thread::contact
