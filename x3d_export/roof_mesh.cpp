#include "x3d_export/roof_mesh.hpp"

#include <cmath>

#include "city_db/gables.hpp"

namespace vicus {
namespace {

template <class Visit>
void visit_triangles(const Building& house, const RoofFacet& facet, Visit visit) {
  const auto& points = house.roof.points;
  for (std::size_t i = 0; i + 2 < facet.triangles.size(); i += 3)
    visit(points.at(facet.triangles[i]), points.at(facet.triangles[i + 1]), points.at(facet.triangles[i + 2]));
}

/// What of a gable is above a facade that reaches up into it.
void add_gable_above(FaceList& faces, const Gable& gable, double top_m, Colour colour) {
  const auto low = static_cast<std::int32_t>(std::lround(top_m * kRoofStepsPerMetre));
  for (const auto& [p, q] : gable.rim) {
    if (p.up > low) faces.add_triangle({q.at, low}, {p.at, low}, p, colour);
    if (q.up > low) faces.add_triangle({q.at, low}, p.up > low ? p : RoofPoint{p.at, low}, q, colour);
  }
}

/// What of a step is below a facade on it, and above.
void add_step_around(FaceList& faces, const RoofStep& step, const std::pair<double, double>& facade, Colour colour) {
  const auto low = static_cast<std::int32_t>(std::lround(facade.first * kRoofStepsPerMetre)),
             high = static_cast<std::int32_t>(std::lround(facade.second * kRoofStepsPerMetre));
  for (const auto& [p, q] : step.below) {
    if (p.up < low) faces.add_triangle(p, {q.at, low}, {p.at, low}, colour);
    if (q.up < low) faces.add_triangle(p.up < low ? p : RoofPoint{p.at, low}, q, {q.at, low}, colour);
  }
  for (const auto& [p, q] : step.above) {
    if (p.up > high) faces.add_triangle({q.at, high}, {p.at, high}, p, colour);
    if (q.up > high) faces.add_triangle({q.at, high}, p.up > high ? p : RoofPoint{p.at, high}, q, colour);
  }
}

}  // namespace

void add_roof(FaceList& faces, const Building& house, const WallTop& facade_top, const StepWall& step_wall) {
  for (const auto& facet : house.roof.facets) {
    if (step_wall && facet.kind == FacetKind::step)
      if (const auto step = step_of(house, facet); step)
        if (const auto wall = step_wall(step->a, step->b); wall) {
          add_step_around(faces, *step, *wall, house.wall_colour);
          continue;
        }
    if (facade_top && facet.kind == FacetKind::gable)
      if (const auto gable = gable_of(house, facet); gable)
        if (const double top_m = facade_top(gable->a, gable->b); top_m > house.eave_m) {
          add_gable_above(faces, *gable, top_m, house.wall_colour);
          continue;
        }
    visit_triangles(house, facet, [&](const RoofPoint& a, const RoofPoint& b, const RoofPoint& c) {
      faces.add_triangle(a, b, c, is_upright(facet.kind) ? house.wall_colour : house.roof_colour);
    });
  }
}

void add_underside(FaceList& faces, const Building& house) {
  const auto base = static_cast<std::int32_t>(std::llround(house.base_m * kRoofStepsPerMetre));
  for (const auto& facet : house.roof.facets)
    visit_triangles(house, facet, [&](const RoofPoint& a, const RoofPoint& b, const RoofPoint& c) {
      faces.add_triangle({c.at, base}, {b.at, base}, {a.at, base}, house.wall_colour);
    });
}

}  // namespace vicus
