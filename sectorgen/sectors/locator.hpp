#pragma once
#include <cstdint>
#include <vector>

#include "sectorgen/sectors/ground.hpp"
#include "sectorgen/sectors/raster.hpp"

/// Which triangle of the ground's mesh holds a point.
namespace vicus {

class Locator {
 public:
  explicit Locator(const Mesh& mesh);
  /// A triangle whose closure holds p, near `hint` if given; kNone outside the mesh's hull.   Error  none.
  std::uint32_t locate(PlanPoint p, std::uint32_t hint = kNone) const;

 private:
  const Mesh& mesh_;
  Raster raster_;
  std::vector<std::uint32_t> near_;  // a triangle near each cell
};

}  // namespace vicus
