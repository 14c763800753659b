#pragma once
#include <optional>
#include <string>

#include "city_db/city.hpp"
#include "sectorgen/geo/source_map.hpp"

/// The roof of a house that comes with a model of its own (CityJSON, CityGML), on the footprint as noded here.
namespace vicus {

struct ImportedRoof {
  Roof roof;  ///< with triangles
  double eave_m = 0;
  bool is_level = false;  ///< nothing of it slopes
};

/// The model's faces that look up, seen from above, as a sound roof (solid_check.hpp): over each place of the footprint
/// stands the highest face there; where two faces differ in height an upright `step` closes the gap, over the
/// footprint's edges upright gables do. What hangs out over the footprint is cut off; what the footprint has beyond the
/// model (walls moved by centimetres to meet a neighbour's) follows the nearest face.
///
/// Frame   heights above the model's foot.
/// Error   plan within 1 mm of the model, by noding; heights within kJoin_m of the face's plane, where faces that
/// nearly
///         meet are made to meet; where two faces pass through each other without an edge, over each piece stands the
///         one that is higher in its middle, and corners are bent by up to half of kMostBend_m. Where something must
///         lie at the eave that cannot, the eave is kLip_m lower.
/// Needs   a valid footprint.
/// Fails   nothing, and `fault` says why: less than kLeastCover of the footprint lies below faces, two faces cross by
///         more than kMostBend_m, the roof comes down to the ground, or what was made is not sound.
/// Cost    n log n in the corners of the model.
std::optional<ImportedRoof> roof_from_model(const Polygon& footprint, const HouseModel& model, std::string& fault);

inline constexpr double kJoin_m = 0.05;
inline constexpr double kLip_m = 0.1;
inline constexpr double kLeastCover = 0.95;
inline constexpr double kMostBend_m = 0.5;

}  // namespace vicus
