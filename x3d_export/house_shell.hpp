#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "city_db/city.hpp"

/// A house as one closed solid: floor, walls and roof, for formats that want solids.
namespace vicus {

enum class ShellPart { floor, wall, roof };

struct ShellFace {
  ShellPart part = ShellPart::wall;
  std::vector<std::vector<std::uint32_t>>
      rings;  ///< outer, then holes: indices of points; counter-clockwise from outside
};

/// Every edge of a face has its opposite in exactly one other face.
struct HouseShell {
  std::vector<RoofPoint> points;  ///< no two equal; above house.ground_m
  std::vector<ShellFace> faces;
};

/// From the walls' foot, where the house stands on the ground.
/// Needs   house.roof stands on the footprint's edges at the eave, as `vicus build` makes it.
HouseShell house_shell(const Building& house);

/// Wavefront OBJ: one object a house, named by its id; metres, x east, y north, z above the plan frame's 0. Faces with
/// holes are cut open along a line to each hole (floors) or come as triangles (roofs).
std::string obj_text(const City& city);

/// CityJSON 2.0: a Building with one Solid a house, with semantic surfaces; vertices of 1 mm in plan, 0.1 mm upwards.
/// Frame   metres east and north of the city's origin, which the title names: no code of EPSG is true for it.
std::string cityjson_text(const City& city);

}  // namespace vicus
