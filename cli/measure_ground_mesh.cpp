#include "cli/measure_ground_mesh.hpp"

#include "city_db/issues.hpp"
#include "sectorgen/bake/webp_image.hpp"

namespace vicus::measure {

ReadGround read_ground(GroundTile tile) {
  const auto image = decode_webp(tile.picture, tile.picture_side, tile.picture_side);
  if (!image) throw CityError("the picture of a ground tile cannot be read");
  Picture picture(static_cast<int>(image->width), static_cast<int>(image->height));
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) picture.pixels[i][k] = static_cast<float>(image->rgb[3 * i + k]) / 255;
  return {std::move(tile), std::make_shared<RepeatedImage>(opaque(picture))};
}

void add_ground(RenderMesh& mesh, const ReadGround& ground, unsigned quadrants) {
  const GroundTile& tile = ground.tile;
  const auto nodes = tile.nodes, half = (nodes - 1) / 2, first = static_cast<std::uint32_t>(mesh.points.size());
  const double step = metres(static_cast<std::int64_t>(tile.tile_side_mm)) / (nodes - 1);
  for (std::uint32_t row = 0; row < nodes; ++row)
    for (std::uint32_t column = 0; column < nodes; ++column)
      mesh.add_point({metres(tile.corner.x) + column * step, metres(tile.corner.y) + row * step,
                      metres(tile.base_mm + std::int64_t{tile.step_mm} * tile.height[row * nodes + column])});
  mesh.images.push_back(ground.picture);
  const auto number = static_cast<std::uint32_t>(mesh.images.size() - 1);
  // Half a texel off the rim, where the image would begin again.
  const auto place = [&](std::uint32_t i) {
    const auto texel = 1 / static_cast<float>(tile.picture_side);
    return texel / 2 + (1 - texel) * static_cast<float>(i) / static_cast<float>(nodes - 1);
  };
  for (std::uint32_t row = 0; row + 1 < nodes; ++row)
    for (std::uint32_t column = 0; column + 1 < nodes; ++column) {
      if (!(quadrants >> ((row >= half ? 2 : 0) + (column >= half ? 1 : 0)) & 1)) continue;
      const std::uint32_t a = first + row * nodes + column, b = a + 1, c = a + nodes, d = c + 1;
      const std::array west_south{place(column), place(row)}, east_south{place(column + 1), place(row)},
          west_north{place(column), place(row + 1)}, east_north{place(column + 1), place(row + 1)};
      for (const bool is_south : {true, false}) {
        RenderTriangle t{is_south ? std::array{a, b, d} : std::array{a, d, c}, {}};
        t.image = number;
        t.places = static_cast<std::uint32_t>(mesh.places.size());
        mesh.places.push_back(is_south ? std::array{west_south, east_south, east_north}
                                       : std::array{west_south, east_north, west_north});
        mesh.triangles.push_back(t);
      }
    }
}

}  // namespace vicus::measure
