#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// Files of a city as they are stored and sent: compressed once, at build time, with strong hashes (DESIGN §10).
namespace vicus {

struct PackageOptions {
  unsigned threads = 0;    ///< 0: all cores
  int brotli_quality = 6;  ///< 5 ... 11 for what a walk loads: near X3D, far X3D, records
  int side_quality = 4;    ///< the same for VRML97 and X3D JSON, which few ask for
  int gzip_level = 6;      ///< libdeflate 1 ... 12
};

/// 128 bits of SHA-256, 32 hexadecimal digits.
std::string strong_hash(const std::string& body);
std::string brotli(const std::string& body, int quality);
std::string gzip(const std::string& body, int level);

/// `body` under `path` in the codings identity, br and gzip; a coding that saves nothing is left out. Each row's hash
/// is that of its own body.
std::vector<Artefact> coded(const std::string& path, const std::string& media_type, const std::string& body,
                            int brotli_quality, int gzip_level);

/// Every artefact of the city one by one, in sector order: for each sector .x3d, .far.x3d, .wrl, .x3dj (and their
/// parts) and .json. nullopt at the end.
///
/// On return every Sector.bytes is filled: brotli bytes of the near X3D file and its parts; and meta "start" is set
/// where it was not.
/// Needs   `city` outlives the generator and is not changed by others meanwhile.
/// Cost    memory: the near files as brotli; the rest is made in batches while it is pulled. Equal bytes for any number
///         of threads.
std::function<std::optional<Artefact>()> export_artefacts(City& city, const PackageOptions& options);

}  // namespace vicus
