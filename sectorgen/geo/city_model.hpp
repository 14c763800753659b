#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sectorgen/geo/raw_map.hpp"

/// Houses that come as 3D models: what CityJSON and CityGML have in common.
namespace vicus {

/// In the file's own coordinate system: x easting or longitude, y northing or latitude, z up in metres.
struct ModelCorner {
  double x = 0, y = 0, z = 0;
  double u = 0, v = 0;  ///< in the surface's image, from its bottom left
};

enum class ModelPart { other, ground, wall, roof, door, window };

struct ModelSurface {
  ModelPart part = ModelPart::other;
  std::size_t element = 0;       ///< which of its house's parts it belongs to: a door may have many surfaces
  std::optional<Colour> colour;  ///< of its material, where the file has one
  std::filesystem::path image;   ///< that is on it, where the file has one that is there
  std::vector<std::vector<ModelCorner>> rings;  ///< outer first; closed implicitly
};

/// A Building or BuildingPart with surfaces of its own.
struct ModelObject {
  std::string id;
  Tags attributes;  ///< names as in CityGML: measuredHeight, storeysAboveGround, roofType, function, name, ...
  std::vector<ModelSurface> surfaces;
};

struct CityModel {
  std::string system;  ///< of coordinates, as the file says: EPSG:7415, urn:ogc:def:crs:EPSG::25832, ...; may be empty
  std::string licence;
  std::vector<ModelObject> objects;
  std::vector<RawIssue> issues;
};

/// Appends the model's houses: the footprint is the union of the surfaces on the ground (of all that look up, where
/// there are none), the tags are OSM's; everything that looks up is the house's own roof, windows and doors are its
/// own, and doors points of the map; the colour that most of its walls (roofs) have is the house's (roof's). Fails
/// CityError, naming the file: no coordinate system, or one that is not known or cannot be transformed; no house.
void add_city_model(const std::filesystem::path& file, CityModel model, RawMap& map);

/// The whole file as text, also from .gz.   Fails  CityError: cannot be read, broken, larger than 2 GB.
std::string file_text(const std::filesystem::path& path);

/// The beginning of the file, also from .gz; "" where it cannot be read.
std::string file_beginning(const std::filesystem::path& path);

/// The EPSG code in a name of a coordinate system; of a compound one the horizontal part's, which stands first. 0:
/// none.
int epsg_code(const std::string& system);

}  // namespace vicus
