#include "sectorgen/sectors/interiors.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <set>

#include "city_db/boxes.hpp"
#include "city_db/segment.hpp"
#include "sectorgen/geo/tag_values.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/doorway.hpp"
#include "sectorgen/sectors/facade_spot.hpp"
#include "sectorgen/sectors/overlay.hpp"

namespace vicus {
namespace {

constexpr double kCeiling_m = 2.8, kLeastCeiling_m = 2.1, kBelowEave_m = 0.1;
constexpr double kLeastRoom_m2 = 2, kLeastRadius_m = 0.45;
constexpr double kDoorHeight_m = 2.1, kOverDoor_m = 0.15;
constexpr double kStreetDoor_m = 1.0, kInnerDoor_m = 0.9, kLeastDoor_m = 0.7, kWidestDoor_m = 2.4;
constexpr double kLeafRecess_m = 0.145;  // of the leaf's middle in a doorway to the street
constexpr double kSameDoor_m = 1.2;      // two mapped places of one door

struct RoomDraft {
  const Room* room = nullptr;
  const Building* house = nullptr;
  Polygon outline;  // as mapped
  Interior interior;
};

struct DoorPlace {
  PlanPoint at;
  double width_m = 0;  // 0: unknown
  std::string source_id;
  bool is_sure = true;  // leads into a room; else an entrance of the house that may lead anywhere
  std::size_t of_room = kAnyRoom;
  static constexpr std::size_t kAnyRoom = std::numeric_limits<std::size_t>::max();
};

/// Half of a door: what becomes two records.
struct DoorDraft {
  std::string from, to, house;  // from: the side that the leaf opens away from
  PlanPoint a, b;
  double height_m = 0, recess_m = 0;
};

std::string plain_id(const std::string& text) {
  std::string id;
  for (const char c : text) id += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ? c : '-';
  return id;
}

double distance_m(const Polygon& outline, PlanPoint p) {
  double least = std::numeric_limits<double>::max();
  const auto look_at = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      least = std::min(least, distance_to_segment_mm(p, ring[i], ring[(i + 1) % ring.size()]));
  };
  look_at(outline.outer);
  for (const auto& hole : outline.holes) look_at(hole);
  return least / kMmPerMetre;
}

Polygon largest(std::vector<Polygon> polygons) {
  const auto at = std::max_element(polygons.begin(), polygons.end(),
                                   [](const Polygon& a, const Polygon& b) { return area_m2(a) < area_m2(b); });
  return at == polygons.end() ? Polygon{} : std::move(*at);
}

class InteriorWriter {
 public:
  InteriorWriter(const SourceMap& map, City& city) : map_(map), city_(city) {
    for (const auto& house : city.buildings)
      if (house.base_m <= 0) houses_.push_back({box_of(house.footprint), &house});
  }

  void run() {
    place_rooms();
    for (auto& [house, rooms] : rooms_of_) {
      std::vector<DoorPlace> places = mapped_doors(rooms);
      for (const auto& place : places) hang_door(rooms, place);
    }
    keep_reached();
    write();
  }

 private:
  void issue(IssueCode code, const std::string& message, const std::string& source_id, PlanPoint at) {
    city_.issues.push_back({code, message, source_id, at});
  }

  const Building* house_of(const Room& room) const {
    for (const auto& [box, house] : houses_) {
      if (!room.house.empty()) {
        if (house->id == room.house || house->source_id == room.house) return house;
        continue;
      }
      if (!box.contains(room.area.outer.front())) continue;
      PlanPoint middle;
      const PlanBox b = box_of(room.area);
      const std::int32_t y = b.min.y + (b.max.y - b.min.y) / 2;
      if (inside_length_m({b.min.x - 1, y}, {b.max.x + 1, y}, room.area, middle) > 0 &&
          locate(Polygon{house->footprint.outer, {}}, middle) == Side::inside)  // a light well may pierce the room
        return house;
    }
    return nullptr;
  }

  void place_rooms() {
    std::map<std::string, std::pair<int, const Room*>> upstairs;
    for (const Room& room : map_.rooms) {
      if (room.house.empty() && room.area.outer.empty()) continue;
      const PlanPoint at = room.area.outer.empty() ? PlanPoint{} : room.area.outer.front();
      const Building* house = house_of(room);
      if (!house) {
        issue(IssueCode::room_outside,
              room.house.empty() ? "The room lies in no house that stands on the ground; left out."
                                 : "No house on the ground has the id " + room.house + "; its room was left out.",
              room.source_id, at);
      } else if (!room.is_on_ground_floor) {
        auto& [count, first] = upstairs[house->id];
        if (++count == 1) first = &room;
      } else {
        place_room(room, *house);
      }
    }
    for (const auto& [house, rooms] : upstairs)
      issue(IssueCode::room_on_other_level,
            std::to_string(rooms.first) + " rooms above or below the ground floor of house " + house + "; left out.",
            rooms.second->source_id, rooms.second->area.outer.front());
  }

