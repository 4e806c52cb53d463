#pragma once
#include <cstddef>
#include <vector>

namespace sim::thread::ftl {

/// A square matrix that is zero in each row but for a stretch of columns about the diagonal; neither end of it ever
/// moves left from row to row. Solved directly and without pivots, in time that grows with the rows times the square of
/// their widths.
class Band {
  public:
    void clear();
    void reserve(std::size_t rows);
    /// One row more, of columns `first` to `end` - 1, all zero.
    void add_row(std::size_t first, std::size_t end);

    std::size_t first(std::size_t row) const { return rows_[row].first; }
    std::size_t end(std::size_t row) const { return rows_[row].end; }
    double& operator()(std::size_t row, std::size_t column) {
        return entries_[rows_[row].offset + column - rows_[row].first];
    }

    /// x = A^-1 x; the matrix is then no more what it was. None of its leading minors may be zero.
    void solve(std::vector<double>& x);

  private:
    struct Stretch {
        std::size_t first, end, offset;
    };
    std::vector<Stretch> rows_;
    std::vector<double> entries_;
};

}  // namespace sim::thread::ftl
