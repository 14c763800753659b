#pragma once
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

/// What the ground of each sector is made of: carriageways between their kerbs, paths, squares, grass, steps, rails.
namespace vicus {

/// One patch, on the lattice, not yet noded with its neighbours; patches of a sector may overlap: the kind that comes
/// first in kCoverOrder shows.
struct Patch {
  std::size_t sector = 0;  ///< index into City::sectors
  SurfaceKind kind = SurfaceKind::pavement;
  Polygon area;           ///< within the sector's ground, to a millimetre
  bool is_tread = false;  ///< one step of a flight of steps: level in itself
};

inline constexpr SurfaceKind kCoverOrder[] = {SurfaceKind::rail, SurfaceKind::carriageway, SurfaceKind::steps,
                                              SurfaceKind::path, SurfaceKind::paving,      SurfaceKind::earth,
                                              SurfaceKind::grass};

/// The kind of the ground where no patch lies.
SurfaceKind plain_ground(SectorKind kind);

/// A carriageway keeps this far from every facade, wall and fence, and is at least 2 m wide: else there is none.
inline constexpr double kLeastPavement_m = 0.9, kLeastCarriageway_m = 2.0;
/// A step is at least this deep; a flight has at most kMostTreads.
inline constexpr double kTread_m = 0.35;
inline constexpr int kMostTreads = 40;

/// The same on both sides of a gate to within a millimetre: what lies within kReach_m of a sector shapes its ground.
/// Cost  some milliseconds a sector; sectors independent.
std::vector<Patch> ground_patches(const SourceMap& map, const City& city, unsigned threads);

}  // namespace vicus
