#pragma once
#include <optional>
#include <vector>

#include "sectorgen/sectors/tours/walk_mesh.hpp"

/// Where on the ground a place is.
namespace vicus {

struct Standing {
  PlanPoint at;
  std::uint32_t triangle = kNone;  ///< its closure holds `at`, and one walks there
};

class WalkPlaces {
 public:
  explicit WalkPlaces(const WalkMesh& walk);

  /// A triangle whose closure holds p, walked on or not; kNone outside the mesh.   Error  none.
  std::uint32_t triangle_at(PlanPoint p) const;
  /// All triangles that one walks on whose closure holds p.
  std::vector<std::uint32_t> standing_at(PlanPoint p) const;
  /// The point to stand on that is nearest to p; p itself where one walks there. nullopt: none within `within_mm`.
  /// Error   2 mm: the nearest point is rounded into its triangle.
  std::optional<Standing> nearest(PlanPoint p, double within_mm) const;

 private:
  std::uint32_t walk_from(std::uint32_t t, PlanPoint p) const;

  const WalkMesh& walk_;
  PlanBox box_;
  double cell_mm_ = 1;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> near_;  // per cell of a grid, a triangle near it
};

}  // namespace vicus
