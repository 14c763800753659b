#include "x3d_export/far_windows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "x3d_export/numbering.hpp"

namespace vicus {
namespace {

// Texels of the window, from left and below, rims on whole texels: they are seen sharp from near. One texel of frame
// all round, and one across.
constexpr int kLeft = 5, kRight = 11, kBottom = 4, kTop = 13, kTransom = 9;
constexpr int kWall = 255, kFrame = 205, kGlass = 95;
constexpr double kLeastWall_m = 2.2;

/// Grey of a texel, counted from the left and from below.
constexpr int grey(int column, int row) {
  if (column < kLeft || column >= kRight || row < kBottom || row >= kTop) return kWall;
  const bool is_rim = column == kLeft || column == kRight - 1 || row == kBottom || row == kTop - 1;
  return is_rim || row == kTransom ? kFrame : kGlass;
}

/// Of the pattern's light.
constexpr double mean_light() {
  int sum = 0;
  for (int row = 0; row < kWindowTexels; ++row)
    for (int column = 0; column < kWindowTexels; ++column) sum += grey(column, row);
  return sum / (255.0 * kWindowTexels * kWindowTexels);
}
constexpr double kMean = mean_light();

}  // namespace

std::vector<std::int32_t> window_pattern() {
  std::vector<std::int32_t> out;
  for (int row = 0; row < kWindowTexels; ++row)
    for (int column = 0; column < kWindowTexels; ++column) out.push_back(grey(column, row));
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
  Node coordinate("TextureCoordinate"), texture("PixelTexture"), properties("TextureProperties");
  coordinate.set("point", std::move(numbers));
  std::vector<std::int32_t> image{kWindowTexels, kWindowTexels, 1};  // width, height, components
  const auto pattern = window_pattern();
  image.insert(image.end(), pattern.begin(), pattern.end());
  texture.set("image", std::move(image));
  properties.set("generateMipMaps", true).set("minificationFilter", std::string("AVG_PIXEL_AVG_MIPMAP"));
  texture.add("textureProperties", properties.set("magnificationFilter", std::string("NEAREST_PIXEL")));
  for (NodeField& field : shape.nodes) {
    Node& node = field.nodes.at(0);
    if (field.name == "appearance") node.add("texture", texture);
    if (field.name == "geometry") node.set("texCoordIndex", index).add("texCoord", coordinate);
  }
  return shape;
}

}  // namespace vicus
