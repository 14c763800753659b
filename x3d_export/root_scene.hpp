#pragma once
#include <optional>
#include <string>
#include <vector>

#include "x3d_export/city_index.hpp"
#include "x3d_export/writers.hpp"

/// The root world: the file that a visitor opens (DESIGN §10, client_scripts/README.md).
namespace vicus {

inline constexpr int kEverySector = -1;

struct RootOptions {
  std::string start;  ///< sector id; empty: start_sector()
  SceneFormat format = SceneFormat::x3d;
  bool is_static = false;               ///< no Script: `level` rings of sectors, all loaded
  int level = 1;                        ///< static only: i of L_i (paper 004 §5.1), or kEverySector
  std::vector<std::string> near, far;   ///< static only: in place of rings: these, and their far files
  std::string loader_level;             ///< i of L_i for the LOADER; empty: it chooses by what it measures
  std::string loader_test = "polygon";  ///< how it finds the visitor's sector: polygon, box or gate (§5.2)
  std::string base = "sectors/";
  std::string loader_url = "client/loader.js";
  std::string parcels;  ///< path that gives many files at once; empty: nobody does
};

/// Browsers within web pages run a Script node's text by eval; the page of `vicus serve` does without the Script.
inline constexpr const char* kNeedsEval =
    "This world has a Script node: a web page that shows it needs script-src 'unsafe-eval' in its "
    "Content-Security-Policy. The page at / shows the same city without.";

/// Sky, light and the way a visitor moves: NavigationInfo, Background, DirectionalLights.
std::vector<Node> surroundings(const std::vector<std::string>& navigation_types);

/// Where a visitor starts when no sector is named: meta "start", else the sector with the start viewpoint nearest to
/// the city's origin, else the first square, else the first sector; by id where that leaves a choice. Needs   at least
/// one sector (assert).
std::string start_sector(const RecordSource& source);

/// One big ProximitySensor, the LOADER Script and an Inline for the start sector and those behind its gates: never one
/// list of the city. Others are added by the Script from the records it learns of.
/// Frame   the plan frame in X3D axes; each sector under a Transform, so that its own numbers stay small.
/// Differs from paper 004 §5 in VRML97 only: initial sectors are children from the start, as an Inline has no `load`.
/// nullopt: there is no such start sector.
std::optional<Scene> root_scene(const RecordSource& source, const RootOptions& options);

/// root_scene as a file's text.
std::optional<std::string> root_text(const RecordSource& source, const RootOptions& options);

}  // namespace vicus
