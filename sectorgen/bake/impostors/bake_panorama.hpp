#pragma once
#include <functional>
#include <vector>

#include "city_db/city.hpp"
#include "sectorgen/bake/render/ray_scene.hpp"

/// What open sectors see of the city beyond their L_vis, as pictures around them (paper 004 §4.1.7: open areas; §6).
namespace vicus {

/// A city as its far files show it.
struct FarCity {
  RayScene scene;
  std::vector<std::uint32_t> first_triangle;  ///< of each sector, in City's order; and the number of all
};

struct PanoramaOptions {
  double least_ground_m2 = 300;               ///< smaller squares and grounds have none
  double nearest_m = 150, nearest_radii = 2;  ///< what is nearer to the eye than either is not shown: it would be
                                              ///< displaced too much for who stands at the sector's rim
  int side_px = 128;                          ///< width of a side's picture; heights are powers of two up to as much
  int colours = 32;                           ///< of the palette
  int samples = 4;                            ///< a pixel
  int spots = 8;                              ///< of the sector, from which it is found out what can be seen
  int directions = 360;                       ///< that each spot looks in, between those of the others
  unsigned threads = 0;                       ///< 0: all cores
};

/// Is it a square, or open land, of some size?
bool is_open(const Sector& sector, const PanoramaOptions& options);

/// Of all open sectors that see anything, in their order. What L_vis names is left out: it comes itself, so a city with
/// whole lists over roofs has no panoramas.
///
/// Rays from spots all over the sector find the faces that are seen; these alone are drawn, whole, from its middle.
/// Behind nearer things they are hidden by them, wherever one stands.
/// Error   as any picture far behind: a thing at distance d is displaced by (eye's way) / d rad.
/// Cost    about 0.04 CPU s a sector.   Fails   CityError: out of memory.
std::vector<Panorama> bake_panoramas(const City& city, const FarCity& far, const PanoramaOptions& options,
                                     const std::function<void(std::size_t done)>& on_sector = {});

}  // namespace vicus
