#pragma once
#include "cli/measure_representation.hpp"
#include "cli/measure_shared_city.hpp"

/// The city as sector files (X3D as brotli, images as PNG). From the street a visitor has the files that L_1 names,
/// from the air those of all sectors.
namespace vicus::measure {

/// What all pictures are held against: every facade in level 4, whatever the files' byte
/// budget; nothing shuts the gates at the city's end.
std::shared_ptr<const Tracer> truth_of(const SharedCity& city);

/// Every near file of the city at once, facades in the finest level that each has.
Form full_model(SharedCity& city);
/// Near files with facades in one Urban LOD alone, 1 ... 4.
Form level_files(SharedCity& city, int level);
Form far_files(SharedCity& city);
/// As the page has it (docs/visitor.md): near here and behind the gates, far what else is seen, tall what is seen over
/// roofs alone; facades by distance (docs/houses.md), at `range_share` times the distances.
Form page_files(SharedCity& city, double range_share);
/// The visitor's own sector, and pictures in its gates (docs/impostors.md) in place of all that lies beyond
/// those that lead on.
Form gate_pictures(SharedCity& city);

}  // namespace vicus::measure
