#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"
#include "sectorgen/models/photo_list.hpp"
#include "sectorgen/visibility/author_list.hpp"
#include "sectorgen/visibility/visible.hpp"

/// The stages that turn a map into a city, in order: start reading here.
namespace vicus {

struct StageTime {
  std::string stage;
  double cpu_s = 0, wall_s = 0;
  double peak_mb = 0;  ///< largest resident size so far
};

struct BuildReport {
  std::vector<StageTime> stages;
  std::size_t ground_triangles = 0;
  double largest_gap_m = 0;           ///< between a house and the ground before it
  bool is_terrain_coarsened = false;  ///< its step is wider than 5 m, or there would be too many nodes
};

/// Times one stage after the other; CPU time is of all threads.
class StageClock {
 public:
  StageClock(BuildReport& report, std::function<void(const char* stage)> on_stage);
  void begin(const char* stage);  ///< ends the one before
  void end();

 private:
  BuildReport& report_;
  std::function<void(const char*)> on_stage_;
  const char* stage_ = nullptr;
  double cpu_ = 0;
  std::chrono::steady_clock::time_point wall_;
};
double cpu_seconds();
double peak_resident_mb();

struct BuildOptions {
  std::uint64_t budget_bytes = 200'000;  ///< per sector, as sent
  unsigned threads = 0;                  ///< 0: all cores
  const City* previous = nullptr;  ///< the city built before, whose sector ids are kept where sectors are the same
  std::filesystem::path terrain;   ///< a raster of heights; empty: the ground is flat
  bool with_textures = true;       ///< false: facades have no images, the city no atlas
  bool with_visibility = true;     ///< false: no L_vis
  VisibleOptions visible;
  std::vector<FacadePhoto> photos;                  ///< in place of painted facades
  std::vector<Prototype> models;                    ///< an author's, in place of ours (author_models.hpp)
  std::vector<AuthorEntry> important;               ///< a person's list of important sectors
  std::function<void(const char* stage)> on_stage;  ///< progress
};

/// Needs   a map from load_source_map.
/// Fails   CityError(exit 4): no walkable ground at all.
City build_city(SourceMap map, const BuildOptions& options, std::vector<Issue> issues, BuildReport& report);

}  // namespace vicus
