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
  std::string lvis;            ///< id of the sector whose L_vis the colours show; empty: all sectors
};

/// SVG 1.1, north up: sectors coloured so that those joined by a gate differ (a hash of the id, moved on where a
/// neighbour has it), houses, water, barriers, gates by kind, centre lines, scale bar, legend, title, attribution.
/// With `lvis`: sectors coloured by why they are listed, houses seen over roofs marked, only what is listed and 50 m
/// around it where no box is given.
/// Equal cities give equal bytes.
/// Needs   `lvis` empty or the id of a sector.
std::string svg_map(const City& city, const SvgOptions& options);

}  // namespace vicus
