#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "city_db/city.hpp"
#include "city_db/rules_exact.hpp"

/// Every edge of a city once, with all the rings and lines that run along it.
namespace vicus::rules {

/// domain .. obstacle are rings (inside on the left), border and gate are lines (ground on the left).
enum class Layer : std::uint8_t { domain, sector, building, obstacle, border, gate };

struct EdgeUse {
  std::uint32_t owner = 0;  ///< index into the city's list of that layer
  std::uint32_t at = 0;     ///< ordinal of the edge in its polygon (outer ring, then holes) or line
  Layer layer = Layer::domain;
  bool forward = true;  ///< runs lo -> hi, so what is on its left is on the edge's left
  bool is_ring() const { return layer <= Layer::obstacle; }
};

/// Undirected: lo < hi by x, then y. Its left side is above it (for an upright edge: west of it).
struct Edge {
  PlanPoint lo, hi;
  std::uint32_t first_use = 0;
};

struct EdgeTable {
  std::vector<Edge> edges;  ///< by (lo, hi)
  std::vector<EdgeUse> uses;

  std::span<const EdgeUse> uses_of(std::size_t e) const {
    const std::size_t end = e + 1 < edges.size() ? edges[e + 1].first_use : uses.size();
    return {uses.data() + edges[e].first_use, uses.data() + end};
  }
  /// Uses are sorted by layer: a ring comes first where there is one.
  bool has_ring(std::size_t e) const { return uses[edges[e].first_use].is_ring(); }
};

/// Buildings that stand above the ground (base_m > 0) are left out; so are edges of no length.
EdgeTable edge_table(const City& city);

/// What lies on one side of an edge: how many polygons of each sort cover it. Of a valid city domain and sectors are
/// 0 or 1; `blocks` counts houses on the ground and obstacles, which may overlap.
struct Cover {
  std::int32_t domain = 0, sectors = 0, blocks = 0;
  bool is_walkable() const { return domain >= 1 && blocks == 0; }
  friend bool operator==(const Cover&, const Cover&) = default;
};

inline bool stands_on_ground(const Building& b) { return b.base_m <= 0; }

}  // namespace vicus::rules
