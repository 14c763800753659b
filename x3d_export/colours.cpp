#include "x3d_export/colours.hpp"

#include <algorithm>

namespace vicus {

Colour shaded(Colour c, double k) {
  const auto channel = [k](std::uint8_t v) { return static_cast<std::uint8_t>(std::min(255.0, v * k)); };
  return {channel(c.r), channel(c.g), channel(c.b)};
}

}  // namespace vicus
