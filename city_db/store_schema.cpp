#include "city_db/store_schema.hpp"

#include <cassert>
#include <charconv>

#include "city_db/geometry_blob.hpp"
#include "city_db/store_sqlite.hpp"

namespace vicus {
namespace {

// GeoPackage asks for a time of change; a constant keeps equal cities equal byte by byte.
constexpr const char* kLastChange = "2000-01-01T00:00:00.000Z";

constexpr const char* kGpkgTables = R"sql(
CREATE TABLE gpkg_spatial_ref_sys (
  srs_name TEXT NOT NULL, srs_id INTEGER NOT NULL PRIMARY KEY, organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT);
CREATE TABLE gpkg_contents (
  table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE, description TEXT DEFAULT '',
  last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')),
  min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER,
  CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id));
CREATE TABLE gpkg_geometry_columns (
  table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL, srs_id INTEGER NOT NULL,
  z TINYINT NOT NULL, m TINYINT NOT NULL,
  CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name), CONSTRAINT uk_gc_table_name UNIQUE (table_name),
  CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name),
  CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id));
CREATE TABLE gpkg_extensions (
  table_name TEXT, column_name TEXT, extension_name TEXT NOT NULL, definition TEXT NOT NULL, scope TEXT NOT NULL,
  CONSTRAINT ge_tce UNIQUE (table_name, column_name, extension_name));
)sql";

// The R-tree triggers of GeoPackage 1.3, annex F.3, so that an editor keeps the index true. %t: table, %g: column.
constexpr const char* kRtreeTriggers = R"sql(
CREATE TRIGGER "rtree_%t_%g_insert" AFTER INSERT ON "%t"
  WHEN (NEW."%g" NOT NULL AND NOT ST_IsEmpty(NEW."%g"))
BEGIN
  INSERT OR REPLACE INTO "rtree_%t_%g" VALUES (NEW.fid,
    ST_MinX(NEW."%g"), ST_MaxX(NEW."%g"), ST_MinY(NEW."%g"), ST_MaxY(NEW."%g"));
END;
CREATE TRIGGER "rtree_%t_%g_update1" AFTER UPDATE OF "%g" ON "%t"
  WHEN OLD.fid = NEW.fid AND (NEW."%g" NOTNULL AND NOT ST_IsEmpty(NEW."%g"))
BEGIN
  INSERT OR REPLACE INTO "rtree_%t_%g" VALUES (NEW.fid,
    ST_MinX(NEW."%g"), ST_MaxX(NEW."%g"), ST_MinY(NEW."%g"), ST_MaxY(NEW."%g"));
END;
CREATE TRIGGER "rtree_%t_%g_update2" AFTER UPDATE OF "%g" ON "%t"
  WHEN OLD.fid = NEW.fid AND (NEW."%g" ISNULL OR ST_IsEmpty(NEW."%g"))
BEGIN
  DELETE FROM "rtree_%t_%g" WHERE id = OLD.fid;
END;
CREATE TRIGGER "rtree_%t_%g_update3" AFTER UPDATE ON "%t"
  WHEN OLD.fid != NEW.fid AND (NEW."%g" NOTNULL AND NOT ST_IsEmpty(NEW."%g"))
BEGIN
  DELETE FROM "rtree_%t_%g" WHERE id = OLD.fid;
  INSERT OR REPLACE INTO "rtree_%t_%g" VALUES (NEW.fid,
    ST_MinX(NEW."%g"), ST_MaxX(NEW."%g"), ST_MinY(NEW."%g"), ST_MaxY(NEW."%g"));
END;
CREATE TRIGGER "rtree_%t_%g_update4" AFTER UPDATE ON "%t"
  WHEN OLD.fid != NEW.fid AND (NEW."%g" ISNULL OR ST_IsEmpty(NEW."%g"))
BEGIN
  DELETE FROM "rtree_%t_%g" WHERE id IN (OLD.fid, NEW.fid);
END;
CREATE TRIGGER "rtree_%t_%g_delete" AFTER DELETE ON "%t"
  WHEN OLD."%g" NOT NULL
BEGIN
  DELETE FROM "rtree_%t_%g" WHERE id = OLD.fid;
END;
)sql";

std::string for_table(std::string sql, const Table& table) {
  const auto replace_all = [&](const std::string& what, const std::string& by) {
    for (auto at = sql.find(what); at != sql.npos; at = sql.find(what, at + by.size()))
      sql.replace(at, what.size(), by);
  };
  replace_all("%t", table.name);
  replace_all("%g", kGeometryColumn);
  return sql;
}

constexpr const char* kGeographicWkt =
    "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563,AUTHORITY[\"EPSG\",\"7030\"]],"
    "AUTHORITY[\"EPSG\",\"6326\"]],PRIMEM[\"Greenwich\",0,AUTHORITY[\"EPSG\",\"8901\"]],UNIT[\"degree\","
    "0.0174532925199433,AUTHORITY[\"EPSG\",\"9122\"]],AUTHORITY[\"EPSG\",\"4326\"]]";

void add_reference_systems(Database& db, LatLon origin) {
  auto insert = db.prepare("INSERT INTO gpkg_spatial_ref_sys VALUES (?1, ?2, ?3, ?4, ?5, ?6)");
  const auto add = [&](const char* name, std::int64_t id, const char* organization, std::int64_t organization_id,
                       const std::string& definition, const char* description) {
    insert.bind(0, name);
    insert.bind(1, id);
    insert.bind(2, organization);
    insert.bind(3, organization_id);
    insert.bind(4, definition);
    insert.bind(5, description);
    insert.run();
  };
  add("Undefined cartesian SRS", -1, "NONE", -1, "undefined", "undefined cartesian coordinate reference system");
  add("Undefined geographic SRS", 0, "NONE", 0, "undefined", "undefined geographic coordinate reference system");
  add("WGS 84 geodetic", 4326, "EPSG", 4326, kGeographicWkt, "longitude and latitude in degrees on WGS 84");
  add("Vicus plan frame", kPlanSrsId, "VICUS", kPlanSrsId, plan_wkt(origin),
      "metres east and north of the city's origin; transverse Mercator of scale 1 there");
}

}  // namespace

