#include "x3d_export/house_body.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "x3d_export/roof_mesh.hpp"

namespace vicus {
namespace {

constexpr double kHouseToAChimney_m2 = 70, kChimneyWidth_m = 0.8;
constexpr double kChimneyHeight_m = 0.8;  // above the ridge
constexpr double kChimneyInside_m = 0.8;  // below the roof, so that slopes do not show its open end
constexpr std::size_t kMostChimneys = 4;
constexpr Colour kBrick{132, 84, 66};

/// All outer walls of a house one can walk under. Rings have the house on the left, walls are seen from the right.
void add_ring_walls(FaceList& faces, const Building& house, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    faces.add_wall(ring[(i + 1) % ring.size()], ring[i], house.base_m, wall_top_m(house), house.wall_colour);
}

bool has_chimneys(const Building& house) {
  static const std::set<std::string> kTypes{"yes",         "",         "apartments", "house",
                                            "residential", "detached", "terrace",    "semidetached_house"};
  const auto at = house.tags.find("building");
  return kTypes.contains(at == house.tags.end() ? std::string() : at->second);
}

struct RoofTriangle {
  double area_m2 = 0;  // in plan
  PlanPoint middle;
  double up_m = 0;
};

/// The triangles of slopes and tops, the largest first.
std::vector<RoofTriangle> roof_triangles(const Building& house) {
  std::vector<RoofTriangle> out;
  for (const RoofFacet& facet : house.roof.facets) {
    if (is_upright(facet.kind)) continue;
    for (std::size_t i = 0; i + 2 < facet.triangles.size(); i += 3) {
      const RoofPoint &p = house.roof.points.at(facet.triangles[i]), &q = house.roof.points.at(facet.triangles[i + 1]),
                      &r = house.roof.points.at(facet.triangles[i + 2]);
      const double ux = metres(q.at.x - p.at.x), uy = metres(q.at.y - p.at.y), vx = metres(r.at.x - p.at.x),
                   vy = metres(r.at.y - p.at.y);
      const auto mean = [](std::int64_t a, std::int64_t b, std::int64_t c) {
        return static_cast<std::int32_t>((a + b + c) / 3);
      };
      out.push_back({std::abs(ux * vy - uy * vx) / 2,
                     {mean(p.at.x, q.at.x, r.at.x), mean(p.at.y, q.at.y, r.at.y)},
                     mean(p.up, q.up, r.up) / kRoofStepsPerMetre});
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const auto& p, const auto& q) { return p.area_m2 > q.area_m2; });
  return out;
}

}  // namespace

double wall_top_m(const Building& house) { return house.eave_m > house.base_m ? house.eave_m : house.height_m; }

void add_body(FaceList& faces, const Building& house, const std::function<bool(const SideWall&)>& is_drawn_elsewhere,
              const WallTop& facade_top, const StepWall& step_wall) {
  add_roof(faces, house, facade_top, step_wall);
  if (house.base_m > 0) {
    add_underside(faces, house);
    add_ring_walls(faces, house, house.footprint.outer);
    for (const auto& hole : house.footprint.holes) add_ring_walls(faces, house, hole);
    return;
  }
  for (const auto& wall : house.side_walls)
    if (!is_drawn_elsewhere || !is_drawn_elsewhere(wall))
      faces.add_wall(wall.b, wall.a, wall.bottom_m, wall_top_m(house), house.wall_colour);
}

void add_chimneys(FaceList& faces, const Building& house, int most) {
  if (!has_chimneys(house) || most < 1) return;
  const auto triangles = roof_triangles(house);
  double area_m2 = 0;
  for (const auto& t : triangles) area_m2 += t.area_m2;
  const auto wanted = static_cast<std::size_t>(area_m2 / kHouseToAChimney_m2 + 0.5);
  const std::size_t count = std::min({wanted, kMostChimneys, static_cast<std::size_t>(most), triangles.size()});
  for (std::size_t i = 0; i < count; ++i)
    faces.add_block(triangles[i].middle, kChimneyWidth_m, triangles[i].up_m - kChimneyInside_m,
                    house.height_m + kChimneyHeight_m, kBrick);
}

}  // namespace vicus
