#pragma once
#include <algorithm>
#include <cmath>

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
/// A third of the compass apart, so that no facade and no slope of a roof stays dark; the third shines a little
/// upwards, on undersides and crowns.
inline constexpr SunLight kLights[] = {
    {{0.6, -0.65, -0.5}, 1.0}, {{0.12, -0.35, 0.75}, 0.75}, {{-0.6, 0.15, -0.25}, 0.68}};

/// Sum of all lights on a face with this normal (any length, plan axes: east, north, up), as one factor of its colour;
/// what is shown is never above 1.
inline double light_on(double east, double north, double up) {
  double sum = 0;
  for (const SunLight& light : kLights) {
    const auto& way = light.direction;  // plan axes: x, -z, y
    const double against = -(east * way[0] - north * way[2] + up * way[1]);
    const double lengths =
        (east * east + north * north + up * up) * (way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    sum += light.intensity * std::max(0.0, against / std::sqrt(lengths));
  }
  return sum;
}

/// Sky: colours at these angles from straight up (the first: 0); ground: from straight down. The sky's go from the
/// first to the last as the square of the angle's sine, in steps so small that browsers, which draw a few straight
/// strips, show no edge between them.
inline constexpr double kSkyAngles[] = {0.25, 0.45, 0.65, 0.85, 1.05, 1.25, 1.4, 1.57}, kGroundAngles[] = {1.3, 1.57};
inline constexpr Colour kSkyColours[] = {{92, 141, 196},  {98, 145, 198},  {112, 155, 202},
                                         {130, 167, 208}, {151, 182, 214}, {170, 195, 220},
                                         {186, 206, 225}, {193, 211, 227}, kSkyColour};
inline constexpr Colour kGroundColours[] = {{120, 118, 112}, {150, 150, 146}, kSkyColour};

/// rad, of the smaller side of a view: in a narrow street one sees the eaves and the ground at once.
inline constexpr double kFieldOfView = 0.95;

}  // namespace vicus
