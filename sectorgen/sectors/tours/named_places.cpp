#include "sectorgen/sectors/tours/named_places.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <unordered_map>

namespace vicus {
namespace {

constexpr double kBeforeDoor_mm = 2500;  // one stands so far from a front to look at it
constexpr double kBeforeLeaf_mm = 1200;  // so far from a door that opens
constexpr double kSquareWeight = 0.9, kSightWeight = 0.8, kStreetWeight = 0.7, kNamedWeight = 0.5, kShopWeight = 0.4,
                 kAddressWeight = 0.2;

const std::string& tag(const Tags& tags, const char* key) {
  static const std::string kEmpty;
  const auto found = tags.find(key);
  return found == tags.end() ? kEmpty : found->second;
}

bool is_sight_kind(const std::string& kind) {
  static const std::set<std::string> kSights = {
      "artwork",   "attraction", "memorial",   "monument",  "museum",      "statue", "fountain",         "gallery",
      "theatre",   "viewpoint",  "castle",     "city_gate", "arts_centre", "cinema", "place_of_worship", "church",
      "cathedral", "chapel",     "synagogue",  "mosque",    "townhall",    "tower",  "windmill",         "ruins",
      "palace",    "library",    "opera_house"};
  return kSights.count(kind) > 0;
}

/// What a house is, from its tags; empty: a house.
std::string kind_of_house(const Tags& tags) {
  for (const char* key : {"tourism", "historic", "amenity", "shop", "office", "leisure"})
    if (const auto& value = tag(tags, key); !value.empty() && value != "yes" && value != "no") return value;
  const auto& building = tag(tags, "building");
  return is_sight_kind(building) ? building : "";
}

double ground_m2(const Sector& sector) {
  double twice = 0;
  const auto& ring = sector.ground.outer;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    twice += metres(a.x) * metres(b.y) - metres(a.y) * metres(b.x);
  }
  return twice / 2;
}

/// Where one stands before a wall a -> b, ground on its left, and the wall's middle.
struct Front {
  PlanPoint at, look;
  double length_mm = 0;
  bool has_door = false;
  std::string sector_id;
};

Front front_of(PlanPoint a, PlanPoint b, const std::string& sector_id, bool has_door,
               double before_mm = kBeforeDoor_mm) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, length = std::hypot(dx, dy);
  Front front;
  front.look = {static_cast<std::int32_t>((std::int64_t{a.x} + b.x) / 2),
                static_cast<std::int32_t>((std::int64_t{a.y} + b.y) / 2)};
  front.length_mm = length;
  front.has_door = has_door;
  front.sector_id = sector_id;
  if (length > 0)
    front.at = {front.look.x - static_cast<std::int32_t>(std::lround(before_mm * dy / length)),
                front.look.y + static_cast<std::int32_t>(std::lround(before_mm * dx / length))};
  return front;
}

class Places {
 public:
  explicit Places(const City& city) : city_(city) {
    for (const auto& s : city.sectors) sectors_.emplace(s.id, &s);
  }

  std::vector<NamedPlace> list() {
    add_streets();
    add_objects();
    add_houses();
    add_rooms();
    return std::move(places_);
  }

 private:
  void add(std::string name, std::string kind, std::string detail, const std::string& sector_id, PlanPoint at,
           PlanPoint look, double weight) {
    NamedPlace named;
    named.place.name = std::move(name);
    named.place.kind = std::move(kind);
    named.place.detail = std::move(detail);
    named.place.sector_id = sector_id;
    named.place.at = at;
    named.place.look = look;
    named.weight = weight;
    named.is_sight = is_sight_kind(named.place.kind) || named.place.kind == "square";
    places_.push_back(std::move(named));
  }

  std::string street_of(const std::string& sector_id) const {
    const auto sector = sectors_.find(sector_id);
    return sector == sectors_.end() ? "" : sector->second->name;
  }

  void add_streets() {
    std::map<std::string, const Sector*> widest;
    const auto offer = [&](const std::string& name, const Sector& s) {
      if (name.empty()) return;
      const Sector*& best = widest[name];
      const auto rank = [&](const Sector& x) { return std::pair(x.name == name, ground_m2(x)); };
      if (best == nullptr || rank(s) > rank(*best)) best = &s;
    };
    for (const auto& s : city_.sectors) {
      offer(s.name, s);
      for (const auto& name : s.names) offer(name, s);
    }
    std::unordered_map<std::string, const Viewpoint*> views;
    for (const auto& v : city_.viewpoints)
      if (v.kind != "gate") views.emplace(v.sector_id, &v);
    for (const auto& [name, sector] : widest) {
      const auto view = views.find(sector->id);
      const PlanPoint at = view == views.end() ? middle_of(*sector) : view->second->at;
      const bool is_square = sector->kind == SectorKind::square;
      add(name, is_square ? "square" : "street", "", sector->id, at, at, is_square ? kSquareWeight : kStreetWeight);
    }
  }

  void add_objects() {
    for (const auto& o : city_.objects) {
      if (o.kind == "sign") continue;  // of a shop that is there itself
      const auto address = address_of(o.tags, street_of(o.sector_id));
      const std::string street = street_of(o.sector_id);
      if (!o.name.empty())
        add(o.name, o.kind, address.empty() ? street : address, o.sector_id, o.at, o.at,
            is_sight_kind(o.kind) ? kSightWeight : kShopWeight);
      if (!address.empty() && addresses_.insert(address).second)
        add(address, "house", "", o.sector_id, o.at, o.at, kAddressWeight);
    }
  }

