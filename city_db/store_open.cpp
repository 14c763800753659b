#include "city_db/store_open.hpp"

#include <charconv>
#include <cmath>

#include "city_db/store_schema.hpp"

namespace vicus {
namespace {

template <class Number>
bool parse_whole(const std::string& text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end;
}

bool has_table(const Database& db, const std::string& name) {
  // A virtual table under our name would run its module's code on foreign data.
  auto row = db.prepare("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?1 AND sql LIKE 'CREATE TABLE%'");
  row.bind(0, name);
  return row.step();
}

void check_version(const Database& db, const std::filesystem::path& path) {
  auto row = db.prepare("SELECT value FROM meta WHERE key = 'format_version'");
  const std::string found = row.step() ? row.text(0) : "none";
  int version = 0;
  if (!parse_whole(found, version))
    throw CityError(path.string() + " is a GeoPackage but no Vicus city: expected format_version " +
                    std::to_string(kFormatVersion) + " in its table meta, found " + found.substr(0, 40));
  const std::string both = ": expected format version " + std::to_string(kFormatVersion) + ", found " + found;
  if (version > kFormatVersion)
    throw OtherVersionError(path.string() + " was made by a newer vicus" + both +
                            "; use that, or build the city again");
  if (version < kFormatVersion)
    throw OtherVersionError(path.string() + " was made by an older vicus" + both + "; build the city again");
}

}  // namespace

Database open_city(const std::filesystem::path& path) {
  auto db = Database::open_immutable(path);
  if (!has_table(db, "meta"))
    throw CityError(path.string() +
                    " is a GeoPackage but no Vicus city: expected a table meta, found none; vicus build makes a city "
                    "from a map");
  check_version(db, path);
  for (const auto& table : tables()) {
    if (!has_table(db, table.name)) db.throw_damaged(std::string("no table ") + table.name);
    (void)db.prepare(select_sql(table, "LIMIT 0"));  // names every column
  }
  return db;
}

std::map<std::string, std::string> read_meta(const Database& db) {
  std::map<std::string, std::string> meta;
  auto row = db.prepare("SELECT key, value FROM meta");
  while (row.step()) meta[row.text(0)] = row.text(1);
  return meta;
}

LatLon origin_from_meta(const Database& db, const std::map<std::string, std::string>& meta) {
  const auto degrees = [&](const char* key, double limit) {
    const auto at = meta.find(key);
    double value = 0;
    if (at == meta.end() || !parse_whole(at->second, value) || !(std::abs(value) <= limit))
      db.throw_damaged(std::string("meta ") + key + " is no angle");
    return value;
  };
  return {degrees("origin_lat", 90), degrees("origin_lon", 180)};
}

bool is_own_key(const std::string& key) {
  return key == "format_version" || key == "origin_lat" || key == "origin_lon" || key.starts_with("count_");
}

}  // namespace vicus
