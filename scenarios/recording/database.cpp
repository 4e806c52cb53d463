#include "scenarios/recording/database.hpp"

#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "scenarios/recording/format.hpp"

namespace scenarios::recording {

namespace {

void check(sqlite3* database, int result) {
    if (result != SQLITE_OK && result != SQLITE_ROW && result != SQLITE_DONE)
        throw DatabaseError(sqlite3_errmsg(database));
}

}  // namespace

Database::Database(const std::filesystem::path& file, Mode mode) {
    try {
        open(file, mode == create ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY);
        if (mode == read && needs_rollback()) open_copy(file);
    } catch (const DatabaseError&) {
        close();
        throw;
    }
}

Database::~Database() {
    close();
}

void Database::open(const std::filesystem::path& file, int flags) {
    const int result = sqlite3_open_v2(file.c_str(), &handle_, flags, nullptr);
    // Somebody may look into a recording while it grows: reader and writer wait for each other rather than fail.
    if (result == SQLITE_OK) sqlite3_busy_timeout(handle_, 5000);
    // Without this a file that lacks its last page is refused as a whole.
    if (result == SQLITE_OK) sqlite3_db_config(handle_, SQLITE_DBCONFIG_WRITABLE_SCHEMA, 1, nullptr);
    if (result != SQLITE_OK) throw DatabaseError(sqlite3_errmsg(handle_));
}

void Database::close() {
    sqlite3_close(handle_);
    handle_ = nullptr;
    std::error_code ignored;
    if (!copy_.empty()) std::filesystem::remove_all(copy_, ignored);
}

// A kill in the middle of a commit leaves a journal that only who may write can take back.
bool Database::needs_rollback() {
    const int result = sqlite3_exec(handle_, "SELECT count(*) FROM sqlite_master", nullptr, nullptr, nullptr);
    return result == SQLITE_READONLY || result == SQLITE_CANTOPEN;
}

void Database::open_copy(const std::filesystem::path& file) {
    sqlite3_close(handle_);
    handle_ = nullptr;
    std::string folder = (std::filesystem::temp_directory_path() / "carrel-read-XXXXXX").string();
    if (!mkdtemp(folder.data())) throw DatabaseError("no room for a copy in " + folder);
    copy_ = folder;
    std::error_code error;
    for (const char* ending : {"", "-journal"})
        if (!error) std::filesystem::copy_file(file.string() + ending, copy_ / ("copy" + std::string(ending)), error);
    if (error) throw DatabaseError("cannot be copied: " + error.message());
    std::filesystem::permissions(copy_ / "copy", std::filesystem::perms::owner_all, error);
    std::filesystem::permissions(copy_ / "copy-journal", std::filesystem::perms::owner_all, error);
    open(copy_ / "copy", SQLITE_OPEN_READWRITE);
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

std::optional<double> Statement::real_or_none(int column) const {
    if (sqlite3_column_type(handle_, column) == SQLITE_NULL) return {};
    return real(column);
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
void Statement::bind_one(int place, const std::optional<double>& value) {
    check(database_, value ? sqlite3_bind_double(handle_, place, *value) : sqlite3_bind_null(handle_, place));
}
void Statement::bind_one(int place, std::int64_t value) {
    check(database_, sqlite3_bind_int64(handle_, place, value));
}
void Statement::bind_one(int place, const std::vector<char>& value) {
    check(database_, sqlite3_bind_blob(handle_, place, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT));
}

namespace {

// The first bytes of SQLite's file header: its name in the first 16, numbers big-endian behind.
using Header = std::array<unsigned char, 100>;

std::optional<Header> header_of(const std::filesystem::path& file) {
    Header header{};
    std::ifstream stream(file, std::ios::binary);
    stream.read(reinterpret_cast<char*>(header.data()), header.size());
    if (stream.gcount() < 72) return {};
    return header;
}

std::uint32_t number_at(const Header& header, std::size_t at, std::size_t bytes) {
    std::uint32_t number = 0;
    for (std::size_t i = at; i < at + bytes; ++i) number = number << 8 | header[i];
    return number;
}

}  // namespace

bool is_recording(const std::filesystem::path& file) {
    const auto header = header_of(file);
    return header && std::memcmp(header->data(), "SQLite format 3", 15) == 0 &&
           number_at(*header, 68, 4) == static_cast<std::uint32_t>(application_id);
}

std::uintmax_t missing_bytes(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    const auto header = header_of(file);
    if (error || !header || std::filesystem::exists(file.string() + "-journal", error)) return 0;
    if (number_at(*header, 24, 4) != number_at(*header, 92, 4)) return 0;  // written by an SQLite that keeps no length
    const std::uintmax_t page = number_at(*header, 16, 2) == 1 ? 65536 : number_at(*header, 16, 2);
    const std::uintmax_t whole = page * number_at(*header, 28, 4);
    return whole > size ? whole - size : 0;
}

}  // namespace scenarios::recording
