#pragma once
#include <Eigen/Core>
#include <vector>

namespace sim::thread::contact {

/// A matrix in a room that only grows, so that solving allocates nothing once it has grown.
class Table {
  public:
    /// A matrix of any size, row by row.
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /// Makes room for so many numbers, each `number` until written.
    void reserve(std::size_t numbers, double number) { room_.assign(numbers, number); }
    /// A matrix of so many rows and columns in that room, with whatever numbers were there.
    Eigen::Map<Matrix> resized(Eigen::Index rows, Eigen::Index columns) {
        if (room_.size() < static_cast<std::size_t>(rows * columns))
            room_.resize(static_cast<std::size_t>(rows * columns));
        return {room_.data(), rows, columns};
    }

    /// The room's numbers, row by row.
    const double* data() const { return room_.data(); }

  private:
    std::vector<double> room_;
};

}  // namespace sim::thread::contact
