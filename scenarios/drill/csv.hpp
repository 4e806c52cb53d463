#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenarios::drill {

/// Reads the rows of a .csv with a known header, one after another, and says where one is wrong.
///
/// Form:       commas between cells, blanks around them left out; a cell may stand in quotes (RFC 4180). '#' starts a
///             comment line, empty lines are skipped, lines end in "\n" or "\r\n", a byte order mark is skipped.
/// Columns:    those of the header that is asked for come first; further ones are left alone, but every row has as many
///             cells as its header.
/// Errors:     each throws FileError "file:line:column: error: column's name: what is wrong, what would be right".
class CsvReader {
  public:
    /// `text` and `columns`, the names that the header must have, outlive the reader; `name` is the file's, for
    /// messages. Throws FileError on another header.
    CsvReader(std::string_view text, std::string name, std::span<const char* const> columns);

    /// Goes to the next row; false after the last. Throws FileError on a wrong number of cells.
    bool next();

    /// A cell of this row without blanks and quotes; `column` from 0.
    std::string_view cell(std::size_t column) const { return cells_[column].text; }

    /// The same between quotes, cut to 40 characters, for a message.
    std::string quoted(std::size_t column) const;

    /// A cell as a number within [low, high]; `unit` such as " mm" is for the message.
    double number(std::size_t column, double low, double high, const char* unit) const;

    /// Throws FileError that points at a cell of this row.
    [[noreturn]] void fail(std::size_t column, const std::string& what) const;

  private:
    struct Cell {
        std::string_view text;
        std::size_t start;  ///< Column of the first character, from 1.
    };

    std::string_view take_line();
    void split(std::string_view line);
    [[noreturn]] void fail_line(const std::string& what) const;

    std::string_view rest_;
    std::string name_;
    std::span<const char* const> columns_;
    std::vector<Cell> cells_;
    std::size_t width_ = 0;  ///< Cells of the header.
    int line_ = 0;
};

}  // namespace scenarios::drill
