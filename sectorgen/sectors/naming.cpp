#include "sectorgen/sectors/naming.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "city_db/boxes.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/box_index.hpp"

namespace vicus {
namespace {

constexpr std::int64_t kBearsNameMm = 6'000;  // of centre line inside: the sector bears the street's name
constexpr double kOpenM2 = 3'000;
constexpr double kOpenEnds = 4;         // of its width: a street is open at its ends, a row of gardens along its side
constexpr double kStreetOpening = 5.0;  // m (research/SECTORS.md §6)

/// Area of the cells' triangles whose centre lies in each of the polygons: (cell, polygon) -> m2.
std::map<std::pair<std::uint32_t, std::uint32_t>, double> covered(const Plan& plan,
                                                                  const std::vector<Polygon>& polygons) {
  std::vector<PlanBox> boxes;
  for (const auto& p : polygons) boxes.push_back(box_of(p));
  const BoxIndex index(boxes);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> out;
  if (polygons.empty()) return out;
  const Mesh& mesh = plan.ground.mesh;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t c = plan.cells.of[t];
    if (c == kNone) continue;
    const auto& k = mesh.triangles[t].corner;
    const PlanPoint a = mesh.points[k[0]], b = mesh.points[k[1]], d = mesh.points[k[2]];
    const PlanPoint centre{static_cast<std::int32_t>((std::int64_t{a.x} + b.x + d.x) / 3),
                           static_cast<std::int32_t>((std::int64_t{a.y} + b.y + d.y) / 3)};
    for (std::uint32_t i : index.meeting({centre, centre}))
      if (locate(polygons[i], centre) != Side::outside) out[{c, i}] += static_cast<double>(orient(a, b, d)) / 2e6;
  }
  return out;
}

/// Longer than wide, with openings into two different streets at its ends: a street nobody mapped.
bool looks_like_street(const City& city, std::uint32_t c, const std::vector<std::vector<const Gate*>>& gates,
                       const Cells& cells) {
  std::set<std::string> into;
  double open = 0;  // m of its sides
  for (const Gate* g : gates[c]) {
    if (g->kind == GateKind::end_of_city || cells.kind[std::stoul(g->to_sector_id)] == CellKind::yard) continue;
    const double width = metres(length_mm(g->line.front(), g->line.back()));
    open += width;
    if (width >= kStreetOpening) into.insert(g->to_sector_id);
  }
  if (into.size() < 2) return false;
  const auto& s = city.sectors[c];
  const double length = diameter_m(convex_hull(s.ground.outer)), width = area_m2(s.ground) / length;
  return length > 3 * width && width < 40 && open < kOpenEnds * width;
}

}  // namespace

void name_sectors(const SourceMap& map, const Plan& plan, City& city) {
  const std::size_t n = city.sectors.size();
  std::vector<std::map<std::uint32_t, std::int64_t>> length(n);
  for (const auto& use : plan.routes.uses)
    if (plan.cells.of[use.triangle] != kNone) length[plan.cells.of[use.triangle]][use.name] += use.mm;

  std::vector<Polygon> squares, parks;
  std::vector<std::string> square_names, park_names;
  for (const auto& area : map.areas) {
    if (area.kind == AreaKind::square) squares.push_back(area.area), square_names.push_back(area.name);
    if (area.kind == AreaKind::park) parks.push_back(area.area), park_names.push_back(area.name);
  }
  const auto in_square = covered(plan, squares), in_park = covered(plan, parks),
             in_passage = covered(plan, plan.blocks.passages);
  const auto best_area = [&](const auto& cover, std::uint32_t c, double total) {
    std::uint32_t best = kNone;
    double most = total / 2;
    for (auto it = cover.lower_bound({c, 0}); it != cover.end() && it->first.first == c; ++it)
      if (it->second > most) best = it->first.second, most = it->second;
    return best;
  };

  std::vector<std::vector<const Gate*>> gates(n);
  for (const auto& g : city.gates) gates[std::stoul(g.sector_id)].push_back(&g);
  for (std::uint32_t c = 0; c < n; ++c) {
    Sector& s = city.sectors[c];
    const double area = area_m2(s.ground);
    std::int64_t most = 0;
    for (const auto& [name, mm] : length[c]) {
      if (mm >= kBearsNameMm) s.names.push_back(plan.routes.names[name]);
      if (mm > most) most = mm, s.name = plan.routes.names[name];
    }
    if (!s.name.empty() && s.names.empty()) s.names.push_back(s.name);
    const bool is_yard = plan.cells.kind[c] == CellKind::yard;
    s.kind = is_yard                                    ? SectorKind::yard
             : plan.cells.kind[c] == CellKind::junction ? SectorKind::crossroads
                                                        : SectorKind::street;
    double below = 0;
    for (auto it = in_passage.lower_bound({c, 0}); it != in_passage.end() && it->first.first == c; ++it)
      below += it->second;
    const std::uint32_t square = best_area(in_square, c, area), park = best_area(in_park, c, area);
    const auto take = [&](const std::string& name) {
      if (name.empty()) return;
      s.name = name;
      if (std::find(s.names.begin(), s.names.end(), name) == s.names.end()) s.names.push_back(name);
    };
    if (below > area / 2) {
      s.kind = SectorKind::passage;
    } else if (square != kNone && (!is_yard || area > 300)) {
      s.kind = SectorKind::square;
      take(square_names[square]);
    } else if (is_yard) {
      if (park != kNone) take(park_names[park]);
      if (looks_like_street(city, c, gates, plan.cells)) {
        s.kind = SectorKind::street;
        city.issues.push_back(
            {IssueCode::unmapped_street,
             "open ground between two streets looks like a street without a centre line; it became a sector of its own",
             "", s.origin});
      } else if (park != kNone || area > kOpenM2) {
        s.kind = SectorKind::open;
      }
    }
    std::sort(s.names.begin(), s.names.end());
  }
  for (auto& g : city.gates) {
    if (g.kind == GateKind::end_of_city) continue;
    const SectorKind a = city.sectors[std::stoul(g.sector_id)].kind, b = city.sectors[std::stoul(g.to_sector_id)].kind;
    if (a == SectorKind::passage || b == SectorKind::passage) g.kind = GateKind::passage;
  }
}

}  // namespace vicus
