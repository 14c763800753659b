#include "x3d_export/house_nodes.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>

#include "city_db/boxes.hpp"
#include "x3d_export/facade_levels.hpp"
#include "x3d_export/house_body.hpp"
#include "x3d_export/shared_points.hpp"

namespace vicus {
namespace {

constexpr int kMostOpenings = 60;  // of one LOD node: its fourth level stays below 30 kB
constexpr double kCentre_m = 1.7;  // of an LOD node, above ground: distances are the walker's

/// What one house has in the sector.
struct Share {
  const Building* house = nullptr;
  std::vector<const Facade*> facades;
  bool has_body = false;  // this sector sends its roof and side walls
};

std::map<std::string, Share> shares_of(const CityIndex& index, const Sector& sector) {
  std::map<std::string, Share> shares;
  if (!index.city().meta.contains("atlas")) return shares;
  for (const Facade* facade : index.facades_of(sector.id)) {
    const Building* house = index.building(facade->building_id);
    if (!house || house->base_m > 0) continue;
    Share& share = shares[house->id];
    share.house = house;
    share.facades.push_back(facade);
  }
  for (const Building* house : index.buildings_of(sector.id))
    if (const auto at = shares.find(house->id); at != shares.end()) at->second.has_body = true;
  return shares;
}

Node level_node(const LevelFaces& faces, const std::string& atlas, SharedPoints* points = nullptr) {
  Node group("Group");
  if (!faces.solid.empty()) group.add(shape_of("", Shading::solid, faces.solid, points));
  const auto add = [&](const std::string& image, const std::vector<TexturedFace>& list) {
    group.add(textured_shape(image, texture_url(image), list, points));
  };
  const auto behind_atlas = faces.own_images.upper_bound(atlas);
  for (auto at = faces.own_images.begin(); at != behind_atlas; ++at) add(at->first, at->second);
  if (!faces.atlas.empty()) add(atlas, faces.atlas);
  for (auto at = behind_atlas; at != faces.own_images.end(); ++at) add(at->first, at->second);
  return group;
}

X3dPoint centre_of(const PlanBox& box, double ground_m, PlanPoint origin) {
  const PlanPoint middle{box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
  return x3d_from_plan(middle, height_mm(ground_m + kCentre_m), origin);
}

Node lod_node(const LevelPiece& piece, std::size_t number, const std::string& atlas, int finest) {
  const X3dPoint& centre = piece.centre;
  Node lod("LOD");
  lod.set("center", std::vector<double>{metres(centre.x), metres(centre.y), metres(centre.z)});
  lod.set("range", std::vector<double>(std::begin(kLevelRanges_m) + (4 - finest), std::end(kLevelRanges_m)));
  SharedPoints points("CORNERS-" + std::to_string(number));
  for (int level = finest - 1; level >= 0; --level) lod.add(level_node(piece.levels[level], atlas, &points));
  points.put_into(lod);
  return lod;
}

/// Chimneys get at most half of the triangles that the windows of the first facade take in level 2.
std::vector<Face> chimneys_of(const Share& share, const Facade& first, PlanPoint origin) {
  FaceList chimneys(origin, share.house->ground_m);
  if (share.has_body)
    add_chimneys(chimneys, *share.house, static_cast<int>(openings_of(first).size()) / kChimneyTriangles);
  return chimneys.take();
}

std::vector<LevelPiece> pieces_of(const Share& share, PlanPoint origin) {
  std::vector<Facade> parts;
  for (const Facade* facade : share.facades)
    for (Facade& part : split_facade(*facade, kMostOpenings)) parts.push_back(std::move(part));
  const auto chimneys = chimneys_of(share, parts.front(), origin);
  std::size_t taken = 2 * chimneys.size();
  std::vector<LevelPiece> pieces(1);
  PlanBox box;
  int openings = 0;
  for (const Facade& part : parts) {
    const int count = opening_count(part);
    if (openings > 0 && openings + count > kMostOpenings) {
      pieces.emplace_back();
      box = {};
      openings = 0;
    }
    openings += count;
    add_facade(part, share.house->wall_colour, share.house->ground_m, origin, taken, pieces.back().levels);
    box.add(part.a);
    box.add(part.b);
    pieces.back().centre = centre_of(box, share.house->ground_m, origin);
    taken = 0;
  }
  for (int level = 2; level < 4; ++level) {
    auto& solid = pieces.front().levels[level].solid;
    solid.insert(solid.end(), chimneys.begin(), chimneys.end());
  }
  return pieces;
}

int openings_in(const CityIndex& index, const Sector& sector) {
  int openings = 0;
  for (const Facade* f : index.facades_of(sector.id)) openings += opening_count(*f);
  return openings;
}

}  // namespace

int finest_level(const CityIndex& index, const Sector& sector) {
  return openings_in(index, sector) <= kMostDeepOpenings ? 4 : 3;
}

LeveledStretches stretches_with_levels(const CityIndex& index, const Sector& sector) {
  LeveledStretches stretches;
  for (const auto& [id, share] : shares_of(index, sector))
    for (const Facade* facade : share.facades) stretches.emplace(std::pair(facade->a, facade->b), facade->bottom_m);
  return stretches;
}

std::vector<LevelPiece> sector_pieces(const CityIndex& index, const Sector& sector) {
  std::vector<LevelPiece> all;
  const bool has_quads = openings_in(index, sector) <= kMostQuads;
  for (const auto& [id, share] : shares_of(index, sector))
    for (LevelPiece& piece : pieces_of(share, sector.origin)) {
      if (!has_quads) piece.levels[1] = piece.levels[0];
      all.push_back(std::move(piece));
    }
  return all;
}

int level_at(double distance_m, int finest) {
  int level = 4;
  for (const double range : kLevelRanges_m) level -= distance_m >= range ? 1 : 0;
  return std::min(level, finest);
}

LevelFaces sector_facades(const CityIndex& index, const Sector& sector, int level) {
  assert(level >= 1 && level <= 4);
  LevelFaces all;
  const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  for (const LevelPiece& piece : sector_pieces(index, sector)) {
    const LevelFaces& faces = piece.levels[level - 1];
    append(all.solid, faces.solid);
    append(all.atlas, faces.atlas);
    for (const auto& [image, list] : faces.own_images) append(all.own_images[image], list);
  }
  return all;
}

std::vector<Node> house_nodes(const CityIndex& index, const Sector& sector, SceneFormat format, int only_level) {
  std::vector<Node> nodes;
  const auto pieces = sector_pieces(index, sector);
  if (pieces.empty()) return nodes;
  const std::string& atlas = index.city().meta.at("atlas");
  const int finest = finest_level(index, sector);
  if (format == SceneFormat::vrml) only_level = 2;
  for (const LevelPiece& piece : pieces)
    nodes.push_back(only_level != 0 ? level_node(piece.levels[std::min(only_level, finest) - 1], atlas)
                                    : lod_node(piece, nodes.size(), atlas, finest));
  return nodes;
}

int count_shapes(const Node& node) {
  int count = node.type == "Shape" ? 1 : 0;
  for (const auto& field : node.nodes)
    for (const auto& child : field.nodes) count += count_shapes(child);
  return count;
}

}  // namespace vicus