std::string rtree_name(const Table& table) { return std::string("rtree_") + table.name + "_" + kGeometryColumn; }

std::string insert_sql(const Table& table) {
  const std::size_t parameters = 1 + (table.geometry != nullptr ? 1u : 0u) + table.columns.size();
  std::string sql = std::string("INSERT INTO \"") + table.name + "\" VALUES (?";
  for (std::size_t i = 1; i < parameters; ++i) sql += ", ?";
  return sql + ")";
}

std::string select_sql(const Table& table, const std::string& tail) {
  std::string columns = table.geometry != nullptr ? std::string("t.\"") + kGeometryColumn + '"' : "";
  for (const auto& column : table.columns)
    columns += (columns.empty() ? "t.\"" : ", t.\"") + std::string(column.name) + '"';
  return "SELECT " + columns + " FROM \"" + table.name + "\" t " + tail;
}

std::string text_from_double(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return std::string(text, end);
}

std::string plan_wkt(LatLon origin) {
  const std::string lat = text_from_double(origin.lat_deg), lon = text_from_double(origin.lon_deg);
  return "PROJCS[\"Vicus plan frame at " + lat + " " + lon + "\"," + kGeographicWkt +
         ",PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\"," + lat +
         "],PARAMETER[\"central_meridian\"," + lon +
         "],PARAMETER[\"scale_factor\",1],PARAMETER[\"false_easting\",0],PARAMETER[\"false_northing\",0],"
         "UNIT[\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]],AXIS[\"Easting\",EAST],AXIS[\"Northing\",NORTH]]";
}

void create_schema(Database& db, LatLon origin) {
  db.execute("PRAGMA application_id=0x47504B47; PRAGMA user_version=10300");
  db.execute(kGpkgTables);
  add_reference_systems(db, origin);
  for (const auto& table : tables()) {
    std::string sql = std::string("CREATE TABLE \"") + table.name + "\" (fid INTEGER PRIMARY KEY NOT NULL";
    if (table.geometry != nullptr) sql += std::string(", \"") + kGeometryColumn + "\" " + table.geometry + " NOT NULL";
    for (const auto& column : table.columns) sql += std::string(", \"") + column.name + "\" " + column.type;
    if (table.constraint != nullptr) sql += std::string(", ") + table.constraint;
    db.execute(sql + ")");
    if (table.geometry != nullptr)
      db.execute(for_table("CREATE VIRTUAL TABLE \"rtree_%t_%g\" USING rtree(id, minx, maxx, miny, maxy)", table));
  }
}

void finish_schema(Database& db, const std::vector<PlanBox>& extents) {
  assert(extents.size() == tables().size());
  db.execute(
      "CREATE INDEX gate_sector ON gate(sector_id); CREATE INDEX border_sector ON border(sector_id);"
      "CREATE INDEX building_sector ON building(sector_id); CREATE INDEX object_sector ON object(sector_id);"
      "CREATE INDEX viewpoint_sector ON viewpoint(sector_id); CREATE INDEX visible_sector ON visible(sector_id);"
      "CREATE INDEX facade_sector ON facade(sector_id); CREATE INDEX surface_sector ON surface(sector_id);"
      "CREATE INDEX ride_sector ON ride(sector_id); CREATE INDEX impostor_sector ON impostor(sector_id);"
      "CREATE INDEX door_sector ON door(sector_id)");
  auto contents = db.prepare("INSERT INTO gpkg_contents VALUES (?1, ?2, ?1, ?3, ?4, ?5, ?6, ?7, ?8, ?9)");
  auto geometry = db.prepare("INSERT INTO gpkg_geometry_columns VALUES (?1, ?2, ?3, ?4, 0, 0)");
  auto extension = db.prepare(
      "INSERT INTO gpkg_extensions VALUES (?1, ?2, 'gpkg_rtree_index',"
      "'http://www.geopackage.org/spec130/#extension_rtree', 'write-only')");
  for (std::size_t i = 0; i < tables().size(); ++i) {
    const Table& table = tables()[i];
    const bool is_layer = table.geometry != nullptr;
    contents.bind(0, table.name);
    contents.bind(1, is_layer ? "features" : "attributes");
    contents.bind(2, table.description);
    contents.bind(3, kLastChange);
    if (const PlanBox& box = extents[i]; !box.is_empty()) {
      contents.bind(4, metres(box.min.x));
      contents.bind(5, metres(box.min.y));
      contents.bind(6, metres(box.max.x));
      contents.bind(7, metres(box.max.y));
    }
    if (is_layer) contents.bind(8, std::int64_t{kPlanSrsId});
    contents.run();
    if (!is_layer) continue;
    geometry.bind(0, table.name);
    geometry.bind(1, kGeometryColumn);
    geometry.bind(2, table.geometry);
    geometry.bind(3, std::int64_t{kPlanSrsId});
    geometry.run();
    extension.bind(0, table.name);
    extension.bind(1, kGeometryColumn);
    extension.run();
    db.execute(for_table(kRtreeTriggers, table));
  }
  create_styles(db);
}

}  // namespace vicus
