#include <array>
#include <map>
#include <tuple>
#include <unordered_map>

#include "city_db/run_parallel.hpp"
#include "sectorgen/models/facades.hpp"
#include "sectorgen/models/paint_facade.hpp"
#include "sectorgen/models/paint_grain.hpp"
#include "sectorgen/models/paint_openings.hpp"
#include "sectorgen/models/palette_png.hpp"

namespace vicus {
namespace {

constexpr int kFacadeColours = 16;  // 4 bits a pixel; more shows no better and doubles the bytes
constexpr int kAtlasColours = 64;

/// All that a picture depends on.
auto picture_key(const Facade& facade, Colour wall) {
  const Facade f = image_pattern(facade);
  std::vector<std::array<double, 5>> own;
  for (const Opening& o : f.openings) own.push_back({static_cast<double>(o.kind), o.x0, o.x1, o.z0, o.z1});
  if (!own.empty()) own.push_back({pattern_width_m(f), pattern_height_m(f), 0, 0, 0});
  return std::make_tuple(f.style, wall, f.floors, f.bays, f.door_bay, f.has_shop, std::move(own));
}

}  // namespace

void paint_textures(City& city, unsigned threads) {
  std::unordered_map<std::string, Colour> wall;
  for (const auto& house : city.buildings) wall.emplace(house.id, house.wall_colour);
  std::map<decltype(picture_key({}, {})), std::vector<std::size_t>> users;
  for (std::size_t i = 0; i < city.facades.size(); ++i)
    if (city.facades[i].texture.empty())
      users[picture_key(city.facades[i], wall[city.facades[i].building_id])].push_back(i);

  std::vector<std::pair<Colour, std::vector<std::size_t>>> pictures;
  for (auto& [key, list] : users) pictures.emplace_back(std::get<Colour>(key), std::move(list));
  std::vector<Texture> textures(pictures.size());
  run_parallel(pictures.size(), thread_count(threads), [&](std::size_t i, unsigned) {
    const auto& [colour, list] = pictures[i];
    textures[i] = palette_texture(paint_facade(image_pattern(city.facades[list.front()]), colour), kFacadeColours);
  });
  std::map<std::string, Texture> by_id;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (const std::size_t facade : pictures[i].second) city.facades[facade].texture = textures[i].id;
    by_id.emplace(textures[i].id, std::move(textures[i]));
  }
  Texture atlas = palette_texture(paint_atlas(), kAtlasColours);
  city.meta["atlas"] = atlas.id;
  by_id.emplace(atlas.id, std::move(atlas));
  Texture grain = paint_grain();
  city.meta["grain"] = grain.id;
  by_id.emplace(grain.id, std::move(grain));
  for (auto& texture : city.textures) by_id.emplace(texture.id, std::move(texture));
  city.textures.clear();
  for (auto& [id, texture] : by_id) city.textures.push_back(std::move(texture));
}

}  // namespace vicus
