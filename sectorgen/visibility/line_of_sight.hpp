#pragma once
#include <cstdint>
#include <vector>

#include "sectorgen/visibility/sight_map.hpp"

/// L_vis in plan: for each sector, every sector that some level look from inside it enters.
namespace vicus {

struct SightOptions {
  unsigned threads = 0;                    ///< 0: all cores
  std::uint64_t step_budget = 40'000'000;  ///< cells entered for one sector before others must tell its list
  bool count_cells = false;                ///< to measure: how many different cells each sector's looks enter
};

struct SightLists {
  std::vector<std::vector<std::uint32_t>> visible;  ///< per sector: sorted, itself in it
  std::vector<std::vector<std::uint32_t>> houses;   ///< per sector: sorted, those whose owner is not in `visible`
  std::vector<std::uint32_t> over_budget;           ///< sectors whose lists hold each other as a superset
  std::uint64_t steps = 0;                          ///< cells entered, all sectors
  std::uint64_t cells = 0;                          ///< the same, each once for each sector, where counted
};

/// Exact: B is listed for A when a straight line leaves A through its rim and enters B without crossing what stops
/// sight; touching is allowed (closed semantics), so a look along a wall or through a corner counts.
///
/// Houses: what a sector sees of a house besides facades (walls seen across water, rails or shut yards, the roof) comes
/// from the house's owner. A house is listed when such a line meets it: touches its wall from outside, or, where it
/// does not stop a look, enters a cell over which it stands. Not where the owner is listed anyway.
///
/// Error   none on the lattice: integer predicates on the map's own points. A sector over budget has its list from the
///         others', which is as exact; only pairs of two such sectors, and the houses of one, are a superset, never
///         less. Lists of sectors are symmetric.
/// Cost    cells entered; 80 to 200 ns each (look_map.hpp: few are). Sectors are independent.
/// Source  Teller & Sequin, SIGGRAPH 1991, §4 (cell-to-cell visibility); research/VISIBILITY.md §4.2.
/// Differs convex chains with pivots in place of linear programs; starts at the sector's rim, not at each cell: a line
///         that leaves the sector crosses it; cells are no sectors' parts, but cut at walls alone.
SightLists lines_of_sight(const SightMap& map, const SightOptions& options);

}  // namespace vicus
