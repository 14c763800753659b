#include "x3d_export/city_index.hpp"
#include "city_db/boxes.hpp"

#include <algorithm>
#include <cassert>

namespace vicus {
namespace {

template <class T>
const std::vector<const T*>& find_list(const std::map<std::string, std::vector<const T*>>& lists,
                                       const std::string& key) {
  static const std::vector<const T*> kNone;
  const auto at = lists.find(key);
  return at == lists.end() ? kNone : at->second;
}

template <class T>
void sort_by_id(std::map<std::string, std::vector<const T*>>& lists) {
  for (auto& [key, list] : lists)
    std::stable_sort(list.begin(), list.end(), [](const T* a, const T* b) { return a->id < b->id; });
}

template <class T>
std::vector<T> copies(const std::vector<const T*>& list) {
  std::vector<T> out;
  for (const T* item : list) out.push_back(*item);
  return out;
}

}  // namespace

PlanPoint point_inside(const Sector& sector) {
  assert(!sector.ground.outer.empty());
  std::vector<PlanPoint> points = sector.ground.outer;
  for (const auto& hole : sector.ground.holes) points.insert(points.end(), hole.begin(), hole.end());
  const auto mean = [](std::int64_t p, std::int64_t q, std::int64_t r) {
    return static_cast<std::int32_t>((p + q + r) / 3);
  };
  PlanPoint best = points.front();
  std::int64_t largest = 0;
  const auto& t = sector.ground_triangles;
  for (std::size_t i = 0; i + 2 < t.size(); i += 3) {
    const PlanPoint a = points.at(t[i]), b = points.at(t[i + 1]), c = points.at(t[i + 2]);
    const std::int64_t ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y, area2 = ux * vy - uy * vx;
    if (area2 <= largest) continue;
    largest = area2;
    best = {mean(a.x, b.x, c.x), mean(a.y, b.y, c.y)};
  }
  return best;
}

CityIndex::CityIndex(const City& city) : city_(&city) {
  for (const auto& s : city.sectors) sectors_.emplace(s.id, &s);
  for (const auto& b : city.buildings) {
    buildings_.emplace(b.id, &b);
    buildings_of_[b.sector_id].push_back(&b);
  }
  for (const auto& i : city.interiors) interiors_.emplace(i.sector.id, &i);
  for (const auto& d : city.doors) doors_of_[d.sector_id].push_back(&d);
  for (const auto& g : city.gates) gates_of_[g.sector_id].push_back(&g);
  for (const auto& b : city.borders) borders_of_[b.sector_id].push_back(&b);
  for (const auto& f : city.facades) facades_of_[f.sector_id].push_back(&f);
  for (const auto& o : city.objects) objects_of_[o.sector_id].push_back(&o);
  for (const auto& s : city.surfaces) surfaces_of_[s.sector_id].push_back(&s);
  for (const auto& r : city.rides) rides_of_[r.sector_id].push_back(&r);
  for (const auto& p : city.prototypes) prototypes_.emplace(p.kind, &p);
  for (const auto& v : city.viewpoints) viewpoints_of_[v.sector_id].push_back(&v);
  for (const auto& i : city.impostors) impostors_of_[i.sector_id].push_back(&i);
  for (const auto& p : city.panoramas) panoramas_.emplace(p.sector_id, &p);
  for (const auto& v : city.visible) {
    visible_from_[v.sector_id].push_back(&v);
    if (!v.building_ids.empty())
      tall_houses_of_[v.visible_sector_id].insert(v.building_ids.begin(), v.building_ids.end());
  }
  sort_by_id(gates_of_);
  sort_by_id(doors_of_);
  sort_by_id(buildings_of_);
  sort_by_id(objects_of_);
  sort_by_id(viewpoints_of_);
  for (auto& [key, list] : visible_from_)
    std::stable_sort(list.begin(), list.end(),
                     [](const Visible* a, const Visible* b) { return a->visible_sector_id < b->visible_sector_id; });
}

const Sector* CityIndex::sector(const std::string& id) const {
  const auto at = sectors_.find(id);
  return at == sectors_.end() ? nullptr : at->second;
}
const Building* CityIndex::building(const std::string& id) const {
  const auto at = buildings_.find(id);
  return at == buildings_.end() ? nullptr : at->second;
}
const Interior* CityIndex::interior(const std::string& id) const {
  const auto at = interiors_.find(id);
  return at == interiors_.end() ? nullptr : at->second;
}
const std::vector<const Door*>& CityIndex::doors_of(const std::string& id) const { return find_list(doors_of_, id); }
const std::vector<const Gate*>& CityIndex::gates_of(const std::string& id) const { return find_list(gates_of_, id); }
const std::vector<const Border*>& CityIndex::borders_of(const std::string& id) const {
  return find_list(borders_of_, id);
}
const std::vector<const Facade*>& CityIndex::facades_of(const std::string& id) const {
  return find_list(facades_of_, id);
}
const std::vector<const Building*>& CityIndex::buildings_of(const std::string& id) const {
  return find_list(buildings_of_, id);
}
const std::vector<const StandaloneObject*>& CityIndex::objects_of(const std::string& id) const {
  return find_list(objects_of_, id);
}
const std::vector<const Surface*>& CityIndex::surfaces_of(const std::string& id) const {
  return find_list(surfaces_of_, id);
}
const std::vector<const Ride*>& CityIndex::rides_of(const std::string& id) const { return find_list(rides_of_, id); }
const Prototype* CityIndex::prototype(const std::string& kind) const {
  const auto at = prototypes_.find(kind);
  return at == prototypes_.end() ? nullptr : at->second;
}
const std::vector<const Viewpoint*>& CityIndex::viewpoints_of(const std::string& id) const {
  return find_list(viewpoints_of_, id);
}
const std::vector<const Visible*>& CityIndex::visible_from(const std::string& id) const {
  return find_list(visible_from_, id);
}
const std::vector<const GateImpostor*>& CityIndex::impostors_of(const std::string& id) const {
  return find_list(impostors_of_, id);
}
const Panorama* CityIndex::panorama_of(const std::string& id) const {
  const auto at = panoramas_.find(id);
  return at == panoramas_.end() ? nullptr : at->second;
}
const std::set<std::string>& CityIndex::tall_houses_of(const std::string& id) const {
  static const std::set<std::string> kNone;
  const auto at = tall_houses_of_.find(id);
  return at == tall_houses_of_.end() ? kNone : at->second;
}

RecordSource source_of(const CityIndex& index) {
  RecordSource source;
  source.sector = [&index](const std::string& id) {
    const Sector* s = index.sector(id);
    if (s) return std::optional<Sector>(*s);
    const Interior* room = index.interior(id);
    return room ? std::optional<Sector>(room->sector) : std::nullopt;
  };
  source.gates_of = [&index](const std::string& id) { return copies(index.gates_of(id)); };
  source.doors_of = [&index](const std::string& id) { return copies(index.doors_of(id)); };
  source.viewpoints_of = [&index](const std::string& id) { return copies(index.viewpoints_of(id)); };
  source.objects_of = [&index](const std::string& id) { return copies(index.objects_of(id)); };
  source.visible_from = [&index](const std::string& id) { return copies(index.visible_from(id)); };
  source.impostors_of = [&index](const std::string& id) { return copies(index.impostors_of(id)); };
  source.panorama_of = [&index](const std::string& id) {
    const Panorama* p = index.panorama_of(id);
    return p ? std::optional(*p) : std::nullopt;
  };
  source.houses_in = [&index](const PlanBox& box) {
    std::vector<Building> houses;
    for (const auto& house : index.city().buildings)
      if (meet(box_of(house.footprint), box)) houses.push_back(house);
    return houses;
  };
  source.sector_ids = [&index] {
    std::vector<std::string> ids;
    for (const auto& s : index.city().sectors) ids.push_back(s.id);
    std::sort(ids.begin(), ids.end());
    return ids;
  };
  source.meta = [&index](const std::string& key) {
    const auto at = index.city().meta.find(key);
    return at == index.city().meta.end() ? std::string() : at->second;
  };
  return source;
}

}  // namespace vicus
