#include "x3d_export/house_body.hpp"

#include <algorithm>
#include <set>

namespace vicus {
namespace {

constexpr double kHouseToAChimney_m2 = 70, kChimneyWidth_m = 0.8, kChimneyHeight_m = 1.1;
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
  std::int64_t area2 = 0;  // mm2, twice
  PlanPoint middle;
};

std::vector<RoofTriangle> roof_triangles(const Building& house) {
  std::vector<PlanPoint> points = house.footprint.outer;
  for (const auto& hole : house.footprint.holes) points.insert(points.end(), hole.begin(), hole.end());
  std::vector<RoofTriangle> out;
  const auto& t = house.roof_triangles;
  for (std::size_t i = 0; i + 2 < t.size(); i += 3) {
    const PlanPoint a = points.at(t[i]), b = points.at(t[i + 1]), c = points.at(t[i + 2]);
    const std::int64_t ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
    const auto mean = [](std::int64_t p, std::int64_t q, std::int64_t r) {
      return static_cast<std::int32_t>((p + q + r) / 3);
    };
    out.push_back({ux * vy - uy * vx, {mean(a.x, b.x, c.x), mean(a.y, b.y, c.y)}});
  }
  std::stable_sort(out.begin(), out.end(), [](const auto& p, const auto& q) { return p.area2 > q.area2; });
  return out;
}

}  // namespace

double wall_top_m(const Building& house) { return house.eave_m > house.base_m ? house.eave_m : house.height_m; }

void add_body(FaceList& faces, const Building& house) {
  faces.add_floor(house.footprint, house.roof_triangles, wall_top_m(house), house.roof_colour, false);
  if (house.base_m > 0) {
    faces.add_floor(house.footprint, house.roof_triangles, house.base_m, house.wall_colour, true);
    add_ring_walls(faces, house, house.footprint.outer);
    for (const auto& hole : house.footprint.holes) add_ring_walls(faces, house, hole);
    return;
  }
  for (const auto& wall : house.side_walls)
    faces.add_wall(wall.b, wall.a, wall.bottom_m, wall_top_m(house), house.wall_colour);
}

void add_chimneys(FaceList& faces, const Building& house, int most) {
  if (!has_chimneys(house) || most < 1) return;
  const auto triangles = roof_triangles(house);
  double area_m2 = 0;
  for (const auto& t : triangles) area_m2 += static_cast<double>(t.area2) / 2e6;
  const auto wanted = static_cast<std::size_t>(area_m2 / kHouseToAChimney_m2 + 0.5);
  const std::size_t count = std::min({wanted, kMostChimneys, static_cast<std::size_t>(most), triangles.size()});
  for (std::size_t i = 0; i < count; ++i)
    faces.add_block(triangles[i].middle, kChimneyWidth_m, wall_top_m(house), house.height_m + kChimneyHeight_m, kBrick);
}

}  // namespace vicus
