#include "x3d_export/colours.hpp"

#include <algorithm>

namespace vicus {

Colour shaded(Colour c, double k) {
  const auto channel = [k](std::uint8_t v) { return static_cast<std::uint8_t>(std::min(255.0, v * k)); };
  return {channel(c.r), channel(c.g), channel(c.b)};
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
    case SectorKind::open:
      return {128, 148, 100};
  }
  return {};
}

}  // namespace vicus
