#pragma once
#include <optional>
#include <string>

#include "city_db/city.hpp"

/// A city as a picture for people who judge its sectors: `vicus export --format svg`.
namespace vicus {

struct SvgOptions {
  std::optional<PlanBox> box;  ///< what to show; else the whole domain
  bool has_labels = false;     ///< short ids and names of sectors
  double side_px = 1600;       ///< the longer side of the map
};

/// SVG 1.1, north up: sectors coloured so that those joined by a gate differ (a hash of the id, moved on where a
/// neighbour has it), houses, water, barriers, gates by kind, centre lines, scale bar, legend, title, attribution.
/// Equal cities give equal bytes.
std::string svg_map(const City& city, const SvgOptions& options);

}  // namespace vicus
