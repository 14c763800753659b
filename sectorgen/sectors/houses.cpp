#include "sectorgen/sectors/houses.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "city_db/boxes.hpp"
#include "city_db/house_parts.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"

namespace vicus {

Facades::Facades(const Plan& plan, const Bends& bends) : sides_(feature_sides(plan.noded, MapLayer::house, bends)) {}

std::uint32_t Facades::house_behind(PlanPoint a, PlanPoint b) const {
  const auto it = std::lower_bound(sides_.begin(), sides_.end(), FeatureSide{b, a, 0});
  return it != sides_.end() && it->a == b && it->b == a ? it->feature : kNone;
}

template <class Visit>
void Facades::visit(PlanPoint a, PlanPoint b, Visit visit) const {
  for (auto it = std::lower_bound(sides_.begin(), sides_.end(), FeatureSide{a, b, 0});
       it != sides_.end() && it->a == a && it->b == b; ++it)
    visit(it->feature);
}

namespace {

constexpr double kLeastWall = 0.05;  // m: lower steps between neighbours are not modelled

std::string building_id(const std::string& source_id) {
  std::string id;
  for (char c : source_id) id += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ? c : '-';
  return id.empty() ? "b" : id;
}

/// What a part takes over from its house where it says nothing itself: what it is made of, and the main one whose it
/// is.
void inherit(const Tags& outline, bool is_main, Tags& part) {
  static const std::set<std::string> looks = {"building",    "building:colour", "building:material",
                                              "roof:colour", "roof:material",   "building:architecture",
                                              "start_date"};
  const auto is_shape = [](const std::string& key) {
    return key.starts_with("roof:") || key.starts_with("building:") || key.starts_with("min_") || key == "height";
  };
  for (const auto& [key, value] : outline)
    if (looks.contains(key) || (is_main && !is_shape(key))) part.emplace(key, value);
}

}  // namespace

struct HouseWriter {
  const SourceMap& map;
  const Plan& plan;
  const Bends& bends;
  const Facades& facades;
  const std::vector<std::pair<PlanPoint, PlanPoint>>& closed_edges;
  City& city;
  std::map<std::string, int> used_ids;
  std::vector<std::vector<std::uint32_t>> buildings_of;  // per house: indices into city.buildings

  const Footprint& footprint(std::uint32_t house) const { return map.footprints[plan.blocks.houses[house].footprint]; }

  std::string new_id(const std::string& source_id) {
    const std::string id = building_id(source_id);
    const int n = used_ids[id]++;
    return n == 0 ? id : new_id(id + "-" + std::to_string(n + 1));
  }

  void add(std::uint32_t house, Polygon area) {
    const Footprint& f = footprint(house);
    const House& h = plan.blocks.houses[house];
    const Footprint& outline = map.footprints[h.outline];
    Building b;
    b.source_id = h.is_main ? outline.source_id : f.source_id;
    b.id = new_id(b.source_id);
    b.name = h.is_main && !outline.name.empty() ? outline.name : f.name;
    b.base_m = h.is_overhead ? h.base_m : 0;
    b.height_m = std::max(h.height_m, b.base_m + 0.5);
    b.eave_m = std::clamp(h.eave_m, b.base_m + 0.2, b.height_m);
    b.roof_shape = f.roof_shape;
    b.height_source = f.height_source;
    b.tags = f.tags;
    if (h.outline != h.footprint) inherit(outline.tags, h.is_main, b.tags);
    if (h.is_column) b.tags[kPartOf] = outline.source_id;
    b.footprint = std::move(area);
    buildings_of[house].push_back(static_cast<std::uint32_t>(city.buildings.size()));
    city.buildings.push_back(std::move(b));
  }

  /// The building of the house one of whose edges runs b -> a.
  std::uint32_t building_with_edge(std::uint32_t house, PlanPoint a, PlanPoint b) const {
    const auto& list = buildings_of[house];
    if (list.size() == 1) return list.front();
    for (std::uint32_t i : list) {
      const auto has = [&](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k)
          if (ring[k] == b && ring[(k + 1) % ring.size()] == a) return true;
        return false;
      };
      const Polygon& p = city.buildings[i].footprint;
      if (has(p.outer)) return i;
      for (const auto& hole : p.holes)
        if (has(hole)) return i;
    }
    return list.empty() ? kNone : list.front();
  }

