#include "sectorgen/bake/bake_tree.hpp"

#include <algorithm>
#include <cstdio>
#include <tuple>

#include "city_db/blockmap_layout.h"
#include "city_db/byte_fields.hpp"
#include "city_db/ground_tile_layout.h"
#include "city_db/prism_tile_layout.h"
#include "city_db/run_parallel.hpp"
#include "sectorgen/bake/bake_ground.hpp"
#include "sectorgen/bake/bake_prisms.hpp"
#include "sectorgen/bake/prism_trees.hpp"

namespace vicus {
namespace {

constexpr std::uint64_t kBakerVersion = 7;  // of everything that turns a scene into bytes: raise it when that changes

void add_below(const BakeScene& scene, int levels, const TileAddress& at, std::vector<TileNode>& out) {
  TileNode node;
  node.at = at;
  const PlanBox box = tile_box(levels, at);
  node.houses = scene.houses_in(box).size();
  const bool is_empty = node.houses == 0 && scene.trees_in(box).empty();
  if (is_empty && at.z > 0) return;
  node.has_blockmap = node.houses >= kHousesWorth || at.z == 0;
  node.has_prisms = !is_empty && node.houses <= kMostPrisms;
  out.push_back(node);
  const bool has_all = node.houses <= kFewHouses && has_standing_trees(scene, box.min, tile_side_mm(levels, at.z));
  if (has_all || at.z + 1 == levels) return;
  for (int which = 0; which < 4; ++which) add_below(scene, levels, child_of(at, which), out);
}

struct TileTraits {
  const char* suffix;
  const char* media_type;
  std::size_t header_bytes, key_at;
  std::uint32_t magic;
};
static_assert(BLOCKMAP_MAGIC_AT == 0 && PRISM_MAGIC_AT == 0 && GROUND_MAGIC_AT == 0);
const TileTraits& traits_of(TileKind kind) {
  static constexpr TileTraits kTraits[] = {
      {"", "application/vnd.vicus.blockmap", BLOCKMAP_HEADER_BYTES, BLOCKMAP_KEY_AT, BLOCKMAP_MAGIC},
      {".prisms", "application/vnd.vicus.prisms", PRISM_HEADER_BYTES, PRISM_KEY_AT, PRISM_MAGIC},
      {".ground", "application/vnd.vicus.ground", GROUND_HEADER_BYTES, GROUND_KEY_AT, GROUND_MAGIC}};
  return kTraits[static_cast<std::size_t>(kind)];
}

std::string error_text(bool has, std::uint32_t error_mm) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", error_mm / 1000.0);
  return has ? text : "null";
}

}  // namespace

int levels_of(const City& city) {
  PlanBox box;
  for (const Building& house : city.buildings)
    for (const PlanPoint p : house.footprint.outer) box.add(p);
  for (const Surface& surface : city.surfaces)
    for (const GroundPoint& p : surface.points) box.add(p.at);
  return tile_levels(box);
}

std::vector<TileNode> plan_tiles(const BakeScene& scene, int levels, unsigned threads) {
  std::vector<TileNode> out;
  add_below(scene, levels, {}, out);
  std::stable_sort(out.begin(), out.end(), [](const TileNode& a, const TileNode& b) {
    return std::tie(a.at.z, a.at.y, a.at.x) < std::tie(b.at.z, b.at.y, b.at.x);
  });
  run_parallel(out.size(), thread_count(threads), [&](std::size_t i, unsigned) {
    KeyHash hash;
    hash.add(kBakerVersion);
    hash.add(scene.key_of(tile_box(levels, out[i].at)));
    out[i].key = hash.value();
  });
  return out;
}

bool has_kind(const TileNode& node, TileKind kind) {
  return kind == TileKind::ground || (kind == TileKind::prisms ? node.has_prisms : node.has_blockmap);
}

std::string tile_path(const TileAddress& at, TileKind kind) { return tile_path(at) + traits_of(kind).suffix; }

std::optional<TileName> parse_tile_path(std::string_view path) {
  constexpr std::string_view kFolder = "blockmaps/";
  if (!path.starts_with(kFolder)) return std::nullopt;
  TileName name{path.substr(kFolder.size())};
  for (const TileKind kind : {TileKind::prisms, TileKind::ground})
    if (const std::string_view suffix = traits_of(kind).suffix; name.address.ends_with(suffix)) {
      name.address.remove_suffix(suffix.size());
      name.kind = kind;
      break;
    }
  return name;
}

const char* media_type_of(TileKind kind) { return traits_of(kind).media_type; }

std::string tile_bytes(const BakeScene& scene, int levels, const TileAddress& at, TileKind kind, std::uint64_t key) {
  const PlanPoint corner = tile_corner(levels, at);
  const std::uint32_t side = tile_side_mm(levels, at.z);
  const auto with_key = [&](auto tile) {
    tile.key = key;
    return tile;
  };
  if (kind == TileKind::prisms) return encode_prisms(with_key(bake_prisms(scene, corner, side)));
  if (kind == TileKind::ground) return encode_ground(with_key(bake_ground(scene, corner, side)));
  return encode_blockmap(with_key(bake_blockmap(scene, corner, side)));
}

std::optional<std::uint64_t> key_of_bytes(std::string_view bytes, TileKind kind) {
  const TileTraits& traits = traits_of(kind);
  if (bytes.size() < traits.header_bytes || u32_at(bytes, 0) != traits.magic) return std::nullopt;
  return field_at(bytes, traits.key_at, 8);
}

std::string tree_json(int levels, const std::vector<TileEntry>& tiles) {
  std::string out = "{\"levels\":" + std::to_string(levels) + ",\"leafSide_m\":" + std::to_string(kLeafSide_mm / 1000) +
                    ",\"tiles\":[";
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const TileEntry& t = tiles[i];
    out += (i == 0 ? "\n[" : ",\n[") + std::to_string(t.node.at.z) + "," + std::to_string(t.node.at.x) + "," +
           std::to_string(t.node.at.y) + "," + std::to_string(t.node.houses) + "," +
           error_text(t.node.has_blockmap, t.blockmap_error_mm) + "," + std::to_string(t.blockmap_bytes) + "," +
           error_text(t.node.has_prisms, t.prism_error_mm) + "," + std::to_string(t.prism_bytes) + "," +
           std::to_string(t.ground_bytes) + "]";
  }
  return out + "\n]}\n";
}

}  // namespace vicus