  void place_room(const Room& room, const Building& house) {
    RoomDraft draft{&room, &house, room.area.outer.empty() ? house.footprint : room.area, {}};
    const PlanPoint at = draft.outline.outer.front();
    Polygon ground = largest(
        intersect(offset({draft.outline}, -kInnerWall_m / 2, false), offset({house.footprint}, -kOuterWall_m, false)));
    for (const RoomDraft& other : rooms_of_[house.id])  // rooms mapped over each other
      if (!ground.outer.empty())
        ground = largest(subtract({ground}, offset({other.interior.sector.ground}, kInnerWall_m, false)));
    const double most_m = house.eave_m - kBelowEave_m;
    const double height_m = std::min(room.height_m > 0 ? room.height_m : kCeiling_m, most_m);
    if (ground.outer.empty() || area_m2(ground) < kLeastRoom_m2 || height_m < kLeastCeiling_m ||
        offset({ground}, -kLeastRadius_m, false).empty())
      return issue(IssueCode::room_too_small,
                   "Nobody could stand in what the walls and the roof leave of this room; left out.", room.source_id,
                   at);
    Interior& interior = draft.interior;
    interior.building_id = house.id;
    interior.source_id = room.source_id;
    interior.height_m = height_m;
    interior.sector.kind = SectorKind::interior;
    interior.sector.name = room.name;
    interior.sector.id = new_id("in-" + plain_id(room.house.empty() ? room.source_id : house.id));
    interior.sector.ground = std::move(ground);
    rooms_of_[house.id].push_back(std::move(draft));
  }

  std::string new_id(const std::string& wish) {
    const int n = ++used_ids_[wish];
    return n == 1 ? wish : new_id(wish + "-" + std::to_string(n));
  }

  std::vector<DoorPlace> mapped_doors(const std::vector<RoomDraft>& rooms) const {
    std::vector<DoorPlace> places;
    PlanBox around;
    bool needs_map = false;
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      const Room& room = *rooms[i].room;
      for (const PlanPoint at : room.doors) places.push_back({at, 0, room.source_id, true, i});
      if (room.doors.empty() && !room.house.empty())
        if (const auto spot = middle_of_longest_facade(city_, rooms[i].house->id, rooms[i].interior.sector.ground))
          places.push_back({*spot, 0, room.source_id, true, i});
      if (!room.house.empty()) continue;
      needs_map = true;
      around.add(box_of(rooms[i].outline).min);
      around.add(box_of(rooms[i].outline).max);
    }
    if (!needs_map) return places;
    around = grown(around, lattice_mm(kDoorReach_m));
    for (const PointObject& o : map_.objects) {
      if ((o.kind != "door" && o.kind != "indoor_door") || !around.contains(o.at)) continue;
      const auto width = o.tags.find("width");
      const auto width_m = width == o.tags.end() ? std::nullopt : parse_metres(width->second);
      places.push_back({o.at, width_m.value_or(0), o.source_id, o.kind == "indoor_door", DoorPlace::kAnyRoom});
    }
    return places;
  }

