#pragma once
#include <optional>

#include "sectorgen/models/canvas.hpp"

/// How often windows repeat in a straightened photo of a facade.
namespace vicus {

struct Repeats {
  int count = 1;
  double likeness = 0;  ///< of the picture and itself moved by one repeat, -1 ... 1
};

/// Windows side by side, every 1.4 to 6 m; storeys, every 2.4 to 5 m. nullopt: nothing repeats beyond doubt, that is
/// with a likeness of kSureOfBays, kSureOfFloors: brightness summed over columns (rows) against itself, mean taken off.
/// Needs   a canvas whose metres are the facade's.
std::optional<Repeats> find_bays(const Canvas& facade);
std::optional<Repeats> find_floors(const Canvas& facade);

/// Painted facades have at least 0.91 and 0.60, a photographed one 0.99 and 0.93; aerial views of gardens 0.80, 0.69.
inline constexpr double kSureOfBays = 0.85, kSureOfFloors = 0.75;

}  // namespace vicus
