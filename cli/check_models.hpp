#pragma once
#include <string>
#include <vector>

#include "city_db/shape.hpp"
#include "city_db/store.hpp"

/// What `vicus check` says of houses and images, beside the rules of sectors.
namespace vicus::cli {

struct UnsoundRoof {
  std::string building_id, fault;
};

struct ModelFigures {
  std::size_t sound = 0, without = 0;  ///< houses with a roof that closes them; houses without facets
  std::vector<UnsoundRoof> unsound;    ///< by sectorgen/models/solid_check.hpp, which makes no roofs
  /// Per sector: kB of its images on a graphics card, four bytes a pixel and a third more for smaller sizes.
  Spread texture_kb;
  double texture_max_kb = 0;
};

/// `file` is where `city` was read from: images stand there.
ModelFigures check_models(const City& city, const CityReader& file);

}  // namespace vicus::cli
