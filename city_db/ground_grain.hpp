#pragma once

/// The grain of streets and pavements near by: one grey image for the whole city (meta["grain"]) that multiplies the
/// colours of the ground.
namespace vicus {

inline constexpr double kGrainSide_m = 3;  ///< of ground that the image covers
inline constexpr double kGrainMean = 0.9;  ///< of its pixels: colours under it are lighter by as much

}  // namespace vicus
