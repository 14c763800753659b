#pragma once
#include <optional>
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// The forms a roof may have, and what a plan says about them.
namespace vicus {

enum class RoofForm {
  flat,
  skillion,
  gabled,
  half_hipped,
  hipped,
  pyramidal,
  gambrel,
  mansard,
  dome,
  onion,
  cone,
  round,
  saltbox
};

/// The value of OSM roof:shape.
const char* name_of(RoofForm form);
/// The form of a value of roof:shape, common synonyms among them; nullopt: a value that means nothing to us.
std::optional<RoofForm> roof_form_of(const std::string& shape);

/// A side of a plan: edges that follow each other in a bend of less than 10 degrees.
struct RoofSide {
  std::vector<std::uint32_t> edges;   ///< of the footprint, in order
  double nx = 0, ny = 0;              ///< outward normal of its chord
  double length_m = 0;                ///< of its chord
  bool is_convex = false;             ///< the plan turns left at both its ends
  std::size_t before = 0, after = 0;  ///< its neighbours, as indices of sides
};
std::vector<RoofSide> sides_of(const Polygon& footprint);

/// The smallest rectangle around a plan (rotating calipers over its hull).
struct PlanRectangle {
  double ux = 1, uy = 0;  ///< along the longer side
  double length_m = 0, width_m = 0;
};
PlanRectangle rectangle_around(const Polygon& footprint);

/// The centroid as a lattice point from which every edge of the plan is seen from inside; nullopt: there is none, or
/// the plan has holes.
std::optional<PlanPoint> star_centre(const Polygon& footprint);

}  // namespace vicus
