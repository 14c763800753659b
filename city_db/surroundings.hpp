#pragma once
#include "city_db/colour.hpp"

/// Light and sky of every root world: for the scene, and for pictures that shall look like it.
/// Frame   X3D axes.
namespace vicus {

/// At the horizon; the backdrop of end-of-city gates has it too, so that the city seems to end in haze.
inline constexpr Colour kSkyColour{196, 213, 228};

struct SunLight {
  double direction[3];  ///< the way the light goes; not of length 1
  double intensity;
};
/// A third of the compass apart, so that no facade stays dark; the third shines upwards, on undersides and crowns.
inline constexpr SunLight kLights[] = {
    {{0.6, -0.5, -0.5}, 1.0}, {{0.12, -0.3, 0.75}, 0.75}, {{-0.6, 0.45, -0.25}, 0.65}};

/// Sky: colours at these angles from straight up (the first: 0); ground: from straight down.
inline constexpr double kSkyAngles[] = {0.9, 1.57}, kGroundAngles[] = {1.3, 1.57};
inline constexpr Colour kSkyColours[] = {{92, 141, 196}, {150, 186, 220}, kSkyColour};
inline constexpr Colour kGroundColours[] = {{120, 118, 112}, {150, 150, 146}, kSkyColour};

/// rad, of the smaller side of a view: in a narrow street one sees the eaves and the ground at once.
inline constexpr double kFieldOfView = 0.95;

}  // namespace vicus
