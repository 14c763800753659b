#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "city_db/city.hpp"
#include "httpd/made_tiles.hpp"

/// Tiles for flying over: baked by `vicus build`, or by `vicus serve` when first asked for.
namespace vicus::cli {

/// The tiles that plan_tiles says, and the list of them, as they are stored. A tile of the city
/// that is replaced (`previous`, which need not exist) is taken over where nothing in it has changed.
std::vector<Artefact> bake_tiles(const City& city, const std::filesystem::path& previous, unsigned threads);

/// What the city's file has of them, plain: the list, and every tile on it. Empty where it was built without tiles.
/// Fails   CityError: the list or a tile on it is damaged or missing.
std::vector<Artefact> stored_tiles(const std::filesystem::path& city);

/// One after the other.
std::function<std::optional<Artefact>()> followed_by(std::function<std::optional<Artefact>()> first,
                                                     std::vector<Artefact> then);

/// The tile of a path that the city's file does not have. nullopt: not a path of a tile with houses.
/// Fails   CityError: the city cannot be read.
std::optional<MadeTile> make_tile(const std::filesystem::path& city, const std::string& path);

}  // namespace vicus::cli
