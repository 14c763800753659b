#include "city_db/boxes.hpp"
#include "city_db/store.hpp"
#include "city_db/store_open.hpp"
#include "city_db/store_records.hpp"
#include "city_db/store_schema.hpp"

namespace vicus {
namespace {

/// A cached statement in use; free for the next use when this goes away.
class InUse {
 public:
  explicit InUse(Statement& statement) : statement_(statement) {}
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;
  ~InUse() { statement_.reset(); }
  Statement* operator->() { return &statement_; }
  Statement& operator*() { return statement_; }

 private:
  Statement& statement_;
};

}  // namespace

struct CityReader::Impl {
  explicit Impl(const std::filesystem::path& path) : db(open_city(path)) {}

  InUse use(const std::string& sql) {
    auto at = statements.find(sql);
    if (at == statements.end()) at = statements.emplace(sql, db.prepare(sql)).first;
    return InUse(at->second);
  }
  InUse select(const char* table, const std::string& tail) { return use(select_sql(table_named(table), tail)); }

  template <class Record>
  std::optional<Record> row_of(const char* table, const std::string& id) {
    auto row = select(table, "WHERE t.id = ?1");
    row->bind(0, id);
    if (!row->step()) return std::nullopt;
    Record record;
    read_record(*row, record);
    return record;
  }

  template <class Record>
  std::vector<Record> rows_of(const char* table, const std::string& sector_id) {
    auto row = select(table, "WHERE t.sector_id = ?1 ORDER BY t.fid");
    row->bind(0, sector_id);
    std::vector<Record> rows;
    while (row->step()) read_record(*row, rows.emplace_back());
    return rows;
  }

  /// The R-tree's boxes are 32-bit floats rounded outwards, so what it finds is looked at again on the lattice.
  template <class Record>
  std::vector<Record> rows_in(const char* table, const PlanBox& box, std::size_t limit, std::size_t offset) {
    std::vector<Record> rows;
    if (box.is_empty() || limit == 0) return rows;
    auto row = select(table, "JOIN \"" + rtree_name(table_named(table)) +
                                 "\" r ON t.fid = r.id WHERE r.maxx >= ?1 AND r.minx <= ?2 AND r.maxy >= ?3 AND "
                                 "r.miny <= ?4 ORDER BY t.id");
    row->bind(0, metres(box.min.x));
    row->bind(1, metres(box.max.x));
    row->bind(2, metres(box.min.y));
    row->bind(3, metres(box.max.y));
    std::size_t skipped = 0;
    while (rows.size() < limit && row->step()) {
      Record record;
      read_record(*row, record);
      if (!meet(box_of_record(record), box)) continue;
      if (skipped < offset)
        ++skipped;
      else
        rows.push_back(std::move(record));
    }
    return rows;
  }

