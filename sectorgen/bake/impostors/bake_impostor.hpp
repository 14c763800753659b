#pragma once
#include <functional>
#include <optional>

#include "city_db/city.hpp"
#include "sectorgen/bake/impostors/city_ground.hpp"
#include "sectorgen/bake/render/ray_scene.hpp"

/// Pictures of what lies beyond gates, taken of the city itself (paper 004 §4.1.7).
namespace vicus {

/// Where the picture stands.
enum class ImpostorPlane {
  gate,  ///< in the gate: nothing shows beside it, and what comes behind it can be faded in
  best   ///< at 1/D = (1/near + 1/far) / 2, where it is displaced the least; beyond the gate
};

struct ImpostorOptions {
  ImpostorPlane plane = ImpostorPlane::gate;
  double share = 1;      ///< of the way to the sector's most distant point (capture_point)
  int most_px = 128;     ///< longer side, a power of two
  int colours = 32;      ///< of the palette
  int samples = 4;       ///< a pixel
  unsigned threads = 0;  ///< of bake_impostors; 0: all cores
};

/// Limits of the error by which validity is judged: 2 pixels of a view of 480 lines and 45 degrees.
inline constexpr double kValid_px = 2, kViewUnit_px = 579;

/// The picture of one gate; nullopt: the gate is too narrow, or nothing but sky is behind it and the city goes on.
///
/// Its frustum's window is the gate, from the ground to the top of all that is seen in it: what is seen beside its
/// edges is the sector's own. Sides are powers of two. A gate of several segments counts as its chord.
/// `scene`: the whole city.
/// Fails   CityError: out of memory.
/// Source  paper 004 §4.1.7; research on image-based representations for plane and validity.
std::optional<GateImpostor> bake_impostor(const CityGround& ground, const RayScene& scene, const Gate& gate,
                                          const ImpostorOptions& options);

/// Of all gates, in their order. `on_gate` is told how many are done, from any thread.
std::vector<GateImpostor> bake_impostors(const City& city, const RayScene& scene, const ImpostorOptions& options,
                                         const std::function<void(std::size_t done)>& on_gate = {});

/// Displacement in pixels of a thing `thing_m` ahead of the capture point, shown by a picture `plane_m` ahead, for an
/// eye `away_m` beside it: f * away * |1/plane - 1/thing|.
double displacement_px(double unit_px, double away_m, double plane_m, double thing_m);

}  // namespace vicus
