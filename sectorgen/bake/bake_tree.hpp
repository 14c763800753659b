#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "city_db/tile_tree.hpp"
#include "sectorgen/bake/bake_blockmap.hpp"

/// The tiles of a city (city_db/tile_tree.hpp): which there are, and their bytes.
namespace vicus {

/// A BlockMap pays where it stands for many houses: 128 x 128 cells take some 40 kB, the prisms of kHousesWorth houses
/// with small facades as much. Below, polygons are the better tile (paper 000 §4: until "the cost of directly storing
/// and rendering the original becomes competitive").
inline constexpr std::size_t kHousesWorth = 128;
/// More houses than this are no tile of prisms: their triangles would be too many for one draw.
inline constexpr std::size_t kMostPrisms = 4096;
/// A tile with no more houses than this, and whose trees stand, has no children: its prisms are all there is.
inline constexpr std::size_t kFewHouses = 24;

struct TileNode {
  TileAddress at;
  std::size_t houses = 0;
  bool has_blockmap = false, has_prisms = false;
  std::uint64_t key = 0;  ///< of all that its bytes are made from
};

/// Levels of the tree over all houses and surfaces of a city.
int levels_of(const City& city);

/// From the root down, by level, row, column. Tiles without houses and trees are not among them,
/// but for the root.
std::vector<TileNode> plan_tiles(const BakeScene& scene, int levels, unsigned threads);

/// What a tile's path ends with.
enum class TileKind { blockmap, prisms, ground };
inline constexpr TileKind kTileKinds[] = {TileKind::blockmap, TileKind::prisms, TileKind::ground};
bool has_kind(const TileNode& node, TileKind kind);  ///< every tile has ground
/// Of "blockmaps/Z/X/Y" with what the kind ends with: the part before it, and which kind.
struct TileName {
  std::string_view address;  ///< "Z/X/Y"
  TileKind kind = TileKind::blockmap;
};
std::optional<TileName> parse_tile_path(std::string_view path);
std::string tile_path(const TileAddress& at, TileKind kind);
const char* media_type_of(TileKind kind);

/// Plain bytes, as decode_blockmap, decode_prisms or decode_ground read them.
/// `key`: of the tile, from plan_tiles; kept in the bytes.
std::string tile_bytes(const BakeScene& scene, int levels, const TileAddress& at, TileKind kind, std::uint64_t key);
/// The key that such bytes were made with; nullopt for bytes that are no such tile.
std::optional<std::uint64_t> key_of_bytes(std::string_view bytes, TileKind kind);

/// One tile as the client's list of tiles has it.
struct TileEntry {
  TileNode node;
  std::uint32_t blockmap_error_mm = 0, prism_error_mm = 0, top_mm = 0;
  std::size_t blockmap_bytes = 0, prism_bytes = 0, ground_bytes = 0;  ///< as sent
};
/// JSON: {"levels", "leafSide_m", "tiles": [[z, x, y, houses, blockmap error m | null, bytes, prisms error m | null,
/// bytes, bytes of the ground], ...]}
std::string tree_json(int levels, const std::vector<TileEntry>& tiles);
inline constexpr const char* kTreePath = "blockmaps/tree.json";

}  // namespace vicus
