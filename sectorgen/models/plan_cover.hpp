#pragma once
#include <cstdint>
#include <vector>

#include "sectorgen/geo/source_map.hpp"
#include "sectorgen/geom/noding.hpp"
#include "sectorgen/geom/triangulation.hpp"

/// Which face of a modelled house lies uppermost at each place of a footprint.
namespace vicus {

/// Height over the plan as one plane, kept within the heights of the face's own corners.
struct FacePlane {
  double gx = 0, gy = 0;  ///< metres up per mm east, north
  double up_m = 0;        ///< at `at`
  PlanPoint at;
  double least_m = 0, most_m = 0;
  double up_at(double x, double y) const;
};

/// The footprint cut along every face's edges.
struct PlanCover {
  Mesh mesh;
  std::vector<FacePlane> planes;    ///< one each face of the model
  std::vector<std::uint32_t> face;  ///< per triangle: uppermost face; kNone outside of the footprint
  /// Per edge of the footprint (ring by ring): its points from end to end, in the mesh; those between lie on the edge
  /// or less than 2 mm inside of it.
  std::vector<std::vector<std::uint32_t>> chains;
  double covered = 0;  ///< share of the footprint below faces; the rest took a neighbouring triangle's face
};

/// `cuts`: lines that cut the plan, too.
/// Needs   a valid footprint.   Error  faces move by at most 1 mm in plan (noding).
PlanCover cover_plan(const Polygon& footprint, const HouseModel& model, const std::vector<Segment>& cuts = {});

}  // namespace vicus