  void hang_door(std::vector<RoomDraft>& rooms, const DoorPlace& place) {
    for (const DoorDraft& door : doors_)
      if (door.house == rooms.front().house->id &&
          distance_to_segment_mm(place.at, door.a, door.b) < kSameDoor_m / 2 * kMmPerMetre)
        return;
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < rooms.size(); ++i)
      if (const double d = distance_m(rooms[i].outline, place.at); i == place.of_room || d <= kDoorReach_m)
        near.emplace_back(i == place.of_room ? -1 : d, i);
    std::sort(near.begin(), near.end());
    if (near.empty()) {
      if (place.is_sure) fail(place);
      return;
    }
    const auto spot = facade_spot(city_, rooms.front().house->id, place.at, kDoorReach_m);
    const bool has_other = near.size() > 1;
    const bool is_outer = spot && (!has_other || spot->distance_m <= near[1].first + kOuterWall_m);
    const bool is_hung = (is_outer && hang_street_door(rooms[near[0].second], *spot, place)) ||
                         (has_other && hang_inner_door(rooms[near[0].second], rooms[near[1].second], place));
    if (!is_hung && place.is_sure) fail(place);
  }

  void fail(const DoorPlace& place) {
    issue(IssueCode::door_off_wall,
          "The door stands on no wall between a room and a street, or another room, that has room for it; left out.",
          place.source_id, place.at);
  }

  bool hang_street_door(RoomDraft& room, const FacadeSpot& spot, const DoorPlace& place) {
    const double width_m = std::clamp(place.width_m > 0 ? place.width_m : kStreetDoor_m, kLeastDoor_m, kWidestDoor_m);
    const auto opening = opening_in(spot, width_m, room.house->footprint);
    if (!opening) return false;
    const auto [a, b] = *opening;
    const auto is_a_first = open_doorway(room.interior.sector.ground.outer, a, b, right_of(heading_of(a, b)));
    if (!is_a_first) return false;
    doors_.push_back({spot.sector_id, room.interior.sector.id, room.house->id, a, b, door_height(room), kLeafRecess_m});
    return true;
  }

  bool hang_inner_door(RoomDraft& room, RoomDraft& other, const DoorPlace& place) {
    const double width_m = std::clamp(place.width_m > 0 ? place.width_m : kInnerDoor_m, kLeastDoor_m, kWidestDoor_m);
    Ring &ring = room.interior.sector.ground.outer, &beyond = other.interior.sector.ground.outer;
    std::size_t edge = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (const double d = distance_to_segment_mm(place.at, ring[i], ring[(i + 1) % ring.size()]); d < least)
        least = d, edge = i;
    const PlanPoint p = ring[edge], q = ring[(edge + 1) % ring.size()];
    const Heading along = heading_of(p, q), out = right_of(along);
    const double t = (double(place.at.x) - p.x) * along.x + (double(place.at.y) - p.y) * along.y;
    const PlanPoint foot = moved(p, along, t);
    const auto hit = first_hit(beyond, foot, out);
    if (!hit || hit->distance_mm > kDeepestDoorway_m * kMmPerMetre) return false;
    const PlanPoint middle = moved(foot, out, hit->distance_mm / 2);
    const double half_mm = width_m / 2 * kMmPerMetre;
    const PlanPoint a = moved(middle, along, -half_mm), b = moved(middle, along, half_mm);
    const Ring before = ring;
    if (!open_doorway(ring, a, b, reversed(out))) return false;
    if (!open_doorway(beyond, a, b, out)) {
      ring = before;
      return false;
    }
    doors_.push_back({room.interior.sector.id, other.interior.sector.id, room.house->id, a, b,
                      std::min(door_height(room), door_height(other)), 0});
    return true;
  }

  static double door_height(const RoomDraft& room) {
    return std::min(kDoorHeight_m, room.interior.height_m - kOverDoor_m);
  }

  /// Rooms that no chain of doors joins to a street are left out, with their doors.
  void keep_reached() {
    std::set<std::string> rooms, reached;
    for (const auto& [house, list] : rooms_of_)
      for (const auto& room : list) rooms.insert(room.interior.sector.id);
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (const DoorDraft& d : doors_) {
        const bool from = !rooms.contains(d.from) || reached.contains(d.from);
        if (from && reached.insert(d.to).second) has_grown = true;
        if (reached.contains(d.to) && rooms.contains(d.from) && reached.insert(d.from).second) has_grown = true;
      }
    }
    std::erase_if(doors_, [&](const DoorDraft& d) { return !reached.contains(d.to); });
    for (auto& [house, list] : rooms_of_)
      std::erase_if(list, [&](const RoomDraft& room) {
        if (reached.contains(room.interior.sector.id)) return false;
        issue(IssueCode::room_without_door, "No door leads from a street to this room; left out.", room.room->source_id,
              room.outline.outer.front());
        return true;
      });
  }

  void write() {
    for (auto& [house, list] : rooms_of_)
      for (auto& room : list) {
        Sector& sector = room.interior.sector;
        const PlanBox box = box_of(sector.ground);
        sector.origin = {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
        canonicalise(sector.ground.outer);
        sector.ground_triangles = triangulate(sector.ground);
        city_.interiors.push_back(std::move(room.interior));
      }
    std::sort(city_.interiors.begin(), city_.interiors.end(),
              [](const Interior& a, const Interior& b) { return a.sector.id < b.sector.id; });
    std::sort(doors_.begin(), doors_.end(), [](const DoorDraft& x, const DoorDraft& y) {
      return std::tie(x.to, x.a, x.b) < std::tie(y.to, y.a, y.b);
    });
    std::map<std::string, int> numbers;
    for (const DoorDraft& d : doors_) {
      const std::string id = d.to + "-d" + std::to_string(++numbers[d.to]), twin = id + "-in";
      city_.doors.push_back({id, twin, d.from, d.to, d.house, d.a, d.b, 0, d.height_m, d.recess_m});
      city_.doors.push_back({twin, id, d.to, d.from, d.house, d.b, d.a, 0, d.height_m, -d.recess_m});
    }
  }

  const SourceMap& map_;
  City& city_;
  std::vector<std::pair<PlanBox, const Building*>> houses_;
  std::map<std::string, std::vector<RoomDraft>> rooms_of_;  // by house
  std::map<std::string, int> used_ids_;
  std::vector<DoorDraft> doors_;
};

}  // namespace

void add_interiors(const SourceMap& map, City& city) {
  city.interiors.clear();
  city.doors.clear();
  if (!map.rooms.empty()) InteriorWriter(map, city).run();
}

}  // namespace vicus
