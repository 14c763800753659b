#pragma once
#include <array>
#include <optional>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/geom/noding.hpp"

/// Shortest walks by brute force: no mesh, no search by sight, nothing shared but the map.
namespace vicus::test {

struct WalkGround {
  std::vector<std::array<PlanPoint, 3>> triangles;  ///< counter-clockwise; their union is the ground
  std::vector<Segment> walls;                       ///< noded: no wall has a point of another inside
};

/// Ground and walls of a city: edges of sectors that bear no gate to another.
WalkGround walk_ground(const std::vector<Sector>& sectors, const std::vector<Gate>& gates);

/// Length in mm over the graph of all lines of sight between from, to and the walls' ends; nullopt: no way. Ground that
/// meets in a point only is not joined there.
/// Needs   coordinates within 2^18 mm.   Cost   ends squared x walls.
std::optional<double> shortest_by_brute_force(const WalkGround& ground, PlanPoint from, PlanPoint to);

/// mm from a place to the nearest wall.
double clearance_mm(const WalkGround& ground, double x, double y);

}  // namespace vicus::test
