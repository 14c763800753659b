#pragma once
#include "sectorgen/bake/render/render.hpp"

namespace vicus {

/// What a visitor sees beyond the end of the city, where the map ends: ground that runs out in haze, a row of distant
/// houses, sky; behind what the city itself has there. Steady: equal from any place but for its distance.
/// `ground_m`: of the ground at the gate; `ground`: its colour.
/// Returns  the view's picture without a hole.
Picture with_distance(const View& view, const Camera& camera, double ground_m, Colour ground);

}  // namespace vicus
