#pragma once
#include <optional>

#include "cli/measure_representation.hpp"
#include "cli/measure_shared_city.hpp"

/// Parts of sector representations as text: "ID near 4", "ID near 4321..." (a level for each piece), "ID far", "ID
/// tall".
namespace vicus::measure {

std::string part_text(const SectorPart& part);
/// Needs   a text of part_text for a sector of this city.
SectorPart part_of(const SharedCity& city, const std::string& text);

/// The files of a part as they are stored in the city, its images with them.
std::vector<SentFile> stored_files(SharedCity& city, const SectorPart& part);
/// Ids of the images that a near file names, sorted.
std::vector<std::string> images_of(const SharedCity& city, const Sector& sector, int level);

/// The meshes of some parts on the sheet, without the shut gates at the city's end, and what a graphics card holds for
/// them.
struct PartsScene {
  std::shared_ptr<const Tracer> tracer;
  double memory_bytes = 0;
};
PartsScene scene_of(const SharedCity& city, const std::vector<SectorPart>& parts, RenderMesh more = {});

/// Without repeats, by path.
std::vector<SentFile> once_each(std::vector<SentFile> files);

}  // namespace vicus::measure