  /// Facade records get their building's id; each building goes with the sector that has most of its facades.
  void name_facades() {
    std::vector<std::map<std::string, std::int64_t>> shares(city.buildings.size());
    std::vector<Border> borders;
    for (auto& border : city.borders) {
      if (border.kind != BorderKind::facade || border.building_id.empty()) {
        borders.push_back(std::move(border));
        continue;
      }
      // A house that rounding or a passage took apart is several buildings: one record for each stretch.
      const auto house = static_cast<std::uint32_t>(std::stoul(border.building_id));
      std::uint32_t last = kNone;
      for (std::size_t k = 0; k + 1 < border.line.size(); ++k) {
        const std::uint32_t i = building_with_edge(house, border.line[k], border.line[k + 1]);
        if (i == kNone) continue;
        shares[i][border.sector_id] += length_mm(border.line[k], border.line[k + 1]);
        if (i != last || k == 0)
          borders.push_back({border.sector_id, city.buildings[i].id, border.kind, border.height_m, {border.line[k]}});
        borders.back().line.push_back(border.line[k + 1]);
        last = i;
      }
    }
    city.borders = std::move(borders);
    std::vector<PlanBox> placed;
    std::vector<std::uint32_t> placed_building;
    for (std::uint32_t i = 0; i < city.buildings.size(); ++i) {
      std::int64_t most = 0;
      for (const auto& [sector, mm] : shares[i])
        if (mm > most) most = mm, city.buildings[i].sector_id = sector;
      if (most == 0) continue;
      placed.push_back(box_of(city.buildings[i].footprint));
      placed_building.push_back(i);
    }
    const BoxIndex index(placed);
    for (auto& b : city.buildings)
      if (b.sector_id.empty()) b.sector_id = nearest(b, index, placed, placed_building);
  }

  /// The sector of the nearest building that has one, or that holds the ground below.
  std::string nearest(const Building& b, const BoxIndex& index, const std::vector<PlanBox>& boxes,
                      const std::vector<std::uint32_t>& buildings) const {
    PlanBox box = box_of(b.footprint);
    const PlanPoint centre{box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
    for (std::int32_t margin = 2'000; margin < 1'000'000; margin *= 3) {
      const PlanBox around{{box.min.x - margin, box.min.y - margin}, {box.max.x + margin, box.max.y + margin}};
      std::uint32_t best = kNone;
      std::int64_t least = 0;
      for (std::uint32_t i : index.meeting(around)) {
        const PlanPoint c{boxes[i].min.x + (boxes[i].max.x - boxes[i].min.x) / 2,
                          boxes[i].min.y + (boxes[i].max.y - boxes[i].min.y) / 2};
        const std::int64_t d = distance2(c, centre);
        if (best == kNone || d < least) best = buildings[i], least = d;
      }
      if (best != kNone) return city.buildings[best].sector_id;
    }
    return city.sectors.empty() ? "" : city.sectors.front().id;
  }

  /// Walls that bound no sector's ground: above a lower neighbour, towards ground that was closed off.
  void add_side_walls() {
    std::vector<std::pair<PlanPoint, PlanPoint>> ground;
    for (const auto& border : city.borders)
      if (border.kind == BorderKind::facade)
        for (std::size_t k = 0; k + 1 < border.line.size(); ++k) ground.push_back({border.line[k], border.line[k + 1]});
    std::sort(ground.begin(), ground.end());
    for (auto& b : city.buildings) {
      if (b.base_m > 0) continue;  // the exporter draws all walls of what hangs in the air
      const auto ring = [&](const Ring& r) {
        for (std::size_t i = 0; i < r.size(); ++i) {
          const PlanPoint p = r[i], q = r[(i + 1) % r.size()];
          if (std::binary_search(ground.begin(), ground.end(), std::make_pair(q, p))) continue;
          double bottom = -1;
          facades.visit(q, p,
                        [&](std::uint32_t house) { bottom = std::max(bottom, plan.blocks.houses[house].eave_m); });
          if (bottom < 0) {
            if (!std::binary_search(closed_edges.begin(), closed_edges.end(), std::make_pair(q, p))) continue;
            bottom = 0;
          }
          if (bottom + kLeastWall < b.eave_m) b.side_walls.push_back({p, q, bottom});
        }
      };
      ring(b.footprint.outer);
      for (const auto& hole : b.footprint.holes) ring(hole);
    }
  }
};

void write_houses(const SourceMap& map, const Plan& plan, const Bends& bends, const Facades& facades,
                  const std::vector<std::pair<PlanPoint, PlanPoint>>& closed_edges, City& city) {
  HouseWriter writer{map, plan, bends, facades, closed_edges, city, {}, {}};
  writer.buildings_of.resize(plan.blocks.houses.size());
  for_features(plan.noded, bends, [&](MapLayer layer, std::uint32_t house, Polygon area) {
    if (layer == MapLayer::house || layer == MapLayer::overhead) writer.add(house, std::move(area));
  });
  writer.name_facades();
  writer.add_side_walls();
}

}  // namespace vicus
