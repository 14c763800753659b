#pragma once
#include <memory>

#include "city_db/ground_tile.hpp"
#include "sectorgen/bake/render/render_mesh.hpp"

namespace vicus::measure {

/// A tile's ground as read: heights and its picture, ready to be drawn.
struct ReadGround {
  GroundTile tile;
  std::shared_ptr<const RepeatedImage> picture;
};

/// Fails   CityError: the picture is no WebP of the tile's size.
ReadGround read_ground(GroundTile tile);

/// Adds quadrants of a tile's ground as a client draws them (client_scripts/core/groundMesh.js), light by face.
/// `quadrants`: bit k for child k (city_db/tile_tree.hpp). Differs   without the skirt below the rim.
void add_ground(RenderMesh& mesh, const ReadGround& ground, unsigned quadrants);
inline constexpr unsigned kWholeTile = 15;

}  // namespace vicus::measure
