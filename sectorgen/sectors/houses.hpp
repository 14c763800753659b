#pragma once
#include <vector>

#include "sectorgen/sectors/sectors.hpp"
#include "sectorgen/sectors/tracing.hpp"

/// Houses as records: footprints as noded, which sector sends them, walls that bound no ground.
namespace vicus {

/// Which house stands behind an edge of the ground.
class Facades {
 public:
  Facades(const Plan& plan, const Bends& bends);
  /// The house whose ring runs b -> a, the one first in the source where several do; kNone: none.
  std::uint32_t house_behind(PlanPoint a, PlanPoint b) const;
  /// All houses whose ring runs a -> b, as indices into Blocks::houses.
  template <class Visit>
  void visit(PlanPoint a, PlanPoint b, Visit visit) const;

 private:
  std::vector<FeatureSide> sides_;
  friend struct HouseWriter;
};

/// Appends the buildings; turns Border::building_id from house numbers into building ids; chooses each building's
/// sector.
void write_houses(const SourceMap& map, const Plan& plan, const Bends& bends, const Facades& facades,
                  const std::vector<std::pair<PlanPoint, PlanPoint>>& closed_edges, City& city);

}  // namespace vicus
