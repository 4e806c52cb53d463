#pragma once
#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

// The few calls of SQLite that recordings need. Written on the C interface because reading a damaged file goes on after
// errors, and because values are bound bit for bit.
namespace scenarios::recording {

/// What SQLite says of a file.
struct DatabaseError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// An open database file. Throws DatabaseError.
///
/// Reading never writes to the file nor beside it, and reads what is left of one that was cut off. Where a kill in the
/// middle of a commit left a journal, that is taken back in a copy, which goes with the object.
class Database {
  public:
    /// What a file is opened for.
    enum Mode {
        create,  ///< Writes a new file; a file that is there already is opened as it is.
        read,    ///< Reads a file that exists.
    };

    /// Opens `file`. Throws DatabaseError where that cannot be done.
    Database(const std::filesystem::path& file, Mode mode);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    /// SQLite's own handle, for what this class has no call for.
    sqlite3* handle() const { return handle_; }
    /// Runs statements that give no rows.
    void run(const std::string& sql);

  private:
    void open(const std::filesystem::path& file, int flags);
    void close();
    bool needs_rollback();
    void open_copy(const std::filesystem::path& file);

    sqlite3* handle_ = nullptr;
    std::filesystem::path copy_;  ///< Folder of the copy that is read instead; empty: none.
};

/// One prepared statement. Columns and parameters count from 0. Throws DatabaseError.
class Statement {
  public:
    /// Prepares one statement for a database that outlives it.
    Statement(Database& database, const char* sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    /// Sets the parameters to these values, in order.
    template <typename... Values>
    Statement& bind(const Values&... values) {
        int place = 0;
        (bind_one(++place, values), ...);
        return *this;
    }
    /// Goes to the next row; false after the last.
    bool step();

    /// A text of this row; "" for NULL.
    std::string text(int column) const;
    /// A number of this row; 0 for what is no number.
    double real(int column) const { return sqlite3_column_double(handle_, column); }
    /// A number of this row; none for NULL.
    std::optional<double> real_or_none(int column) const;
    /// A whole number of this row; 0 for what is no number.
    std::int64_t integer(int column) const { return sqlite3_column_int64(handle_, column); }
    /// The bytes of a blob of this row; empty for NULL.
    std::vector<char> blob(int column) const;

  private:
    void bind_one(int place, const std::string& value);
    void bind_one(int place, double value);
    void bind_one(int place, const std::optional<double>& value);
    void bind_one(int place, std::int64_t value);
    void bind_one(int place, const std::vector<char>& value);

    sqlite3* database_;
    sqlite3_stmt* handle_ = nullptr;
};

/// Whether the file's first bytes say that it is a recording of any version.
bool is_recording(const std::filesystem::path& file);

/// How many bytes the file is shorter than its first page says [bytes]; 0: it is whole. Of a recording.
std::uintmax_t missing_bytes(const std::filesystem::path& file);

}  // namespace scenarios::recording
