#include "city_db/surface_colour.hpp"

namespace vicus {

Colour surface_colour(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::pavement:
      return {188, 184, 176};
    case SurfaceKind::carriageway:
      return {120, 121, 124};
    case SurfaceKind::paving:
      return {202, 190, 170};
    case SurfaceKind::path:
      return {214, 200, 168};
    case SurfaceKind::grass:
      return {124, 156, 84};
    case SurfaceKind::earth:
      return {178, 164, 134};
    case SurfaceKind::water:
      return {104, 142, 164};
    case SurfaceKind::steps:
      return {222, 214, 198};
    case SurfaceKind::rail:
      return {78, 80, 84};
    case SurfaceKind::kerb:
      return {212, 208, 198};
  }
  return {};
}

Colour ground_colour(SectorKind kind) {
  switch (kind) {
    case SectorKind::street:
      return {126, 124, 121};
    case SectorKind::crossroads:
      return {116, 115, 114};
    case SectorKind::square:
      return {168, 158, 142};
    case SectorKind::yard:
      return {150, 148, 128};
    case SectorKind::passage:
      return {104, 100, 94};
    case SectorKind::interior:
      return {142, 104, 70};
    case SectorKind::open:
      return {128, 148, 100};
  }
  return {};
}

}  // namespace vicus
