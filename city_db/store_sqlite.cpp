#include "city_db/store_sqlite.hpp"

#include <sqlite3.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <fstream>

#include "city_db/issues.hpp"

namespace vicus {
namespace {

constexpr std::string_view kSqliteMagic{"SQLite format 3\0", 16};
constexpr std::string_view kGpkgId{"GPKG", 4};
constexpr std::size_t kApplicationIdAt = 68;
constexpr std::size_t kSqliteHeaderBytes = 100;

/// A path as a file: URI, so that no '?', '#' or '%' in it is taken for syntax.
std::string uri_from_path(const std::filesystem::path& path) {
  constexpr char kHex[] = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || std::strchr("/-._~", c) != nullptr)
      uri += c;
    else
      uri += {'%', kHex[byte >> 4], kHex[byte & 15]};
  }
  return uri;
}

/// Refuses by name what is no GeoPackage, before SQLite sees it.
void check_header(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  const std::string name = path.string();
  if (status.type() == std::filesystem::file_type::not_found)
    throw CityError("cannot open " + name + ": no such file (vicus build makes one)");
  if (status.type() == std::filesystem::file_type::directory)
    throw CityError("cannot open " + name + ": it is a directory; expected a city file made by vicus build");
  std::array<char, kSqliteHeaderBytes> header{};
  std::ifstream file(path, std::ios::binary);
  if (!file) throw CityError("cannot open " + name + ": " + std::strerror(errno));
  file.read(header.data(), header.size());
  const std::string_view found(header.data(), static_cast<std::size_t>(file.gcount()));
  if (found.size() < header.size() || !found.starts_with(kSqliteMagic))
    throw CityError(name + " is no city: expected a GeoPackage made by vicus build, found a file of another kind");
  if (found.substr(kApplicationIdAt, 4) != kGpkgId)
    throw CityError(name + " is no city: expected a GeoPackage made by vicus build, found another SQLite database");
}

}  // namespace

void Database::Close::operator()(sqlite3* db) const { sqlite3_close_v2(db); }
void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Database::Database(sqlite3* db, std::filesystem::path shown, bool is_writing)
    : db_(db), shown_(std::move(shown)), is_writing_(is_writing) {}

Database Database::create(const std::filesystem::path& path, const std::filesystem::path& shown) {
  sqlite3* raw = nullptr;
  const int rc =
      sqlite3_open_v2(uri_from_path(path).c_str(), &raw,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  Database db(raw, shown, true);
  if (rc != SQLITE_OK) db.throw_error();
  // A broken load is thrown away whole, so nothing needs to be undone or safe before the end.
  db.execute(
      "PRAGMA page_size=16384; PRAGMA encoding='UTF-8'; PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF;"
      "PRAGMA locking_mode=EXCLUSIVE; PRAGMA temp_store=MEMORY; PRAGMA cache_size=-65536");
  return db;
}

Database Database::open_immutable(const std::filesystem::path& path) {
  check_header(path);
  sqlite3* raw = nullptr;
  const int rc = sqlite3_open_v2((uri_from_path(path) + "?mode=ro&immutable=1").c_str(), &raw,
                                 SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  Database db(raw, path, false);
  if (rc != SQLITE_OK) db.throw_error();
  // The file may come from anywhere: its schema must not run code nor make us write.
  sqlite3_db_config(raw, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0, nullptr);
  db.execute(
      "PRAGMA query_only=1; PRAGMA trusted_schema=0; PRAGMA cell_size_check=1; PRAGMA mmap_size=2147418112;"
      "PRAGMA temp_store=MEMORY");
  return db;
}

void Database::throw_damaged(const std::string& what) const {
  throw CityError(shown_.string() + " is damaged: " + what + "; build the city again");
}

void Database::throw_error() const {
  const std::string shown = shown_.string();
  if (db_ == nullptr) throw CityError("cannot open " + shown + ": out of memory");
  const int rc = sqlite3_errcode(db_.get());
  const int system_errno = sqlite3_system_errno(db_.get());
  std::string what = sqlite3_errmsg(db_.get());
  if (system_errno != 0) what += std::string(" (") + std::strerror(system_errno) + ")";
  if (!is_writing_) {
    if (rc == SQLITE_CANTOPEN || rc == SQLITE_NOMEM || rc == SQLITE_PERM)
      throw CityError("cannot open " + shown + ": " + what);
    throw_damaged(what);
  }
  if (rc == SQLITE_FULL || rc == SQLITE_IOERR)
    throw CityError("cannot write " + shown + ": " + what +
                    "; free space there or choose another place; an older city of this name is untouched");
  throw CityError("cannot write " + shown + ": " + what);
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(db_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) throw_error();
}

Statement Database::prepare(const std::string& sql) const {
  sqlite3_stmt* raw = nullptr;
  if (sqlite3_prepare_v2(db_.get(), sql.data(), static_cast<int>(sql.size()), &raw, nullptr) != SQLITE_OK)
    throw_error();
  return Statement(*this, raw);
}

void Database::close() {
  if (sqlite3_close(db_.get()) != SQLITE_OK) throw_error();
  (void)db_.release();
}

void Statement::check(int rc) const {
  if (rc != SQLITE_OK) db_->throw_error();
}

// SQLITE_TRANSIENT: callers bind temporaries.
void Statement::bind(int i, std::string_view text) {
  check(sqlite3_bind_text64(statement_.get(), i + 1, text.data() != nullptr ? text.data() : "", text.size(),
                            SQLITE_TRANSIENT, SQLITE_UTF8));
}
void Statement::bind_or_null(int i, std::string_view text) {
  text.empty() ? check(sqlite3_bind_null(statement_.get(), i + 1)) : bind(i, text);
}
void Statement::bind_blob(int i, std::string_view bytes) {
  check(sqlite3_bind_blob64(statement_.get(), i + 1, bytes.data() != nullptr ? bytes.data() : "", bytes.size(),
                            SQLITE_TRANSIENT));
}
void Statement::bind(int i, std::int64_t value) { check(sqlite3_bind_int64(statement_.get(), i + 1, value)); }
void Statement::bind(int i, double value) {
  assert(std::isfinite(value));
  check(sqlite3_bind_double(statement_.get(), i + 1, value));
}

bool Statement::step() {
  const int rc = sqlite3_step(statement_.get());
  if (rc != SQLITE_ROW && rc != SQLITE_DONE) db_->throw_error();
  return rc == SQLITE_ROW;
}

void Statement::reset() {
  sqlite3_reset(statement_.get());  // repeats the last step's error, which step has thrown
  sqlite3_clear_bindings(statement_.get());
}

void Statement::run() {
  [[maybe_unused]] const bool has_row = step();
  assert(!has_row);
  reset();
}

std::string_view Statement::bytes(int i) const {
  const void* data = sqlite3_column_blob(statement_.get(), i);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), i));
  if (data == nullptr) return {};
  return {static_cast<const char*>(data), size};
}

std::int64_t Statement::integer(int i) const { return sqlite3_column_int64(statement_.get(), i); }

double Statement::real(int i) const {
  const double value = sqlite3_column_double(statement_.get(), i);
  if (!std::isfinite(value)) db_->throw_damaged("a number that is not finite");
  return value;
}

}  // namespace vicus
