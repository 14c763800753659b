#include "x3d_export/far_windows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "x3d_export/numbering.hpp"

namespace vicus {
namespace {

constexpr double kLow[] = {0.3, 0.28}, kHigh[] = {0.7, 0.82};  // the window's rims, shares across and upwards
constexpr double kGlass = 0.45;                                // of the wall's light
constexpr double kLeastWall_m = 2.2;

/// Share of texel i, counted from the left or from below, that is window along one axis.
double covered(int i, int axis) {
  const double low = std::max(kLow[axis] * kWindowTexels, double(i)),
               high = std::min(kHigh[axis] * kWindowTexels, i + 1.0);
  return std::max(0.0, high - low);
}

/// Of the pattern's light.
constexpr double kMean = 1 - (kHigh[0] - kLow[0]) * (kHigh[1] - kLow[1]) * (1 - kGlass);

}  // namespace

std::vector<std::int32_t> window_pattern() {
  std::vector<std::int32_t> out;
  for (int row = 0; row < kWindowTexels; ++row)
    for (int column = 0; column < kWindowTexels; ++column)
      out.push_back(
          static_cast<std::int32_t>(std::lround(255 * (1 - covered(column, 0) * covered(row, 1) * (1 - kGlass)))));
  return out;
}

Colour under_windows(Colour colour) { return shaded(colour, 1 / kMean); }

WindowGrid window_grid(double length_m, double bay_m, int floors) {
  if (length_m < kLeastWall_m || floors < 1) return {};
  constexpr double kMost = 250;  // Face holds a byte
  return {static_cast<int>(std::clamp(std::round(length_m / bay_m), 1.0, kMost)), floors};
}

Node windowed_shape(const std::string& def, std::span<const Face> faces) {
  std::vector<Face> bare(faces.begin(), faces.end());
  Numbering<std::array<double, 2>> places;
  const std::int32_t plain = places({0, 0});  // in the wall, whose light is whole
  std::vector<std::int32_t> index;
  for (Face& face : bare) {
    if (face.bays == 0) {
      index.insert(index.end(), static_cast<std::size_t>(face.count), plain);
    } else {
      face.colour = under_windows(face.colour);
      const double u = face.bays, v = face.floors;  // add_wall's corners: from the bottom left
      for (const auto& place : {std::array{0.0, 0.0}, {u, 0.0}, {u, v}, {0.0, v}}) index.push_back(places(place));
    }
    index.push_back(-1);
  }
  Node shape = shape_of(def, Shading::solid, bare);
  std::vector<double> numbers;
  for (const auto& place : places.items()) numbers.insert(numbers.end(), place.begin(), place.end());
  Node coordinate("TextureCoordinate"), texture("PixelTexture");
  coordinate.set("point", std::move(numbers));
  std::vector<std::int32_t> image{kWindowTexels, kWindowTexels, 1};  // width, height, components
  const auto pattern = window_pattern();
  image.insert(image.end(), pattern.begin(), pattern.end());
  texture.set("image", std::move(image));
  for (NodeField& field : shape.nodes) {
    Node& node = field.nodes.at(0);
    if (field.name == "appearance") node.add("texture", texture);
    if (field.name == "geometry") node.set("texCoordIndex", index).add("texCoord", coordinate);
  }
  return shape;
}

}  // namespace vicus
