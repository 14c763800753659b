#include <algorithm>
#include <map>
#include <set>

#include "city_db/boxes.hpp"
#include "city_db/polygon_edges.hpp"
#include "city_db/rules_exact.hpp"
#include "city_db/rules_parts.hpp"
#include "city_db/segment.hpp"
#include "city_db/wall_stretches.hpp"

/// Interiors: no part of the walkable ground, so they have rules of their own, under the headings of DESIGN §3.
namespace vicus::rules {
namespace {

enum class Place { outside, edge, inside };

Place place_in(const Polygon& polygon, PlanPoint p) {
  bool inside = false, on_edge = false;
  visit_edges(polygon, [&](PlanPoint a, PlanPoint b) {
    const auto side = orient(a, b, p);
    on_edge = on_edge || p == a || p == b || is_inside_segment(p, a, b);
    if ((a.y > p.y) != (b.y > p.y) && (side > 0) == (b.y > a.y)) inside = !inside;
  });
  return on_edge ? Place::edge : inside ? Place::inside : Place::outside;
}

bool any_edges_cross(const Polygon& a, const Polygon& b) {
  bool found = false;
  visit_edges(a, [&](PlanPoint p, PlanPoint q) {
    visit_edges(b, [&](PlanPoint r, PlanPoint s) { found = found || cross_properly(p, q, r, s); });
  });
  return found;
}

bool any_corner(const Polygon& of, const Polygon& in, Place place) {
  bool found = false;
  visit_edges(of, [&](PlanPoint p, PlanPoint) { found = found || place_in(in, p) == place; });
  return found;
}

bool has_edge(const Polygon& polygon, PlanPoint a, PlanPoint b) {
  bool found = false;
  visit_edges(polygon, [&](PlanPoint p, PlanPoint q) { found = found || (p == a && q == b); });
  return found;
}

/// The wall of the house along the street: both ends within kWallReach_mm of a facade border of the sector.
bool stands_in_facade(const Door& door, const City& city) {
  bool has_a = false, has_b = false;
  for (const Border& border : city.borders) {
    if (border.kind != BorderKind::facade || border.sector_id != door.sector_id ||
        border.building_id != door.building_id)
      continue;
    for (std::size_t i = 0; i + 1 < border.line.size(); ++i) {
      has_a = has_a || distance_to_segment_mm(door.a, border.line[i], border.line[i + 1]) <= kWallReach_mm;
      has_b = has_b || distance_to_segment_mm(door.b, border.line[i], border.line[i + 1]) <= kWallReach_mm;
    }
  }
  return has_a && has_b;
}

class InteriorRules {
 public:
  InteriorRules(const Subject& subject, Findings& findings) : subject_(subject), findings_(findings) {
    for (const Interior& room : subject.city.interiors) rooms_.emplace(room.sector.id, &room);
    for (const Door& door : subject.city.doors) doors_.emplace(door.id, &door);
  }

  void run() {
    check_ids();
    for (const Interior& room : subject_.city.interiors) check_place(room);
    check_disjoint();
    for (const Door& door : subject_.city.doors) check_door(door);
    check_reached();
  }

 private:
  static PlanPoint place_of(const Interior& room) {
    return room.sector.ground.outer.empty() ? PlanPoint{} : room.sector.ground.outer.front();
  }

  void check_ids() {
    const City& city = subject_.city;
    if (rooms_.size() != city.interiors.size()) findings_.add(Rule::identity, "", {}, "two interiors have one id");
    if (doors_.size() != city.doors.size()) findings_.add(Rule::identity, "", {}, "two doors have one id");
    for (const Interior& room : city.interiors)
      if (find_index(subject_.sectors, room.sector.id) != kNone)
        findings_.add(Rule::identity, room.sector.id, place_of(room), "the interior has the id of a sector");
  }

  void check_place(const Interior& room) {
    const std::string& id = room.sector.id;
    if (room.sector.ground.outer.size() < 3)
      return findings_.add(Rule::houses_whole, id, place_of(room), "the interior has no ground");
    const auto house = find_index(subject_.buildings, room.building_id);
    if (house == kNone)
      return findings_.add(Rule::identity, id, place_of(room),
                           "the interior names the house \"" + room.building_id + "\", which does not exist");
    const Polygon& footprint = subject_.city.buildings[house].footprint;
    if (any_corner(room.sector.ground, footprint, Place::outside) || any_edges_cross(room.sector.ground, footprint))
      findings_.add(Rule::houses_whole, id, place_of(room), "the interior reaches out of its house");
  }

  void check_disjoint() {
    const auto& rooms = subject_.city.interiors;
    for (std::size_t i = 0; i < rooms.size(); ++i)
      for (std::size_t k = i + 1; k < rooms.size(); ++k) {
        const Polygon &a = rooms[i].sector.ground, &b = rooms[k].sector.ground;
        if (!meet(box_of(a), box_of(b))) continue;
        if (any_edges_cross(a, b) || any_corner(a, b, Place::inside) || any_corner(b, a, Place::inside))
          findings_.add(Rule::houses_whole, rooms[i].sector.id, place_of(rooms[i]),
                        "the interior overlaps " + rooms[k].sector.id);
      }
  }

  void check_door(const Door& door) {
    const auto twin = doors_.find(door.twin_id);
    if (twin == doors_.end() || twin->second->twin_id != door.id || twin->second->sector_id != door.to_sector_id ||
        twin->second->to_sector_id != door.sector_id || twin->second->a != door.b || twin->second->b != door.a)
      findings_.add(Rule::edges, door.id, door.a, "the door has no twin with the same ends on its other side");
    const auto room = rooms_.find(door.sector_id);
    if (room != rooms_.end()) {
      if (!has_edge(room->second->sector.ground, door.a, door.b))
        findings_.add(Rule::edges, door.id, door.a, "the door is no edge of its interior's ground");
    } else if (find_index(subject_.sectors, door.sector_id) == kNone) {
      findings_.add(Rule::identity, door.id, door.a,
                    "the door names the sector \"" + door.sector_id + "\", which does not exist");
    } else if (!stands_in_facade(door, subject_.city)) {
      findings_.add(Rule::edges, door.id, door.a, "the door stands in no facade along its sector");
    }
  }

  /// Every interior has a chain of doors to a sector of the streets.
  void check_reached() {
    std::set<std::string> reached;
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (const auto& [id, door] : doors_)
        if (rooms_.contains(door->to_sector_id) &&
            (find_index(subject_.sectors, door->sector_id) != kNone || reached.contains(door->sector_id)))
          has_grown = reached.insert(door->to_sector_id).second || has_grown;
    }
    for (const auto& [id, room] : rooms_)
      if (!reached.contains(id))
        findings_.add(Rule::connected, id, place_of(*room), "no chain of doors leads from a street to the interior");
  }

  const Subject& subject_;
  Findings& findings_;
  std::map<std::string, const Interior*> rooms_;
  std::map<std::string, const Door*> doors_;
};

}  // namespace

void check_interiors(const Subject& subject, Findings& findings) { InteriorRules(subject, findings).run(); }

}  // namespace vicus::rules
