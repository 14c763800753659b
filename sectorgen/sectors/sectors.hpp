#pragma once
#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"
#include "sectorgen/sectors/cells.hpp"
#include "sectorgen/sectors/ground.hpp"
#include "sectorgen/sectors/obstacles.hpp"
#include "sectorgen/sectors/routes.hpp"

/// From cells of the ground to the records of a city.
namespace vicus {

/// Everything the sector stage works on, in the order it comes to be.
struct Plan {
  Blocks blocks;
  std::vector<Polygon> domain;
  std::vector<std::vector<PlanPoint>> kerbs;
  std::vector<NodedPart> noded;
  Ground ground;
  StreetRoutes routes;
  Cells cells;
};

/// Writes sectors, gates, borders, buildings, obstacles, domain, streets into the city (ids of sectors and gates are
/// set by identify, objects by furnish, viewpoints by add_start_views: naming.hpp). In City, sector_id fields hold the
/// sector's index as text until identity.hpp names them. Keeps   DESIGN §3 rules 1-5 by construction: rings are unions
/// of mesh triangles, gates mesh edges. Raises  301 unmapped_street, 402 yard_closed.
void write_sectors(const SourceMap& map, const Plan& plan, City& city);

}  // namespace vicus
