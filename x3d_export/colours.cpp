#include "x3d_export/colours.hpp"

namespace vicus {

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
    case SectorKind::open:
      return {128, 148, 100};
  }
  return {};
}

Colour surface_colour(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::pavement:
      return {158, 155, 149};
    case SurfaceKind::carriageway:
      return {92, 93, 96};
    case SurfaceKind::paving:
      return {172, 162, 146};
    case SurfaceKind::path:
      return {186, 172, 142};
    case SurfaceKind::grass:
      return {106, 136, 74};
    case SurfaceKind::earth:
      return {150, 138, 112};
    case SurfaceKind::water:
      return {92, 124, 142};
    case SurfaceKind::steps:
      return {190, 184, 172};
    case SurfaceKind::rail:
      return {66, 68, 72};
    case SurfaceKind::kerb:
      return {184, 181, 174};
  }
  return {};
}

}  // namespace vicus
