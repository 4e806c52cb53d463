#include "scenarios/recording/database.hpp"

#include <array>
#include <fstream>
#include <string_view>

#include "scenarios/recording/format.hpp"

namespace scenarios::recording {

namespace {

void check(sqlite3* database, int result) {
    if (result != SQLITE_OK && result != SQLITE_ROW && result != SQLITE_DONE)
        throw DatabaseError(sqlite3_errmsg(database));
}

}  // namespace

Database::Database(const std::filesystem::path& file, Mode mode) {
    // Reading opens for writing too when it may: after a kill in the middle of a commit SQLite first rolls that back.
    int result = sqlite3_open_v2(file.c_str(), &handle_,
                                 SQLITE_OPEN_READWRITE | (mode == create ? SQLITE_OPEN_CREATE : 0), nullptr);
    if (result != SQLITE_OK && mode == read) {
        sqlite3_close(handle_);
        result = sqlite3_open_v2(file.c_str(), &handle_, SQLITE_OPEN_READONLY, nullptr);
    }
    // Somebody may look into a recording while it grows: reader and writer wait for each other rather than fail.
    if (result == SQLITE_OK) result = sqlite3_busy_timeout(handle_, 5000);
    if (result == SQLITE_OK) return;
    const std::string what = sqlite3_errmsg(handle_);
    sqlite3_close(handle_);
    throw DatabaseError(what);
}

Database::~Database() {
    sqlite3_close(handle_);
}

void Database::run(const std::string& sql) {
    check(handle_, sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr));
}

Statement::Statement(Database& database, const char* sql) : database_(database.handle()) {
    check(database_, sqlite3_prepare_v2(database_, sql, -1, &handle_, nullptr));
}

Statement::~Statement() {
    sqlite3_finalize(handle_);
}

bool Statement::step() {
    const int result = sqlite3_step(handle_);
    check(database_, result);
    return result == SQLITE_ROW;
}

std::string Statement::text(int column) const {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
    return bytes ? std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column))) : std::string();
}

std::vector<char> Statement::blob(int column) const {
    const auto* bytes = static_cast<const char*>(sqlite3_column_blob(handle_, column));
    return bytes ? std::vector<char>(bytes, bytes + sqlite3_column_bytes(handle_, column)) : std::vector<char>();
}

void Statement::bind_one(int place, const std::string& value) {
    check(database_, sqlite3_bind_text(handle_, place, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT));
}
void Statement::bind_one(int place, double value) {
    check(database_, sqlite3_bind_double(handle_, place, value));
}
void Statement::bind_one(int place, std::int64_t value) {
    check(database_, sqlite3_bind_int64(handle_, place, value));
}
void Statement::bind_one(int place, const std::vector<char>& value) {
    check(database_, sqlite3_bind_blob(handle_, place, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT));
}

// SQLite's file header: its name in the first 16 bytes, the application id big-endian at 68.
bool is_recording(const std::filesystem::path& file) {
    std::array<char, 72> header{};
    std::ifstream stream(file, std::ios::binary);
    if (!stream.read(header.data(), header.size())) return false;
    std::int32_t id = 0;
    for (int i = 68; i < 72; ++i) id = id << 8 | static_cast<unsigned char>(header[static_cast<std::size_t>(i)]);
    return std::string_view(header.data(), 15) == "SQLite format 3" && id == application_id;
}

}  // namespace scenarios::recording
