#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

/// The little of SQLite that the store needs, with its errors as CityError. Internal to store*.cpp.
namespace vicus {

class Statement;

class Database {
 public:
  /// A new file for one bulk load: no journal, no sync; whoever creates it syncs and renames it.
  /// Needs   no file at `path`. `shown` is the path that messages name.
  static Database create(const std::filesystem::path& path, const std::filesystem::path& shown);
  /// A finished, possibly hostile file: read-only, immutable, defensive, memory-mapped.
  /// Fails   CityError: no such file, a directory, no SQLite, no GeoPackage.
  static Database open_immutable(const std::filesystem::path& path);

  void execute(const std::string& sql);
  Statement prepare(const std::string& sql) const;
  /// Closes and reports what closing finds; the destructor closes silently.
  void close();

  /// Throws CityError: "PATH is damaged: WHAT ...".
  [[noreturn]] void throw_damaged(const std::string& what) const;

 private:
  friend class Statement;
  struct Close {
    void operator()(sqlite3* db) const;
  };
  Database(sqlite3* db, std::filesystem::path shown, bool is_writing);
  [[noreturn]] void throw_error() const;

  std::unique_ptr<sqlite3, Close> db_;
  std::filesystem::path shown_;
  bool is_writing_ = false;
};

/// A prepared statement. Parameters and columns count from 0.
/// Needs   outlived by its Database, which stays where it is.
class Statement {
 public:
  void bind(int i, std::string_view text);
  void bind_or_null(int i, std::string_view text);  ///< NULL for ""
  void bind_blob(int i, std::string_view bytes);
  void bind(int i, std::int64_t value);
  void bind(int i, double value);  ///< Needs a finite value.
  /// true: a row is there.
  bool step();
  void reset();
  /// step, which must give no row, and reset.
  void run();

  std::string_view bytes(int i) const;  ///< text or blob; valid until the next step
  std::string text(int i) const { return std::string(bytes(i)); }
  std::int64_t integer(int i) const;
  double real(int i) const;  ///< Fails  CityError: not finite.
  const Database& database() const { return *db_; }

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  Statement(const Database& db, sqlite3_stmt* statement) : db_(&db), statement_(statement) {}
  void check(int rc) const;

  const Database* db_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

}  // namespace vicus
