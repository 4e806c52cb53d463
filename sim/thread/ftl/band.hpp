#pragma once
#include <cstddef>
#include <vector>

namespace sim::thread::ftl {

/// A square matrix that is zero in each row but for a stretch of columns about the diagonal; neither end of it ever
/// moves left from row to row. Solved directly and without pivots, in time that grows with the rows times the square of
/// their widths.
class Band {
  public:
    /// Takes all rows away; the room stays.
    void clear();
    /// Makes room for so many rows of a thread's lengths and contacts, so that adding them allocates nothing.
    void reserve(std::size_t rows);
    /// Adds a row with room in columns `first` to `end` - 1, all zero.
    void add_row(std::size_t first, std::size_t end);

    /// The first column that a row has room in.
    std::size_t first(std::size_t row) const { return rows_[row].first; }
    /// The first column past those that a row has room in.
    std::size_t end(std::size_t row) const { return rows_[row].end; }
    /// The number at a row and a column, which must be one that the row has room in.
    double& operator()(std::size_t row, std::size_t column) {
        return entries_[rows_[row].offset + column - rows_[row].first];
    }

    /// x = A^-1 x, which overwrites the matrix. None of its leading minors may be zero.
    void solve(std::vector<double>& x);

  private:
    struct Stretch {
        std::size_t first, end, offset;
    };
    std::vector<Stretch> rows_;
    std::vector<double> entries_;
};

}  // namespace sim::thread::ftl
