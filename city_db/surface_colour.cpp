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

}  // namespace vicus