  void add_houses() {
    std::unordered_map<std::string, std::vector<Front>> fronts;
    for (const auto& border : city_.borders)
      if (border.kind == BorderKind::facade)
        for (std::size_t i = 0; i + 1 < border.line.size(); ++i)
          fronts[border.building_id].push_back(front_of(border.line[i], border.line[i + 1], border.sector_id, false));
    for (const auto& f : city_.facades)
      if (f.door_bay >= 0) fronts[f.building_id].push_back(front_of(f.a, f.b, f.sector_id, true));
    for (const auto& b : city_.buildings) {
      const auto& its = fronts[b.id];
      const auto& named_street = tag(b.tags, "addr:street");
      const auto rank = [&](const Front& f) {
        const auto sector = sectors_.find(f.sector_id);
        const bool is_there =
            sector != sectors_.end() && !named_street.empty() &&
            (sector->second->name == named_street ||
             std::count(sector->second->names.begin(), sector->second->names.end(), named_street) > 0);
        return std::tuple(is_there, f.has_door, f.length_mm);
      };
      const auto best =
          std::max_element(its.begin(), its.end(), [&](const Front& a, const Front& c) { return rank(a) < rank(c); });
      const std::string sector_id = best == its.end() ? b.sector_id : best->sector_id;
      const auto address = address_of(b.tags, street_of(sector_id));
      if (b.name.empty() && address.empty()) continue;
      const PlanPoint look = best == its.end() ? b.footprint.outer.front() : best->look,
                      at = best == its.end() ? look : best->at;
      const auto kind = kind_of_house(b.tags);
      if (!b.name.empty())
        add(b.name, kind.empty() ? "house" : kind, address.empty() ? street_of(sector_id) : address, sector_id, at,
            look, is_sight_kind(kind) ? kSightWeight : kNamedWeight);
      if (!address.empty() && addresses_.insert(address).second)
        add(address, "house", "", sector_id, at, look, kAddressWeight);
    }
  }

  void add_rooms() {
    std::set<std::string> named;
    for (const auto& room : city_.interiors)
      if (!room.sector.name.empty()) named.insert(room.sector.id);
    for (auto& [id, place] : interior_places(city_))
      if (named.contains(id)) places_.push_back({place, kNamedWeight, false});
  }

  const City& city_;
  std::unordered_map<std::string, const Sector*> sectors_;
  std::set<std::string> addresses_;
  std::vector<NamedPlace> places_;
};

}  // namespace

std::vector<NamedPlace> named_places(const City& city) { return Places(city).list(); }

std::map<std::string, TourPlace> interior_places(const City& city) {
  std::unordered_map<std::string, const Sector*> streets;
  for (const auto& s : city.sectors) streets.emplace(s.id, &s);
  std::unordered_map<std::string, const Building*> houses;
  for (const auto& b : city.buildings) houses.emplace(b.id, &b);
  // Breadth-first from the streets in: the first to come to a room came by the fewest doors.
  std::unordered_map<std::string, std::vector<const Door*>> inner;  // by the room they lead from
  std::deque<std::pair<const Door*, const Door*>> ways;             // a door, and the street's side of the first one
  for (const auto& d : city.doors)
    if (streets.contains(d.sector_id))
      ways.emplace_back(&d, &d);
    else
      inner[d.sector_id].push_back(&d);
  std::unordered_map<std::string, const Door*> entrance;  // by interior
  for (; !ways.empty(); ways.pop_front()) {
    const auto [door, first] = ways.front();
    if (streets.contains(door->to_sector_id) || !entrance.emplace(door->to_sector_id, first).second) continue;
    for (const Door* next : inner[door->to_sector_id]) ways.emplace_back(next, first);
  }
  std::map<std::string, TourPlace> places;
  for (const auto& room : city.interiors) {
    const auto door = entrance.find(room.sector.id);
    if (door == entrance.end()) continue;
    const Front front = front_of(door->second->a, door->second->b, door->second->sector_id, true, kBeforeLeaf_mm);
    const std::string& street = streets.at(front.sector_id)->name;
    TourPlace place;
    place.name = room.sector.name.empty() ? room.sector.id : room.sector.name;
    place.kind = "room";
    if (const auto house = houses.find(room.building_id); house != houses.end()) {
      const Building& b = *house->second;
      place.detail = b.name.empty() || b.name == place.name ? address_of(b.tags, street) : b.name;
    }
    if (place.detail.empty()) place.detail = street;
    place.sector_id = front.sector_id;
    place.at = front.at;
    place.look = front.look;
    places.emplace(room.sector.id, std::move(place));
  }
  return places;
}

PlanPoint middle_of(const Sector& sector) {
  std::vector<PlanPoint> points = sector.ground.outer;
  for (const auto& hole : sector.ground.holes) points.insert(points.end(), hole.begin(), hole.end());
  std::int64_t widest = -1;
  PlanPoint middle = points.front();
  const auto& t = sector.ground_triangles;
  for (std::size_t i = 0; i + 2 < t.size(); i += 3) {
    const PlanPoint a = points[t[i]], b = points[t[i + 1]], c = points[t[i + 2]];
    const std::int64_t twice =
        (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
    if (twice <= widest) continue;
    widest = twice;
    middle = {static_cast<std::int32_t>((std::int64_t{a.x} + b.x + c.x) / 3),
              static_cast<std::int32_t>((std::int64_t{a.y} + b.y + c.y) / 3)};
  }
  return middle;
}

std::string address_of(const Tags& tags, const std::string& street) {
  const auto& number = tag(tags, "addr:housenumber");
  if (number.empty()) return "";
  for (const char* key : {"addr:street", "addr:place"})
    if (const auto& named = tag(tags, key); !named.empty()) return named + " " + number;
  return street.empty() ? "" : street + " " + number;
}

}  // namespace vicus
