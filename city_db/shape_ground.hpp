#pragma once
#include <vector>

#include "city_db/city.hpp"
#include "city_db/rules_cells.hpp"

/// Where is the walkable ground, whose is it, and how far is it to its edge.
namespace vicus {

inline constexpr std::uint32_t kNoSector = 0xffffffffu;

/// A place in the plan between lattice points, mm.
struct PlanPlace {
  double x = 0, y = 0;
};
inline PlanPlace place_of(PlanPoint p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

class GroundMap {
 public:
  explicit GroundMap(const City& city);

  /// Index of the sector whose ground the place lies in, or kNoSector. Asks up to half a millimetre north or south of
  /// it, on a line that meets no vertex.
  std::uint32_t sector_at(PlanPlace place) const;
  /// Distance to the nearest edge that stops a walker, mm; at most kFarMm.
  double clearance_mm(PlanPlace place) const;
  /// Appends where on a -> b, as fractions in (0, 1), it meets a ground edge. Unsorted.
  void add_crossings(PlanPoint a, PlanPoint b, std::vector<double>& fractions) const;

  static constexpr double kFarMm = 500'000;

 private:
  struct GroundEdge {
    PlanPoint lo, hi;  ///< lo < hi, see Edge
    std::uint32_t left = kNoSector, right = kNoSector;
    bool stops = false;
  };
  double nearest_in_cell(PlanPlace place, std::int32_t ix, std::int32_t iy) const;

  std::vector<GroundEdge> edges_;
  rules::CellIndex cells_;
};

}  // namespace vicus
