#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "city_db/terrain.hpp"
#include "sectorgen/geom/predicates.hpp"
#include "sectorgen/sectors/doorway.hpp"
#include "sectorgen/sectors/interiors.hpp"

namespace vicus {
namespace {

constexpr double kBefore_mm = 300;  // where the ground before a door is looked at

std::optional<double> height_in(const Surface& surface, PlanPoint p) {
  for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3) {
    const GroundPoint &a = surface.points[surface.triangles[i]], &b = surface.points[surface.triangles[i + 1]],
                      &c = surface.points[surface.triangles[i + 2]];
    const auto u = orient(b.at, c.at, p), v = orient(c.at, a.at, p), w = orient(a.at, b.at, p);
    if (u < 0 || v < 0 || w < 0 || u + v + w == 0) continue;
    const auto all = static_cast<double>(u + v + w);
    return (static_cast<double>(u) * a.up_mm + static_cast<double>(v) * b.up_mm + static_cast<double>(w) * c.up_mm) /
           all / kMmPerMetre;
  }
  return std::nullopt;
}

double ground_before(const City& city, const Door& door) {
  const Heading along = heading_of(door.a, door.b);
  const PlanPoint middle{door.a.x + (door.b.x - door.a.x) / 2, door.a.y + (door.b.y - door.a.y) / 2};
  const PlanPoint before = moved(middle, reversed(right_of(along)), kBefore_mm);
  for (const Surface& surface : city.surfaces)
    if (surface.sector_id == door.sector_id && surface.kind != SurfaceKind::kerb)
      if (const auto up = height_in(surface, before)) return *up;
  return height_m(city.terrain, before);
}

constexpr double kStep_mm = 700;

/// One in each room: just inside its first door, looking into it.
void add_viewpoints(City& city) {
  std::map<std::string, const Door*> first;
  for (const Door& door : city.doors) first.emplace(door.sector_id, &door);
  for (const Interior& room : city.interiors) {
    const auto at = first.find(room.sector.id);
    if (at == first.end()) continue;
    const Door& door = *at->second;
    const Heading inwards = reversed(right_of(heading_of(door.a, door.b)));
    const PlanPoint middle{door.a.x + (door.b.x - door.a.x) / 2, door.a.y + (door.b.y - door.a.y) / 2};
    const auto wall = std::find(room.sector.ground.outer.begin(), room.sector.ground.outer.end(), door.a);
    const PlanPoint before = wall == room.sector.ground.outer.begin() ? room.sector.ground.outer.back() : *(wall - 1);
    const double depth = std::sqrt(static_cast<double>(distance2(before, door.a)));
    Viewpoint v;
    v.id = "v-" + room.sector.id;
    v.sector_id = room.sector.id;
    v.kind = "start";
    v.name = room.sector.name.empty() ? name_of(SectorKind::interior) : room.sector.name;
    v.at = moved(middle, inwards, depth + kStep_mm);
    v.ground_m = room.floor_m;
    v.heading_deg = std::fmod(std::atan2(inwards.x, inwards.y) * 180 / std::numbers::pi + 360, 360);
    city.viewpoints.push_back(std::move(v));
  }
}

}  // namespace

void level_interiors(City& city) {
  std::map<std::string, Interior*> rooms;
  for (auto& room : city.interiors) rooms.emplace(room.sector.id, &room);
  std::map<std::string, double> sills, floors;
  for (const Door& door : city.doors)
    if (!rooms.contains(door.sector_id)) {
      sills[door.id] = sills[door.twin_id] = ground_before(city, door);
      floors.emplace(door.to_sector_id, sills[door.id]);
    }
  // Rooms behind rooms: as high as the one before.
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (const Door& door : city.doors)
      if (const auto from = floors.find(door.sector_id); from != floors.end() && rooms.contains(door.to_sector_id))
        has_grown = floors.emplace(door.to_sector_id, from->second).second || has_grown;
  }
  for (auto& [id, room] : rooms) room->floor_m = floors[id];
  add_viewpoints(city);
  for (Door& door : city.doors)
    door.sill_m =
        sills.contains(door.id) ? sills[door.id] : std::max(floors[door.sector_id], floors[door.to_sector_id]);
}

}  // namespace vicus
