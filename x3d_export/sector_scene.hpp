#pragma once
#include <string>
#include <vector>

#include "x3d_export/record.hpp"
#include "x3d_export/sector_mesh.hpp"
#include "x3d_export/writers.hpp"

/// A sector as files (DESIGN §10): sectors/ID.x3d, .wrl, .x3dj, ID.far.x3d, ID.tall.x3d.
namespace vicus {

struct ExportFile {
  std::string path;  ///< relative to the root world, e.g. "sectors/r12.x3d"
  std::string media_type;
  std::string text;
  int shapes = 0;  ///< Shape nodes in it
};

/// A browser parses a file on its main thread, 0.36 s per MB: a larger one makes the walk stutter.
inline constexpr std::size_t kFileLimit_bytes = 100'000;

/// The main file first, then the parts that it draws in by Inline, where one file would be larger than `limit`.
/// No file where the detail has nothing to draw (tall).
/// Each file is smaller than `limit`, but the main one where the record alone is larger.
/// `only_level`: 1 ... 4: facades in that Urban LOD alone, for comparing levels.
std::vector<ExportFile> sector_files(const CityIndex& index, const Sector& sector, Detail detail, SceneFormat format,
                                     std::size_t limit = kFileLimit_bytes, int only_level = 0);

/// A Viewpoint node in the frame of `origin`.
Node viewpoint_node(const Viewpoint& viewpoint, PlanPoint origin, const std::string& place);

/// Licences of the city as meta tags, one each (meta "licences" has one to a line).
std::vector<std::pair<std::string, std::string>> rights_of(const RecordSource& source);

}  // namespace vicus
