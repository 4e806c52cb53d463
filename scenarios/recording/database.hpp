#pragma once
#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

// The few calls of SQLite that recordings need. Written on the C interface because reading a damaged file goes on after
// errors, and because values are bound bit for bit.
namespace scenarios::recording {

struct DatabaseError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// An open database file. Throws DatabaseError.
class Database {
  public:
    enum Mode { create, read };

    Database(const std::filesystem::path& file, Mode mode);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    sqlite3* handle() const { return handle_; }
    void run(const std::string& sql);

  private:
    sqlite3* handle_ = nullptr;
};

/// One prepared statement. Columns and parameters count from 0. Throws DatabaseError.
class Statement {
  public:
    Statement(Database& database, const char* sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    template <typename... Values>
    Statement& bind(const Values&... values) {
        int place = 0;
        (bind_one(++place, values), ...);
        return *this;
    }
    bool step();  ///< Whether there is a row to read.

    std::string text(int column) const;
    double real(int column) const { return sqlite3_column_double(handle_, column); }
    std::int64_t integer(int column) const { return sqlite3_column_int64(handle_, column); }
    std::vector<char> blob(int column) const;

  private:
    void bind_one(int place, const std::string& value);
    void bind_one(int place, double value);
    void bind_one(int place, std::int64_t value);
    void bind_one(int place, const std::vector<char>& value);

    sqlite3* database_;
    sqlite3_stmt* handle_ = nullptr;
};

/// Whether the file's first bytes say that it is a recording of any version.
bool is_recording(const std::filesystem::path& file);

}  // namespace scenarios::recording