  Database db;
  std::map<std::string, Statement> statements;  // after db: finalized before it closes
};

CityReader::CityReader(const std::filesystem::path& path) : impl_(std::make_unique<Impl>(path)) {}
CityReader::~CityReader() = default;
CityReader::CityReader(CityReader&&) noexcept = default;
CityReader& CityReader::operator=(CityReader&&) noexcept = default;

std::optional<Artefact> CityReader::artefact(const std::string& path, const std::vector<std::string>& codings) const {
  for (const auto& coding : codings) {
    auto row = impl_->select("artefact", "WHERE t.path = ?1 AND t.coding = ?2");
    row->bind(0, path);
    row->bind(1, coding);
    if (!row->step()) continue;
    Artefact artefact;
    read_record(*row, artefact);
    return artefact;
  }
  return std::nullopt;
}

std::vector<Artefact> CityReader::artefact_codings(const std::string& path) const {
  // Without the column `body`, so that its overflow pages are not read.
  auto row = impl_->use("SELECT path, media_type, coding, hash FROM artefact WHERE path = ?1 ORDER BY coding");
  row->bind(0, path);
  std::vector<Artefact> artefacts;
  while (row->step()) artefacts.push_back({row->text(0), row->text(1), row->text(2), row->text(3), ""});
  return artefacts;
}

std::vector<ArtefactTotal> CityReader::artefact_totals() const {
  auto row = impl_->use(
      "SELECT media_type, coding, count(*), sum(length(body)) FROM artefact GROUP BY media_type, coding "
      "ORDER BY media_type, coding");
  std::vector<ArtefactTotal> totals;
  while (row->step())
    totals.push_back({row->text(0), row->text(1), static_cast<std::uint64_t>(row->integer(2)),
                      static_cast<std::uint64_t>(row->integer(3))});
  return totals;
}

std::optional<std::string> CityReader::meta(const std::string& key) const {
  auto row = impl_->use("SELECT value FROM meta WHERE key = ?1");
  row->bind(0, key);
  if (!row->step()) return std::nullopt;
  return row->text(0);
}

std::vector<std::string> CityReader::sector_ids() const {
  auto row = impl_->use("SELECT id FROM sector ORDER BY id");
  std::vector<std::string> ids;
  while (row->step()) ids.push_back(row->text(0));
  return ids;
}

std::optional<Sector> CityReader::sector(const std::string& id) const { return impl_->row_of<Sector>("sector", id); }
std::optional<Gate> CityReader::gate(const std::string& id) const { return impl_->row_of<Gate>("gate", id); }
std::optional<Building> CityReader::building(const std::string& id) const {
  return impl_->row_of<Building>("building", id);
}

std::vector<Gate> CityReader::gates_of(const std::string& sector_id) const {
  return impl_->rows_of<Gate>("gate", sector_id);
}
std::vector<Border> CityReader::borders_of(const std::string& sector_id) const {
  return impl_->rows_of<Border>("border", sector_id);
}
std::vector<Building> CityReader::buildings_of(const std::string& sector_id) const {
  return impl_->rows_of<Building>("building", sector_id);
}
std::vector<Facade> CityReader::facades_of(const std::string& sector_id) const {
  return impl_->rows_of<Facade>("facade", sector_id);
}
std::vector<StandaloneObject> CityReader::objects_of(const std::string& sector_id) const {
  return impl_->rows_of<StandaloneObject>("object", sector_id);
}
std::vector<Surface> CityReader::surfaces_of(const std::string& sector_id) const {
  return impl_->rows_of<Surface>("surface", sector_id);
}
std::vector<Ride> CityReader::rides_of(const std::string& sector_id) const {
  return impl_->rows_of<Ride>("ride", sector_id);
}
Terrain CityReader::terrain() const {
  auto row = impl_->select("terrain", "ORDER BY t.fid");
  Terrain terrain;
  if (row->step()) read_record(*row, terrain);
  return terrain;
}
std::vector<Prototype> CityReader::prototypes() const {
  auto row = impl_->select("prototype", "ORDER BY t.fid");
  std::vector<Prototype> rows;
  while (row->step()) read_record(*row, rows.emplace_back());
  return rows;
}
std::vector<Viewpoint> CityReader::viewpoints_of(const std::string& sector_id) const {
  return impl_->rows_of<Viewpoint>("viewpoint", sector_id);
}
std::optional<Interior> CityReader::interior(const std::string& id) const {
  return impl_->row_of<Interior>("interior", id);
}
std::vector<Door> CityReader::doors_of(const std::string& sector_id) const {
  return impl_->rows_of<Door>("door", sector_id);
}
std::vector<Visible> CityReader::visible_from(const std::string& sector_id) const {
  return impl_->rows_of<Visible>("visible", sector_id);
}
std::vector<GateImpostor> CityReader::impostors_of(const std::string& sector_id) const {
  return impl_->rows_of<GateImpostor>("impostor", sector_id);
}

std::optional<Panorama> CityReader::panorama_of(const std::string& sector_id) const {
  auto rows = impl_->rows_of<Panorama>("panorama", sector_id);
  return rows.empty() ? std::nullopt : std::optional(std::move(rows.front()));
}

std::vector<std::string> CityReader::sectors_in(const PlanBox& box, std::size_t limit, std::size_t offset) const {
  std::vector<std::string> ids;
  for (auto& sector : impl_->rows_in<Sector>("sector", box, limit, offset)) ids.push_back(std::move(sector.id));
  return ids;
}
std::vector<Gate> CityReader::gates_in(const PlanBox& box, std::size_t limit, std::size_t offset) const {
  return impl_->rows_in<Gate>("gate", box, limit, offset);
}
std::vector<Building> CityReader::buildings_in(const PlanBox& box, std::size_t limit, std::size_t offset) const {
  return impl_->rows_in<Building>("building", box, limit, offset);
}
std::vector<Interior> CityReader::interiors_in(const PlanBox& box, std::size_t limit, std::size_t offset) const {
  return impl_->rows_in<Interior>("interior", box, limit, offset);
}

}  // namespace vicus
