#include "city_db/store.hpp"
#include "city_db/store_open.hpp"
#include "city_db/store_records.hpp"
#include "city_db/store_schema.hpp"

namespace vicus {
namespace {

using Meta = std::map<std::string, std::string>;

/// The count in meta is a second witness: a table cut short does not pass for a smaller city.
template <class Record>
void read_list(const Database& db, const char* name, const Meta& meta, std::vector<Record>& list) {
  auto row = db.prepare(select_sql(table_named(name), "ORDER BY t.fid"));
  while (row.step()) read_record(row, list.emplace_back());
  const auto count = meta.find(std::string("count_") + name);
  const std::string expected = count == meta.end() ? "no count" : count->second;
  if (expected != std::to_string(list.size()))
    db.throw_damaged(std::string("table ") + name + " has " + std::to_string(list.size()) + " rows, meta says " +
                     expected.substr(0, 40));
}

}  // namespace

City read_city(const std::filesystem::path& path) { return read_city(path, {}); }

City read_city(const std::filesystem::path& path, const std::set<std::string>& tables) {
  const auto db = open_city(path);
  const Meta meta = read_meta(db);
  City city;
  city.origin = origin_from_meta(db, meta);
  const auto read = [&](const char* name, auto& list) {
    if (tables.empty() || tables.count(name)) read_list(db, name, meta, list);
  };
  read("sector", city.sectors);
  read("gate", city.gates);
  read("border", city.borders);
  read("building", city.buildings);
  read("facade", city.facades);
  read("obstacle", city.obstacles);
  read("domain", city.domain);
  read("street", city.streets);
  read("object", city.objects);
  read("surface", city.surfaces);
  read("ride", city.rides);
  read("prototype", city.prototypes);
  read("viewpoint", city.viewpoints);
  read("interior", city.interiors);
  read("door", city.doors);
  read("visible", city.visible);
  read("impostor", city.impostors);
  read("panorama", city.panoramas);
  read("issue", city.issues);
  std::vector<Terrain> terrains;
  read("terrain", terrains);
  if (terrains.size() > 1) db.throw_damaged("two terrains");
  if (!terrains.empty()) city.terrain = std::move(terrains.front());
  for (const auto& [key, value] : meta)
    if (!is_own_key(key)) city.meta[key] = value;
  return city;
}

}  // namespace vicus
