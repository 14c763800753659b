#pragma once
#include <limits>
#include <vector>

#include "sectorgen/geo/source_map.hpp"

/// Houses given in parts (building:part of Simple 3D Buildings): what stands over each place of a house's ground.
namespace vicus {

inline constexpr std::uint32_t kNoFootprint = std::numeric_limits<std::uint32_t>::max();

/// A piece of a house seen from above, from the ground or from `base_m` up.
struct HouseColumn {
  std::uint32_t footprint = kNoFootprint;  ///< the part on top, or the house's outline where no part is
  Polygon area;
  double base_m = 0;             ///< > 0: it hangs, or stands in the sloped roof of another column
  double top_m = 0, eave_m = 0;  ///< above ground
  bool is_main = false;          ///< the largest on the ground: it bears the house's name and number
};

/// The parts of each house, and the columns they make.
///
/// Method  parts are cut to the outline and grown into slits of `kSlit_m` between them. The highest part at a place
/// makes
///         the column there, down to the ground where something below bears it. One that stands in a sloped roof (a
///         lantern, a ridge turret) does not cut that roof. Where no part stands there is the outline itself, as high
///         as what stands on it begins; not below parts that hang over a house whose parts are complete (arcades).
/// Frame   plan lattice; metres above the house's ground.
/// Differs from the wiki's page, where the outline is never drawn: maps often give a tower only.
class BuildingParts {
 public:
  explicit BuildingParts(const SourceMap& map);
  bool has_parts(std::uint32_t outline) const { return !parts_of_[outline].empty(); }
  /// By its tag, or because it lies within the outline of a larger house.
  bool is_part(std::uint32_t footprint) const { return holder_[footprint] != kNoFootprint; }
  /// Columns on the ground do not overlap. Empty: no part is left of the house's ground.
  std::vector<HouseColumn> columns_of(std::uint32_t outline) const;

 private:
  const SourceMap& map_;
  std::vector<std::vector<std::uint32_t>> parts_of_;  // per footprint
  std::vector<std::uint32_t> holder_;
};

}  // namespace vicus
