#include "cli/tiles.hpp"

#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "city_db/blockmap_layout.h"
#include "city_db/byte_fields.hpp"
#include "city_db/issues.hpp"
#include "city_db/prism_tile_layout.h"
#include "city_db/run_parallel.hpp"
#include "city_db/store.hpp"
#include "sectorgen/bake/bake_tree.hpp"
#include "sectorgen/bake/read_scene.hpp"
#include "x3d_export/coding.hpp"
#include "x3d_export/package.hpp"

namespace vicus::cli {
namespace {

constexpr int kBrotliQuality = 9;
constexpr std::size_t kMostTile_bytes = std::size_t{16} << 20;

/// What the city that is replaced has for a path, plain and as stored.
class PreviousTiles {
 public:
  explicit PreviousTiles(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return;
    try {
      reader_.emplace(path);
    } catch (const CityError&) {  // another format, or damaged: everything is baked
    }
  }

  std::optional<Artefact> find(const std::string& path, TileKind kind, std::uint64_t key, std::string& plain) const {
    if (!reader_) return std::nullopt;
    auto artefact = reader_->artefact(path, {"br", "identity"});
    if (!artefact) return std::nullopt;
    auto bytes = artefact->coding == "br" ? unbrotli(artefact->body, kMostTile_bytes) : std::optional(artefact->body);
    if (!bytes || key_of_bytes(*bytes, kind) != key) return std::nullopt;
    plain = std::move(*bytes);
    return artefact;
  }

 private:
  std::optional<CityReader> reader_;
};

/// Of a path, plain; nullopt: it is not stored.   Fails   CityError: it is damaged.
std::optional<Artefact> plain_artefact(const CityReader& reader, const std::filesystem::path& city,
                                       const std::string& path) {
  auto artefact = reader.artefact(path, {"identity", "br"});
  if (!artefact || artefact->coding == "identity") return artefact;
  auto bytes = unbrotli(artefact->body, kMostTile_bytes);
  if (!bytes) throw CityError(city.string() + ": " + path + " is damaged: build the city again");
  artefact->body = std::move(*bytes);
  artefact->coding = "identity";
  return artefact;
}

void note(TileEntry& entry, TileKind kind, const std::string& plain, std::size_t bytes_sent) {
  if (kind == TileKind::blockmap)
    entry.blockmap_error_mm = u32_at(plain, BLOCKMAP_ERROR_AT), entry.blockmap_bytes = bytes_sent;
  if (kind == TileKind::prisms) entry.prism_error_mm = u32_at(plain, PRISM_ERROR_AT), entry.prism_bytes = bytes_sent;
  if (kind == TileKind::ground) entry.ground_bytes = bytes_sent;
}

}  // namespace

std::vector<Artefact> bake_tiles(const City& city, const std::filesystem::path& previous, unsigned threads) {
  const BakeScene scene(city, pictures_of(city), threads);
  const int levels = levels_of(city);
  const auto nodes = plan_tiles(scene, levels, threads);
  std::vector<TileEntry> entries(nodes.size());
  std::vector<std::vector<Artefact>> made(nodes.size());
  std::vector<std::unique_ptr<PreviousTiles>> old(thread_count(threads));  // a reader is for one thread
  run_parallel(nodes.size(), thread_count(threads), [&](std::size_t i, unsigned thread) {
    if (!old[thread]) old[thread] = std::make_unique<PreviousTiles>(previous);
    const TileNode& node = nodes[i];
    entries[i].node = node;
    for (const TileKind kind : kTileKinds) {
      if (!has_kind(node, kind)) continue;
      const std::string path = tile_path(node.at, kind);
      std::string plain;
      auto artefact = old[thread]->find(path, kind, node.key, plain);
      if (!artefact) {
        plain = tile_bytes(scene, levels, node.at, kind, node.key);
        artefact = stored(path, media_type_of(kind), plain, kBrotliQuality);
      }
      note(entries[i], kind, plain, artefact->body.size());
      made[i].push_back(std::move(*artefact));
    }
  });
  std::vector<Artefact> out;
  for (auto& list : made) std::move(list.begin(), list.end(), std::back_inserter(out));
  out.push_back(stored(kTreePath, "application/json", tree_json(levels, entries), kBrotliQuality));
  return out;
}

std::vector<Artefact> stored_tiles(const std::filesystem::path& city) {
  const CityReader reader(city);
  const auto tree = plain_artefact(reader, city, kTreePath);
  if (!tree) return {};
  std::vector<Artefact> out{*tree};
  const auto damaged = [&] {
    return CityError(city.string() + ": " + kTreePath + " is damaged: build the city again");
  };
  const auto list = nlohmann::json::parse(tree->body, nullptr, false);
  if (!list.is_object() || !list.contains("tiles") || !list["tiles"].is_array()) throw damaged();
  constexpr std::size_t kFields = 9, kBlockMapError = 4, kPrismError = 6;  // of tree_json
  for (const auto& tile : list["tiles"]) {
    if (!tile.is_array() || tile.size() != kFields) throw damaged();
    for (std::size_t i = 0; i < 3; ++i)
      if (!tile[i].is_number_unsigned()) throw damaged();
    const TileAddress at{tile[0].get<int>(), tile[1].get<std::uint32_t>(), tile[2].get<std::uint32_t>()};
    for (const TileKind kind : kTileKinds) {
      if (kind == TileKind::blockmap && tile[kBlockMapError].is_null()) continue;
      if (kind == TileKind::prisms && tile[kPrismError].is_null()) continue;
      auto found = plain_artefact(reader, city, tile_path(at, kind));
      if (!found) throw CityError(city.string() + " lacks " + tile_path(at, kind) + ": build the city again");
      out.push_back(std::move(*found));
    }
  }
  return out;
}

std::function<std::optional<Artefact>()> followed_by(std::function<std::optional<Artefact>()> first,
                                                     std::vector<Artefact> then) {
  const auto rest = std::make_shared<std::vector<Artefact>>(std::move(then));
  return [first = std::move(first), rest, at = std::size_t{0}]() mutable -> std::optional<Artefact> {
    if (auto artefact = first()) return artefact;
    if (at == rest->size()) return std::nullopt;
    return std::move((*rest)[at++]);
  };
}

std::optional<MadeTile> make_tile(const std::filesystem::path& city, const std::string& path) {
  const auto name = parse_tile_path(path);
  if (!name) return std::nullopt;
  const CityReader reader(city);
  int levels = 0;
  if (const auto text = reader.meta("tile_levels")) std::from_chars(text->data(), text->data() + text->size(), levels);
  if (levels < 1 || levels > kMostTileLevels) return std::nullopt;  // built by a program that knew no tiles
  const auto at = parse_tile(name->address, levels);
  if (!at) return std::nullopt;
  const PlanBox box = tile_box(levels, *at);
  if (reader.buildings_in(box, 1, 0).empty()) return std::nullopt;
  const BakeScene scene = read_scene(reader, box);
  if (name->kind == TileKind::prisms && scene.houses_in(box).size() > kMostPrisms) return std::nullopt;
  return MadeTile{media_type_of(name->kind), tile_bytes(scene, levels, *at, name->kind, 0)};
}

}  // namespace vicus::cli
