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

}  // namespace vicus
