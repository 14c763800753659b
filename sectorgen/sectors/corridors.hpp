#pragma once
#include <vector>

#include "sectorgen/sectors/cells.hpp"

/// Chains of used edges between junctions, and the chords at which streets are cut.
namespace vicus {

/// A maximal run of triangles with two used edges. chords[i] leads from triangles[i] to triangles[i+1].
struct Corridor {
  std::vector<std::uint32_t> triangles;  ///< first and last: the ends (junction, leaf), or equal for a loop
  std::vector<std::uint32_t> chords;     ///< edge ids
  std::vector<std::int64_t> width_mm;    ///< per chord
  std::vector<std::int64_t> cost_mm;     ///< per chord: width, more for T-vertices, kNever across an island
  std::vector<std::int64_t> along_mm;    ///< per chord: distance from the first chord along chord midpoints
  bool has_junction[2] = {false, false};
  std::int64_t length() const { return along_mm.empty() ? 0 : along_mm.back(); }
  std::int64_t narrowest() const;
};

inline constexpr std::int64_t kNever = std::int64_t{1} << 50;

std::vector<Corridor> find_corridors(const Ground& ground, const StreetRoutes& routes,
                                     const std::vector<std::uint32_t>& island_across);

/// Per edge id: an island it crosses, so that no gate may lie there; kNone mostly.
std::vector<std::uint32_t> edges_across_islands(const Ground& ground);

struct Cuts {
  std::vector<char> is_cut;       ///< per edge id
  std::vector<char> in_junction;  ///< per triangle: part of a crossroads before cutting
};

Cuts choose_cuts(const Ground& ground, const std::vector<Corridor>& corridors, const CutOptions& options);

}  // namespace vicus
