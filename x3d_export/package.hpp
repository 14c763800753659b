#pragma once
#include <functional>
#include <optional>
#include <string>

#include "city_db/city.hpp"

/// Files of a city as they are stored: compressed once, at build time, with strong hashes (DESIGN §10).
///
/// Differs DESIGN §10 has gzip made at build time, too, and every format stored: the server makes gzip and the plain
///         bytes from brotli, and VRML97 and X3D JSON from the records, when asked for (docs/figures.md has the times).
namespace vicus {

struct PackageOptions {
  unsigned threads = 0;    ///< 0: all cores
  int brotli_quality = 6;  ///< 0 ... 11
};

/// The one row that holds `body`: as brotli, or as it is where that saves nothing. The hash is that of the row's body.
Artefact stored(const std::string& path, const std::string& media_type, const std::string& body, int brotli_quality);

/// Every artefact of the city one by one: its textures, impostors and panoramas; for each sector .x3d with its parts;
/// its interiors; then for each sector .far.x3d and .tall.x3d where it has one, and .json. nullopt at the end.
///
/// Once the last was pulled every Sector.bytes is filled: stored bytes of the near X3D file and its parts; and meta
/// "start" is set where it was not.
/// Needs   `city` outlives the generator and is not changed by others meanwhile.
/// Cost    memory: a few sectors' files at a time; they are made while they are pulled. Equal bytes for any number of
///         threads.
std::function<std::optional<Artefact>()> export_artefacts(City& city, const PackageOptions& options);

}  // namespace vicus
