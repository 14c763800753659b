#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "city_db/city.hpp"

/// Points with heights and what they carry, as bytes of the city file (FORMAT.md, "Mesh", "Ride").
/// decode_*(encode_*(x)) == x; decode_* gives nullopt for bytes that encode_* cannot have made.
namespace vicus {

std::string encode_mesh(const std::vector<GroundPoint>& points, const Triangles& triangles,
                        const std::vector<Colour>& colours = {});

struct Mesh3 {
  std::vector<GroundPoint> points;
  Triangles triangles;
  std::vector<Colour> colours;  ///< none, or one each triangle
};
std::optional<Mesh3> decode_mesh(std::string_view bytes);

/// Heights in whole millimetres, times in whole milliseconds.
std::string encode_ride(const std::vector<RidePoint>& points);
std::optional<std::vector<RidePoint>> decode_ride(std::string_view bytes);

}  // namespace vicus
