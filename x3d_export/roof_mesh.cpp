#include "x3d_export/roof_mesh.hpp"

#include <cmath>

namespace vicus {
namespace {

template <class Visit>
void visit_triangles(const Building& house, Visit visit) {
  const auto& points = house.roof.points;
  for (const auto& facet : house.roof.facets)
    for (std::size_t i = 0; i + 2 < facet.triangles.size(); i += 3)
      visit(facet.kind, points.at(facet.triangles[i]), points.at(facet.triangles[i + 1]),
            points.at(facet.triangles[i + 2]));
}

}  // namespace

void add_roof(FaceList& faces, const Building& house) {
  visit_triangles(house, [&](FacetKind kind, const RoofPoint& a, const RoofPoint& b, const RoofPoint& c) {
    faces.add_triangle(a, b, c, is_upright(kind) ? house.wall_colour : house.roof_colour);
  });
}

void add_underside(FaceList& faces, const Building& house) {
  const auto base = static_cast<std::int32_t>(std::llround(house.base_m * kRoofStepsPerMetre));
  visit_triangles(house, [&](FacetKind, const RoofPoint& a, const RoofPoint& b, const RoofPoint& c) {
    faces.add_triangle({c.at, base}, {b.at, base}, {a.at, base}, house.wall_colour);
  });
}

}  // namespace vicus
