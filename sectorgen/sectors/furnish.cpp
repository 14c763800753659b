#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/locator.hpp"
#include "sectorgen/sectors/naming.hpp"

namespace vicus {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kMuchMore = 2;  // ground of the city behind a visitor than before him

/// The cell at p, or near it: shops and doors are mapped inside houses or on their walls.
std::uint32_t cell_near(const Plan& plan, const Locator& locator, PlanPoint p) {
  for (double radius : {0.0, 1.0, 3.0, 6.0, 10.0})
    for (int k = 0; k < (radius > 0 ? 8 : 1); ++k) {
      const PlanPoint q{p.x + lattice_mm(radius * std::cos(k * kPi / 4)),
                        p.y + lattice_mm(radius * std::sin(k * kPi / 4))};
      const std::uint32_t t = locator.locate(q);
      if (t != kNone && plan.cells.of[t] != kNone) return plan.cells.of[t];
    }
  return kNone;
}

std::string object_id(const std::string& source_id) {
  std::string id;
  for (char c : source_id) id += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ? c : '-';
  return id.empty() ? "object" : id;
}

/// Where a visitor starts: the middle of the chord nearest to the sector's centre, looking along the street.
struct Stand {
  std::int64_t distance = 0;
  PlanPoint at;
  double east = 0, north = 0;  // unit vector
};

/// How much ground of the city lies before an eye, as far as one sees in a street.
class GroundAround {
 public:
  explicit GroundAround(const std::vector<Sector>& sectors) : sectors_(sectors) {
    for (const Sector& s : sectors) {
      at_[square_of(s.origin)].push_back(static_cast<std::uint32_t>(area_m2_.size()));
      area_m2_.push_back(area_m2(s.ground));
    }
  }

  /// m2 of sectors whose origins lie within 45 degrees of that way.
  double before(const Stand& stand) const {
    const auto [column, row] = square_of(stand.at);
    double sum = 0;
    for (std::int32_t c = column - 1; c <= column + 1; ++c)
      for (std::int32_t r = row - 1; r <= row + 1; ++r) {
        const auto square = at_.find({c, r});
        if (square == at_.end()) continue;
        for (const std::uint32_t i : square->second) {
          const double x = double(sectors_[i].origin.x) - stand.at.x, y = double(sectors_[i].origin.y) - stand.at.y;
          if (x * stand.east + y * stand.north > std::abs(y * stand.east - x * stand.north)) sum += area_m2_[i];
        }
      }
    return sum;
  }

 private:
  static std::pair<std::int32_t, std::int32_t> square_of(PlanPoint p) {
    constexpr double kFar_m = 250;
    return {static_cast<std::int32_t>(std::floor(metres(p.x) / kFar_m)),
            static_cast<std::int32_t>(std::floor(metres(p.y) / kFar_m))};
  }
  const std::vector<Sector>& sectors_;
  std::vector<double> area_m2_;
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::uint32_t>> at_;
};

void add_viewpoints(const Plan& plan, City& city) {
  const Ground& g = plan.ground;
  std::map<std::uint32_t, Stand> best;
  const auto offer = [&](std::uint32_t c, PlanPoint a, PlanPoint b) {
    const Sector& s = city.sectors[c];
    const PlanPoint middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
    if (locate(s.ground, middle) != Side::inside) return;  // on an island
    const std::int64_t d = distance2(middle, s.origin);
    const auto it = best.find(c);
    if (it != best.end() && (it->second.distance < d || (it->second.distance == d && it->second.at < middle))) return;
    // Across the chord is along the street; take the direction in which more of the sector lies.
    const double x = double(a.y) - b.y, y = double(b.x) - a.x, length = std::hypot(x, y);
    std::int64_t ahead = 0, behind = 0;
    for (PlanPoint p : s.ground.outer) {
      const std::int64_t side = orient(a, b, p);
      ahead = std::max(ahead, side);
      behind = std::max(behind, -side);
    }
    const double sign = behind > ahead ? -1 : 1;
    best[c] = {d, middle, sign * x / length, sign * y / length};
  };
  for (int used = 1; used >= 0; --used)
    for (std::uint32_t t = 0; t < g.mesh.triangles.size(); ++t) {
      const std::uint32_t c = plan.cells.of[t];
      if (c == kNone || (used == 0 && best.count(c) != 0 && best[c].distance >= 0)) continue;
      for (int k = 0; k < 3; ++k) {
        if (!g.is_crossable(t, k) || plan.cells.of[g.beyond(t, k)] != c) continue;
        if (used == 1 && !plan.routes.is_used[g.edge_id(t, k)]) continue;
        const PlanPoint a = g.from(t, k), b = g.to(t, k);
        offer(c, std::min(a, b), std::max(a, b));
      }
    }
  const GroundAround around(city.sectors);
  for (std::uint32_t c = 0; c < city.sectors.size(); ++c) {
    const Sector& s = city.sectors[c];
    Viewpoint v;
    v.sector_id = s.id;
    v.kind = "start";
    v.name = s.name.empty() ? std::string(name_of(s.kind)) : s.name;
    const auto it = best.find(c);
    if (it != best.end()) {
      // But not out of the city when it lies behind.
      Stand stand = it->second, back = stand;
      back.east = -stand.east, back.north = -stand.north;
      if (around.before(back) > kMuchMore * around.before(stand)) stand = back;
      v.at = stand.at;
      v.heading_deg = std::fmod(std::round(std::atan2(stand.east, stand.north) * 1800 / kPi) + 3600, 3600) / 10;
    } else {  // one triangle: its centre
      std::vector<PlanPoint> p = s.ground.outer;
      const auto& i = s.ground_triangles;
      if (i.size() < 3) continue;
      for (const auto& hole : s.ground.holes) p.insert(p.end(), hole.begin(), hole.end());
      v.at = {static_cast<std::int32_t>((std::int64_t{p[i[0]].x} + p[i[1]].x + p[i[2]].x) / 3),
              static_cast<std::int32_t>((std::int64_t{p[i[0]].y} + p[i[1]].y + p[i[2]].y) / 3)};
    }
    city.viewpoints.push_back(std::move(v));
  }
}

}  // namespace

void furnish(const SourceMap& map, const Plan& plan, City& city) {
  const Locator locator(plan.ground.mesh);
  std::map<std::string, int> used;
  for (const auto& o : map.objects) {
    if (o.kind == "indoor_door") continue;  // interiors.hpp
    const std::uint32_t c = cell_near(plan, locator, o.at);
    if (c == kNone) continue;  // in a closed courtyard or out of the city
    StandaloneObject out;
    out.id = object_id(o.source_id);
    out.sector_id = std::to_string(c);
    out.kind = o.kind;
    out.name = o.name;
    out.at = o.at;
    out.height_m = o.height_m;
    out.tags = o.tags;
    const int n = used[out.id]++;
    if (n > 0) out.id += "-" + std::to_string(n + 1);
    city.objects.push_back(std::move(out));
  }
  add_viewpoints(plan, city);
}

}  // namespace vicus
