#pragma once
#include <string>
#include <vector>

#include "city_db/units.hpp"

/// The tables of a city file (DESIGN §4, FORMAT.md). Internal to store*.cpp.
namespace vicus {

class Database;

inline constexpr int kFormatVersion = 8;
inline constexpr const char* kGeometryColumn = "geom";

struct Column {
  const char* name;
  const char* type;  ///< with constraints
};

/// A table of ours: `fid` INTEGER PRIMARY KEY in the order of City's list, `geom` if it is a layer, then the columns.
struct Table {
  const char* name;
  const char* geometry;  ///< POINT, LINESTRING, POLYGON, GEOMETRY; nullptr: attributes only
  const char* description;
  std::vector<Column> columns;
  const char* constraint = nullptr;  ///< a table constraint, e.g. UNIQUE (path, coding)
};

/// Every table, in the order in which they are written.
const std::vector<Table>& tables();
const Table& table_named(const std::string& name);

/// The R-tree of a layer.
std::string rtree_name(const Table& table);
/// INSERT with a parameter for fid, geom (layers), then each column in order.
std::string insert_sql(const Table& table);
/// SELECT of geom (layers) and each column in order; `tail` is what follows FROM table, e.g. "WHERE id = ?1".
std::string select_sql(const Table& table, const std::string& tail);

/// Shortest decimal text that reads back as the same number, whatever the locale.
std::string text_from_double(double value);
/// WKT of the plan frame: transverse Mercator on WGS 84 through the origin, scale 1, metres.
std::string plan_wkt(LatLon origin);

/// GeoPackage's own tables, ours (empty), and the R-trees (empty).
void create_schema(Database& db, LatLon origin);
/// After the rows are in: indexes, R-tree triggers, extents in gpkg_contents, styles.
void finish_schema(Database& db, const std::vector<PlanBox>& extents);

/// QGIS's table of styles, one default style per layer.
void create_styles(Database& db);

}  // namespace vicus
