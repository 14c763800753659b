#include "city_db/store.hpp"
#include "city_db/store_file.hpp"
#include "city_db/store_records.hpp"
#include "city_db/store_rtree.hpp"
#include "city_db/store_schema.hpp"
#include "city_db/store_sqlite.hpp"

namespace vicus {
namespace {

template <class Record>
concept HasPlace = requires(const Record& record) {
  box_of_record(record);
};

/// Fills one table; fid counts from 1 in the order of the calls.
template <class Record>
class TableWriter {
 public:
  TableWriter(Database& db, const Table& table) : insert_(db.prepare(insert_sql(table))) {}

  void add(const Record& record) {
    insert_.bind(0, ++count_);
    bind_record(insert_, record);
    insert_.run();
    if constexpr (HasPlace<Record>) {
      const PlanBox box = box_of_record(record);
      if (!box.is_empty()) places_.push_back({count_, box});
    }
  }
  std::int64_t count() const { return count_; }
  const std::vector<RtreeEntry>& places() const { return places_; }

 private:
  Statement insert_;
  std::int64_t count_ = 0;
  std::vector<RtreeEntry> places_;
};

/// What was written into each table, by its place in tables().
struct Written {
  std::vector<PlanBox> extents = std::vector<PlanBox>(tables().size());
  std::vector<std::int64_t> counts = std::vector<std::int64_t>(tables().size());

  template <class Record>
  void note(const Table& table, const TableWriter<Record>& writer) {
    const auto i = static_cast<std::size_t>(&table - tables().data());
    for (const auto& [id, box] : writer.places()) {
      extents[i].add(box.min);
      extents[i].add(box.max);
    }
    counts[i] = writer.count();
  }
};

template <class Record>
void write_list(Database& db, const char* name, const std::vector<Record>& list, Written& written) {
  const Table& table = table_named(name);
  TableWriter<Record> writer(db, table);
  for (const auto& record : list) writer.add(record);
  if constexpr (HasPlace<Record>) fill_rtree(db, rtree_name(table), writer.places());
  written.note(table, writer);
}

void write_artefacts(Database& db, const std::function<std::optional<Artefact>()>& next, Written& written) {
  const Table& table = table_named("artefact");
  TableWriter<Artefact> writer(db, table);
  while (const auto artefact = next ? next() : std::nullopt) writer.add(*artefact);
  written.note(table, writer);
}

void write_meta(Database& db, const City& city, const Written& written) {
  auto meta = city.meta;
  meta["format_version"] = std::to_string(kFormatVersion);
  meta["origin_lat"] = text_from_double(city.origin.lat_deg);
  meta["origin_lon"] = text_from_double(city.origin.lon_deg);
  for (std::size_t i = 0; i < tables().size(); ++i)
    if (tables()[i].name != std::string_view("meta"))
      meta[std::string("count_") + tables()[i].name] = std::to_string(written.counts[i]);
  auto insert = db.prepare(insert_sql(table_named("meta")));
  std::int64_t fid = 0;
  for (const auto& [key, value] : meta) {
    insert.bind(0, ++fid);
    insert.bind(1, key);
    insert.bind(2, value);
    insert.run();
  }
}

}  // namespace

void write_city(const std::filesystem::path& path, const City& city,
                const std::function<std::optional<Artefact>()>& next_artefact) {
  check_target(path);
  TemporaryFile file(path);
  auto db = Database::create(file.path(), path);
  db.execute("BEGIN");
  create_schema(db, city.origin);
  Written written;
  write_artefacts(db, next_artefact, written);
  write_list(db, "sector", city.sectors, written);
  write_list(db, "gate", city.gates, written);
  write_list(db, "border", city.borders, written);
  write_list(db, "building", city.buildings, written);
  write_list(db, "facade", city.facades, written);
  write_list(db, "obstacle", city.obstacles, written);
  write_list(db, "domain", city.domain, written);
  write_list(db, "street", city.streets, written);
  write_list(db, "object", city.objects, written);
  write_list(db, "surface", city.surfaces, written);
  write_list(db, "ride", city.rides, written);
  write_list(db, "prototype", city.prototypes, written);
  write_list(db, "viewpoint", city.viewpoints, written);
  write_list(db, "interior", city.interiors, written);
  write_list(db, "door", city.doors, written);
  write_list(db, "visible", city.visible, written);
  write_list(db, "impostor", city.impostors, written);
  write_list(db, "panorama", city.panoramas, written);
  write_list(db, "terrain", std::vector<Terrain>(city.terrain.height_mm.empty() ? 0 : 1, city.terrain), written);
  write_list(db, "issue", city.issues, written);
  write_meta(db, city, written);
  finish_schema(db, written.extents);
  db.execute("COMMIT");
  db.close();
  file.move_into_place();
}

}  // namespace vicus
