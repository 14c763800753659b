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

City read_city(const std::filesystem::path& path) {
  const auto db = open_city(path);
  const Meta meta = read_meta(db);
  City city;
  city.origin = origin_from_meta(db, meta);
  read_list(db, "sector", meta, city.sectors);
  read_list(db, "gate", meta, city.gates);
  read_list(db, "border", meta, city.borders);
  read_list(db, "building", meta, city.buildings);
  read_list(db, "facade", meta, city.facades);
  read_list(db, "obstacle", meta, city.obstacles);
  read_list(db, "domain", meta, city.domain);
  read_list(db, "street", meta, city.streets);
  read_list(db, "object", meta, city.objects);
  read_list(db, "surface", meta, city.surfaces);
  read_list(db, "ride", meta, city.rides);
  read_list(db, "prototype", meta, city.prototypes);
  read_list(db, "viewpoint", meta, city.viewpoints);
  read_list(db, "visible", meta, city.visible);
  read_list(db, "impostor", meta, city.impostors);
  read_list(db, "issue", meta, city.issues);
  std::vector<Terrain> terrains;
  read_list(db, "terrain", meta, terrains);
  if (terrains.size() > 1) db.throw_damaged("two terrains");
  if (!terrains.empty()) city.terrain = std::move(terrains.front());
  for (const auto& [key, value] : meta)
    if (!is_own_key(key)) city.meta[key] = value;
  return city;
}

}  // namespace vicus
