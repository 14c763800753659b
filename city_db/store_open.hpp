#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "city_db/city.hpp"
#include "city_db/store_sqlite.hpp"

/// Opening a city that may come from anywhere. Internal to store*.cpp.
namespace vicus {

/// Fails   CityError: no GeoPackage, no Vicus city, other format version, a table missing or of another kind.
Database open_city(const std::filesystem::path& path);

/// Every key of `meta`.
std::map<std::string, std::string> read_meta(const Database& db);
/// origin_lat and origin_lon.
LatLon origin_from_meta(const Database& db, const std::map<std::string, std::string>& meta);
/// Keys that the store itself writes and City::meta does not hold: format_version, origin_*, count_*.
bool is_own_key(const std::string& key);

}  // namespace vicus
