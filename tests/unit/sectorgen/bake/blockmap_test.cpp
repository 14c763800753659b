#include "sectorgen/bake/bake_blockmap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "city_db/blockmap_layout.h"
#include "city_db/boxes.hpp"
#include "city_db/terrain.hpp"
#include "city_db/tile_tree.hpp"
#include "sectorgen/bake/bake_ground.hpp"
#include "sectorgen/bake/bake_paper.hpp"
#include "sectorgen/bake/bake_prisms.hpp"
#include "sectorgen/bake/bake_tree.hpp"
#include "sectorgen/bake/few_colours.hpp"
#include "sectorgen/bake/raycast_reference.hpp"
#include "sectorgen/bake/webp_image.hpp"
#include "tests/support/built_city.hpp"
#include "tests/support/flight.hpp"
#include "tests/support/sample_city.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// BlockMaps of towns: what is baked is what stands there, and both casters see it alike.
namespace vicus::test {
namespace {

constexpr std::uint32_t kTile_mm = 128'000;

const City& town() {
  static const City kCity = random_town_city(7);
  return kCity;
}
const BakeScene& town_scene() {
  static const BakeScene kScene(town(), pictures_of(town()), 2);
  return kScene;
}

/// The corners of tiles with houses.
std::vector<PlanPoint> town_tiles() {
  std::vector<PlanPoint> out;
  const PlanBox box = town_scene().box();
  const int levels = tile_levels(box);
  for (std::uint32_t y = 0; y < 1u << (levels - 1); ++y)
    for (std::uint32_t x = 0; x < 1u << (levels - 1); ++x)
      if (const TileAddress at{levels - 1, x, y}; town_scene().houses_in(tile_box(levels, at)).size() > 3)
        out.push_back(tile_corner(levels, at));
  return out;
}

PlanRay random_ray(std::mt19937_64& random, PlanPoint corner) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double x = metres(corner.x) + 128 * unit(random), y = metres(corner.y) + 128 * unit(random);
  const double turn = 6.283185307179586 * unit(random), steep = 0.02 + 1.5 * unit(random);
  const double back = 40 + 200 * unit(random);
  return {x - std::cos(turn) * back,
          y - std::sin(turn) * back,
          3 + 10 * unit(random) + back * steep,
          std::cos(turn),
          std::sin(turn),
          -steep};
}

TEST(BlockMap, BothCastersSeeTheSame) {
  for (const std::uint64_t seed : seeds(1, 4)) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const auto tiles = town_tiles();
    ASSERT_FALSE(tiles.empty());
    const PlanPoint corner = tiles[seed % tiles.size()];
    BlockMapOptions options;
    options.side = seed % 2 ? 64 : 128;
    const BlockMap map = bake_unpacked(town_scene(), corner, kTile_mm, options).map;
    const BlockMapCaster caster(map);
    int different = 0, hits = 0;
    for (int i = 0; i < 4000; ++i) {
      const PlanRay ray = random_ray(random, corner);
      const CastHit fast = caster.cast(ray), slow = raycast_reference(map, ray);
      hits += bool(slow);
      const double off = std::abs(fast.t - slow.t);
      if (bool(fast) != bool(slow) || (fast && off > 0.002)) ++different;
    }
    EXPECT_GT(hits, 1000);
    EXPECT_LE(different, 4) << "of " << hits;  // rays that graze an edge
  }
}

/// A pixel that differs has a neighbour in the other picture that does not.
TEST(BlockMap, PicturesOfBothCastersAgreeWithinAPixel) {
  const PlanPoint corner = town_tiles().front();
  const BlockMap map = bake_unpacked(town_scene(), corner, kTile_mm).map;
  const BlockMapCaster caster(map);
  for (const double elevation : {5.0, 30.0, 70.0}) {
    SCOPED_TRACE(elevation);
    const Camera camera = camera_around(metres(corner.x) + 64, metres(corner.y) + 64, 5, 150, elevation, 40, 96, 72);
    std::vector<double> slow;
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column)
        slow.push_back(raycast_reference(map, camera.ray(column + 0.5, row + 0.5)).t);
    for (int row = 1; row + 1 < camera.height; ++row)
      for (int column = 1; column + 1 < camera.width; ++column) {
        const double t = caster.cast(camera.ray(column + 0.5, row + 0.5)).t;
        bool agrees = false;
        for (int r = row - 1; r <= row + 1; ++r)
          for (int c = column - 1; c <= column + 1; ++c) {
            const double other = slow[static_cast<std::size_t>(r * camera.width + c)];
            const bool is_own = r == row && c == column;
            agrees = agrees || (std::isinf(t) && std::isinf(other)) || std::abs(t - other) < (is_own ? 0.002 : 8);
          }
        EXPECT_TRUE(agrees) << column << ' ' << row;
      }
  }
}

/// A bound of the distance of a point from the tile's surface: the nearest of what rays past it meet.
double distance_by_rays(const BlockMapCaster& caster, const PlanRay& ray, double x, double y, double z, double reach) {
  double least = 1e9;
  const auto look = [&](const PlanRay& r) {
    const CastHit hit = caster.cast(r);
    if (!hit) return;
    const double dx = r.x + hit.t * r.dx - x, dy = r.y + hit.t * r.dy - y, dz = r.z + hit.t * r.dz - z;
    least = std::min(least, std::sqrt(dx * dx + dy * dy + dz * dz));
  };
  look(ray);
  for (const double radius : {0.2, 0.5, 0.95})
    for (int k = 0; k < 16; ++k) {
      const double a = reach * radius * std::cos(k * 0.3927), b = reach * radius * std::sin(k * 0.3927);
      PlanRay aside = ray;
      aside.x += -a * ray.dy;
      aside.y += a * ray.dx;
      aside.z += b;
      look(aside);
      look({x + a, y + b, z + 200, 0.0001, 0.0001, -1});
      look({x + a, y + b, z + 200, ray.dx * 0.3, ray.dy * 0.3, -1});
      for (const auto& [dx, dy] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}})
        look({x - dx * (reach + 1) - dy * a, y - dy * (reach + 1) + dx * a, z + b, dx, dy, 0.0001});
    }
  return least;
}

/// What is seen of the tile lies no farther from the true city than the tile says, from any side.
TEST(BlockMap, KeepsItsStoredError) {
  double worst_share = 0;
  for (const std::uint64_t seed : seeds(1, 3)) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const auto tiles = town_tiles();
    const PlanPoint corner = tiles[seed % tiles.size()];
    const PlanBox box{{corner.x - 8000, corner.y - 8000}, {corner.x + 136'000, corner.y + 136'000}};
    const TrueCity truth(town_scene(), box);
    for (const std::uint32_t side : {32u, 128u}) {
      SCOPED_TRACE(side);
      BlockMapOptions options;
      options.side = side;
      const BlockMap map = bake_unpacked(town_scene(), corner, kTile_mm, options).map;
      const BlockMapCaster caster(map);
      const double error = map.error_mm / 1000.0;
      EXPECT_LT(error, 12);
      int hits = 0;
      for (int i = 0; i < 20'000; ++i) {
        const PlanRay ray = random_ray(random, corner);
        const CastHit hit = caster.cast(ray);
        // The rim is closed as if nothing stood beyond it: no true wall is there.
        const double x = ray.x + hit.t * ray.dx, y = ray.y + hit.t * ray.dy, z = ray.z + hit.t * ray.dz;
        const double rim = std::min(std::min(x - metres(corner.x), metres(corner.x) + 128 - x),
                                    std::min(y - metres(corner.y), metres(corner.y) + 128 - y));
        if (!hit || rim < 0.01 || hit.t < 1e-3) continue;  // begins in a house
        ++hits;
        const double distance = truth.distance(x, y, z, error + 5);
        EXPECT_LE(distance, error + 0.012) << x << ' ' << y << ' ' << z;
        worst_share = std::max(worst_share, distance / error);
      }
      EXPECT_GT(hits, 5000);
      // And what is seen of the city lies no farther from the tile. Within the tile's middle: others have its rim.
      for (int i = 0; i < 1500; ++i) {
        const PlanRay ray = random_ray(random, corner);
        const Seen seen = truth.see(ray);
        const double x = ray.x + seen.t * ray.dx, y = ray.y + seen.t * ray.dy, z = ray.z + seen.t * ray.dz;
        const double rim = std::min(std::min(x - metres(corner.x), metres(corner.x) + 128 - x),
                                    std::min(y - metres(corner.y), metres(corner.y) + 128 - y));
        if (std::isinf(seen.t) || rim < error || caster.cast(ray).t < 1e-3) continue;
        EXPECT_LE(distance_by_rays(caster, ray, x, y, z, error), error + 0.012) << x << ' ' << y << ' ' << z;
      }
    }
  }
  EXPECT_GT(worst_share, 0.3);  // the bound is not idle
}

TEST(BlockMap, ComesBackAsItWasEncoded) {
  BlockMap map = bake_blockmap(town_scene(), town_tiles().front(), kTile_mm);
  map.key = 0x0123456789abcdefu;
  const std::string bytes = encode_blockmap(map);
  const auto back = decode_blockmap(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, map);
  EXPECT_TRUE(tile_pictures(*back));
  EXPECT_GT(map.colour_error_milli, 0u);
}

/// A part of the city that is read from its file comes in another order.
TEST(BlockMap, TilesAreEqualInWhateverOrderHousesAndGroundCome) {
  City turned = town();
  std::reverse(turned.buildings.begin(), turned.buildings.end());
  std::reverse(turned.surfaces.begin(), turned.surfaces.end());
  const BakeScene scene(turned, pictures_of(turned), 1);
  const int levels = levels_of(turned);
  for (const TileNode& node : plan_tiles(town_scene(), levels, 1))
    for (const TileKind kind : kTileKinds)
      if (has_kind(node, kind)) {
        EXPECT_EQ(tile_bytes(scene, levels, node.at, kind, 1), tile_bytes(town_scene(), levels, node.at, kind, 1))
            << tile_path(node.at, kind);
      }
}

TEST(BlockMap, PicturesOfFewColoursComeBackAndNoOthersPass) {
  const IndexedPicture picture{{{1, 2, 3}, {200, 100, 50}}, std::string("\0\1\1\0\1\0", 6)};
  const std::string bytes = encode_indexed(picture);
  EXPECT_EQ(decode_indexed(bytes, 6), picture);
  EXPECT_FALSE(decode_indexed(bytes, 7));
  EXPECT_FALSE(decode_indexed(bytes.substr(1), 6));
  EXPECT_FALSE(decode_indexed("", 0));
  std::string unknown = bytes;
  unknown.back() = 2;
  EXPECT_FALSE(decode_indexed(unknown, 6)) << "a colour that the palette does not have";
}

/// Against the nearest of many random palettes it is never worse, and a picture that has few colours keeps them.
TEST(BlockMap, FewColoursAreNear) {
  std::mt19937_64 random(5);
  for (const int colours : {2, 7, 24, 256}) {
    RgbImage image(64, 48);
    for (std::uint8_t& v : image.rgb) v = static_cast<std::uint8_t>(random());
    const auto squares = [&](const IndexedPicture& few) {
      const RgbImage back = rgb_of(few, 64, 48);
      double sum = 0;
      for (std::size_t i = 0; i < image.rgb.size(); ++i) sum += std::pow(image.rgb[i] - back.rgb[i], 2);
      return sum;
    };
    const IndexedPicture few = with_few_colours(image, colours);
    EXPECT_EQ(few.palette.size(), static_cast<std::size_t>(colours));
    EXPECT_EQ(few, with_few_colours(image, colours));
    for (int attempt = 0; attempt < 5; ++attempt) {
      IndexedPicture other;
      for (int c = 0; c < colours; ++c) {
        const std::size_t at = 3 * (random() % (image.rgb.size() / 3));
        other.palette.push_back({image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]});
      }
      for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const auto off = [&](Colour c) {
          return std::pow(c.r - image.rgb[i], 2) + std::pow(c.g - image.rgb[i + 1], 2) +
                 std::pow(c.b - image.rgb[i + 2], 2);
        };
        const auto nearest = std::min_element(other.palette.begin(), other.palette.end(),
                                              [&](Colour a, Colour b) { return off(a) < off(b); });
        other.pixels.push_back(static_cast<char>(nearest - other.palette.begin()));
      }
      EXPECT_LE(squares(few), squares(other)) << colours;
    }
    EXPECT_EQ(rgb_of(with_few_colours(rgb_of(few, 64, 48), colours), 64, 48).rgb, rgb_of(few, 64, 48).rgb);
  }
}

TEST(BlockMap, RefusesBytesThatAreNone) {
  const std::string good = encode_blockmap(bake_blockmap(town_scene(), town_tiles().front(), kTile_mm));
  for (const std::size_t size : {std::size_t{0}, std::size_t{4}, std::size_t{BLOCKMAP_HEADER_BYTES}, good.size() - 1})
    EXPECT_FALSE(decode_blockmap(good.substr(0, size))) << size;
  EXPECT_FALSE(decode_blockmap(good + "x"));
  const auto with = [&](std::size_t at, char value) {
    std::string bad = good;
    bad[at] = value;
    return bad;
  };
  EXPECT_FALSE(decode_blockmap(with(BLOCKMAP_MAGIC_AT, 'X')));
  EXPECT_FALSE(decode_blockmap(with(BLOCKMAP_VERSION_AT, 9)));
  EXPECT_FALSE(decode_blockmap(with(BLOCKMAP_SIDE_AT, 127)));
  EXPECT_FALSE(decode_blockmap(with(BLOCKMAP_ROWS_AT, 0)));
  EXPECT_FALSE(decode_blockmap(with(BLOCKMAP_COLUMNS_AT, static_cast<char>(good[BLOCKMAP_COLUMNS_AT] + 1))));
  EXPECT_FALSE(decode_blockmap(with(BLOCKMAP_FLAGS_AT, 2)));
}

TEST(BlockMap, IsTheSameBytesOnEveryRun) {
  const BakeScene again(town(), pictures_of(town()), 1);
  for (const PlanPoint corner : town_tiles())
    EXPECT_EQ(encode_blockmap(bake_blockmap(town_scene(), corner, kTile_mm)),
              encode_blockmap(bake_blockmap(again, corner, kTile_mm)));
}

/// Two tiles side by side: a ray never passes between them into the ground, and roofs go on over the seam.
TEST(BlockMap, HasNoHolesAtSeams) {
  const auto corners = town_tiles();
  const PlanPoint left = corners.front(), right{left.x + static_cast<std::int32_t>(kTile_mm), left.y};
  const BlockMap a = bake_unpacked(town_scene(), left, kTile_mm).map,
                 b = bake_unpacked(town_scene(), right, kTile_mm).map;
  const BlockMapCaster caster_a(a), caster_b(b);
  const double seam = metres(right.x);
  int looks = 0;
  for (int i = 1; i < 128 * 4; ++i) {
    const double y = metres(left.y) + i / 4.0;
    for (const double dx : {-0.7, -0.001, 0.001, 0.7}) {
      const PlanRay ray{seam - dx * 100, y, 100.0, dx, 0.0001, -1};
      const double t = std::min(caster_a.cast(ray).t, caster_b.cast(ray).t);
      EXPECT_LT(t, 100.3) << y << ' ' << dx;
      ++looks;
    }
  }
  EXPECT_GT(looks, 2000);
}

TEST(PrismTile, HasEveryHouseWholeAndOwnedOnce) {
  std::map<std::size_t, int> count;
  const PlanBox box = town_scene().box();
  const int levels = tile_levels(box);
  std::size_t owned = 0, all = 0;
  for (std::uint32_t y = 0; y < 1u << (levels - 1); ++y)
    for (std::uint32_t x = 0; x < 1u << (levels - 1); ++x) {
      const PrismTile tile = bake_prisms(town_scene(), tile_corner(levels, {levels - 1, x, y}), kTile_mm);
      for (const PrismHouse& house : tile.houses) {
        owned += house.is_owned;
        ++all;
      }
      const std::string bytes = encode_prisms(tile);
      const auto back = decode_prisms(bytes);
      ASSERT_TRUE(back);
      EXPECT_EQ(*back, tile);
      EXPECT_FALSE(decode_prisms(std::string_view(bytes).substr(0, bytes.size() - 1)));
    }
  EXPECT_EQ(owned, town_scene().houses().size());
  EXPECT_GT(all, owned);  // some stand on a seam
}

/// Facets of a house's own roof lie no farther from the true one than the tile says, and close it with its walls.
TEST(PrismTile, HasOwnRoofsThatAreClosedAndKeepItsStoredError) {
  std::size_t roofs = 0, points = 0;
  double worst_share = 0;
  for (const PlanPoint corner : town_tiles()) {
    const PrismTile tile = bake_prisms(town_scene(), corner, kTile_mm);
    const PlanBox box{{corner.x - 60'000, corner.y - 60'000}, {corner.x + 188'000, corner.y + 188'000}};
    const TrueCity truth(town_scene(), box);
    const double error = tile.error_mm / 1000.0;
    for (const PrismHouse& house : tile.houses) {
      if (house.kind != PrismKind::faceted || !house.is_owned) continue;
      ++roofs;
      std::vector<std::array<double, 3>> corners;
      const double eave = tile.base_mm + double(tile.up_step_mm) * (house.ground + std::int64_t{house.eave});
      const auto add = [&](PlanPoint at, std::int32_t up) {
        corners.push_back({(corner.x + double(tile.step_mm) * at.x) / 1000,
                           (corner.y + double(tile.step_mm) * at.y) / 1000, (eave + tile.up_step_mm * up) / 1000});
      };
      std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
      for (const auto& ring : house.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto first = static_cast<std::uint32_t>(corners.size() - i);
          add(ring[i], 0);
          --edges[{first + static_cast<std::uint32_t>(i), first + static_cast<std::uint32_t>((i + 1) % ring.size())}];
        }
      for (const PrismPoint& p : house.points) add(p.at, p.up);
      for (const PrismFacet& facet : house.facets)
        for (std::size_t k = 0; k < facet.corners.size(); ++k) {
          const std::uint32_t a = facet.corners[k], b = facet.corners[(k + 1) % facet.corners.size()];
          if (edges[{b, a}] > 0)
            --edges[{b, a}];
          else
            ++edges[{a, b}];
          // The middle of each triangle of the fan, and of its first side.
          if (k < 2) continue;
          const auto &p = corners[facet.corners[0]], &q = corners[facet.corners[k - 1]], &r = corners[a];
          for (const double share : {1.0 / 3, 0.0}) {
            std::array<double, 3> at{};
            for (std::size_t i = 0; i < 3; ++i) at[i] = share * r[i] + (1 - share) / 2 * (p[i] + q[i]);
            const double distance = truth.distance(at[0], at[1], at[2], error + 5);
            EXPECT_LE(distance, error + 0.002) << at[0] << ' ' << at[1] << ' ' << at[2];
            worst_share = std::max(worst_share, distance / error);
            ++points;
          }
        }
      for (const auto& [edge, left] : edges) EXPECT_EQ(left, 0);
    }
  }
  EXPECT_GT(roofs, 20u);
  EXPECT_GT(points, 500u);
  EXPECT_GT(worst_share, 0.1);
}

/// A parent's quadrant has the houses that the child owns: a client draws either, and nothing twice.
TEST(PrismTile, HasTheHousesOfItsChildrenInItsQuadrants) {
  const int levels = tile_levels(town_scene().box());
  ASSERT_GE(levels, 2);
  for (int z = 0; z + 1 < levels; ++z)
    for (std::uint32_t y = 0; y < 1u << z; ++y)
      for (std::uint32_t x = 0; x < 1u << z; ++x) {
        const TileAddress at{z, x, y};
        std::size_t mine[4] = {}, theirs[4] = {};
        for (const PrismHouse& h : bake_prisms(town_scene(), tile_corner(levels, at), tile_side_mm(levels, z)).houses)
          if (h.is_owned) ++mine[h.quadrant];
        for (int q = 0; q < 4; ++q)
          for (const PrismHouse& h :
               bake_prisms(town_scene(), tile_corner(levels, child_of(at, q)), tile_side_mm(levels, z + 1)).houses)
            theirs[q] += h.is_owned;
        for (int q = 0; q < 4; ++q) EXPECT_EQ(mine[q], theirs[q]) << tile_path(at) << " quadrant " << q;
      }
}

TEST(GroundTile, HasTheTerrainAtItsNodesAndThePictureOfTheTown) {
  City hilly = town();
  hilly.terrain = {{-2'000'000, -2'000'000}, 100'000, 41, 41, {}};
  for (int row = 0; row < 41; ++row)
    for (int column = 0; column < 41; ++column) hilly.terrain.height_mm.push_back(500 * column + 20 * row * row);
  const BakeScene scene(hilly, pictures_of(hilly), 2);
  const PlanPoint corner = town_tiles().front();
  const GroundTile tile = bake_ground(scene, corner, kTile_mm);
  ASSERT_EQ(tile.nodes, 33u);
  for (std::uint32_t row = 0; row < 33; ++row)
    for (std::uint32_t column = 0; column < 33; ++column) {
      const auto mm = [&](std::int32_t from, std::uint32_t i) { return from + static_cast<std::int32_t>(4'000 * i); };
      const double truth = height_m(scene.terrain(), {mm(corner.x, column), mm(corner.y, row)});
      EXPECT_NEAR((tile.base_mm + double(tile.height[row * 33 + column]) * tile.step_mm) / 1000, truth, 0.005 + 1e-9);
    }
  EXPECT_EQ(bake_ground(town_scene(), corner, kTile_mm).nodes, 3u);
  const auto picture = decode_webp(tile.picture, 256, 256);
  ASSERT_TRUE(picture);
  std::set<std::uint32_t> colours;
  for (std::size_t i = 0; i < picture->rgb.size(); i += 3)
    colours.insert(picture->rgb[i] / 16u * 256 + picture->rgb[i + 2] / 16u);
  EXPECT_GT(colours.size(), 8u);
  EXPECT_EQ(decode_ground(encode_ground(tile)), tile);
}

/// Where the city ends, too: a seam in the open land is seen from far.
TEST(GroundTile, MeetsTheOneBesideItInColour) {
  const int levels = tile_levels(town_scene().box());
  double worst = 0, sum = 0;
  int rows = 0;
  for (int z = std::max(0, levels - 2); z < levels; ++z) {
    const std::uint32_t side = tile_side_mm(levels, z), count = 1u << z;
    for (std::uint32_t y = 0; y < count; ++y)
      for (std::uint32_t x = 0; x + 1 < count; ++x) {
        const auto picture = [&](std::uint32_t column) {
          const GroundTile tile = bake_ground(town_scene(), tile_corner(levels, {z, column, y}), side);
          return decode_webp(tile.picture, 256, 256).value();
        };
        const RgbImage left = picture(x), right = picture(x + 1);
        // Between the last column of one and the first of the other as between columns of one tile, in the mean of 16.
        const auto mean = [](const RgbImage& image, std::size_t column, std::size_t row) {
          double total = 0;
          for (std::size_t k = 0; k < 16; ++k) total += image.at(column, row + k).r / 16.0;
          return total;
        };
        for (std::size_t row = 0; row + 16 <= 256; row += 16) {
          const double a = mean(left, 254, row), b = mean(left, 255, row), c = mean(right, 0, row),
                       d = mean(right, 1, row);
          const double inside = std::abs(a - b) + std::abs(c - d), seam = std::abs(b - c);
          worst = std::max(worst, seam - inside);
          sum += seam - inside;
          ++rows;
        }
      }
  }
  EXPECT_GT(rows, 100);
  EXPECT_LT(worst, 24) << "a kerb may run along a seam";
  EXPECT_LT(sum / rows, 1);
}

TEST(PrismTile, IsTheSameHouseInBothTilesThatHaveIt) {
  const auto corners = town_tiles();
  const PlanPoint left = corners.front(), right{left.x + static_cast<std::int32_t>(kTile_mm), left.y};
  const PrismTile a = bake_prisms(town_scene(), left, kTile_mm), b = bake_prisms(town_scene(), right, kTile_mm);
  ASSERT_EQ(a.step_mm, b.step_mm);
  const auto shift = static_cast<std::int32_t>(kTile_mm / a.step_mm);
  std::set<std::vector<std::vector<PlanPoint>>> rings;
  for (const PrismHouse& h : a.houses) rings.insert(h.rings);
  for (const PrismHouse& h : b.houses) {
    if (h.is_owned) continue;
    auto moved = h.rings;
    std::int32_t least = 1 << 30;
    for (auto& ring : moved)
      for (auto& p : ring) {
        p.x += shift;
        least = std::min(least, p.x);
      }
    if (least < shift) {
      EXPECT_TRUE(rings.contains(moved));
    }
  }
}

TEST(TileTree, PlansEveryHouseDownToASmallTileAndParsesItsPaths) {
  const int levels = tile_levels(town_scene().box());
  const auto nodes = plan_tiles(town_scene(), levels, 2);
  ASSERT_FALSE(nodes.empty());
  EXPECT_EQ(nodes[0].at, TileAddress{});
  EXPECT_EQ(nodes[0].houses, town_scene().houses().size());
  for (const TileNode& node : nodes) {
    EXPECT_EQ(parse_tile(tile_path(node.at).substr(10), levels), node.at);
    for (const TileKind kind : kTileKinds) {
      const std::string path = tile_path(node.at, kind);
      const auto name = parse_tile_path(path);
      ASSERT_TRUE(name) << path;
      EXPECT_EQ(name->kind, kind) << path;
      EXPECT_EQ(parse_tile(name->address, levels), node.at) << path;
    }
    EXPECT_TRUE(node.has_prisms || node.houses > kMostPrisms || node.houses == 0);
  }
  for (const char* bad : {"", "0", "0/0", "0/0/1", "1/2/0", "01/0/0", "0/0/0/0", "9/0/0", "-1/0/0", "0/0/0.prisms"})
    EXPECT_FALSE(parse_tile(bad, levels)) << bad;
}

TEST(TileTree, ChangesOnlyTheKeysOnTheWayToAChangedHouse) {
  City changed = town();
  Building& house = changed.buildings[changed.buildings.size() / 2];
  house.roof_colour.r ^= 0x40;
  const BakeScene scene(changed, pictures_of(changed), 2);
  const int levels = tile_levels(town_scene().box());
  const auto before = plan_tiles(town_scene(), levels, 1), after = plan_tiles(scene, levels, 2);
  ASSERT_EQ(before.size(), after.size());
  const PlanBox box = scene.houses()[changed.buildings.size() / 2].box;
  int changes = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool holds_it = meet(tile_box(levels, before[i].at), box);
    EXPECT_EQ(before[i].key != after[i].key, holds_it) << tile_path(before[i].at);
    changes += holds_it;
  }
  EXPECT_GE(changes, levels - 2);
  EXPECT_LT(static_cast<std::size_t>(changes), before.size());
}

TEST(PaperBlockMap, HasThePublishedSizesAndComesBack) {
  struct {
    PaperYear year;
    std::uint32_t n, w;
    std::size_t bytes;
  } const kCases[] = {{PaperYear::y2007, 16, 64, 4'608},
                      {PaperYear::y2007, 32, 192, 24'576},
                      {PaperYear::y2007, 64, 256, 73'728},
                      {PaperYear::y2009, 128, 512, 393'216}};
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.n);
    const PaperBlockMap map = bake_paper(town_scene(), town_tiles().front(), kTile_mm, c.year, c.n, c.w);
    EXPECT_EQ(map.texels.size(), c.bytes);
    const std::string bytes = encode_paper(map);
    const auto back = decode_paper(bytes);
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, map);
    EXPECT_FALSE(decode_paper(bytes.substr(1)));
    EXPECT_FALSE(decode_paper(bytes + "x"));
    // Each boundary texel has a wall, and no other has.
    int walls = 0;
    for (std::size_t row = 1; row + 1 < c.n; ++row)
      for (std::size_t column = 1; column + 1 < c.n; ++column) {
        const int own = map.cell(column, row)[0];
        const bool is_boundary = own > 0 && (map.cell(column + 1, row)[0] < own || map.cell(column - 1, row)[0] < own ||
                                             map.cell(column, row + 1)[0] < own || map.cell(column, row - 1)[0] < own);
        EXPECT_EQ(map.wall_column(column, row) != 0, is_boundary) << column << ' ' << row;
        EXPECT_LE(map.wall_column(column, row), c.w);
        walls += is_boundary;
      }
    EXPECT_GT(walls, 0);
  }
}

TEST(PaperBlockMap, KeepsEveryColumnNumber) {
  for (const PaperYear year : {PaperYear::y2007, PaperYear::y2009}) {
    PaperBlockMap map;
    map.year = year;
    map.side = 16;
    map.columns = year == PaperYear::y2007 ? 192 : 512;
    map.texels.assign(std::size_t{map.width()} * map.side * map.channels(), 0);
    map.cell(3, 4)[0] = 9;
    for (std::uint32_t wall = 0; wall <= map.columns; ++wall) {
      map.set_wall_column(3, 4, wall);
      EXPECT_EQ(map.wall_column(3, 4), wall);
    }
  }
}

/// Whole tiles with bytes changed, cut off, put in: what random bytes alone never come near.
TEST(TileDecoders, TakeDamagedTilesWithoutHarm) {
  BlockMapOptions options;
  options.side = 16;
  const PlanPoint corner = town_tiles().front();
  const std::string good[] = {encode_blockmap(bake_blockmap(town_scene(), corner, kTile_mm, options)),
                              encode_prisms(bake_prisms(town_scene(), corner, kTile_mm)),
                              encode_ground(bake_ground(town_scene(), corner, kTile_mm)),
                              encode_paper(bake_paper(town_scene(), corner, kTile_mm, PaperYear::y2007, 16, 64))};
  std::mt19937_64 random(5);
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = good[random() % 4];
    for (std::uint64_t k = random() % 4; k > 0; --k)
      bytes[random() % std::min<std::size_t>(bytes.size(), random() % 2 ? 100 : bytes.size())] = char(random());
    if (random() % 4 == 0) bytes.resize(random() % bytes.size());
    const std::vector<std::uint8_t> exact(bytes.begin(), bytes.end());
    LLVMFuzzerTestOneInput(exact.data(), exact.size());
    if (const auto map = decode_blockmap(bytes)) tile_pictures(*map);
  }
}

}  // namespace
}  // namespace vicus::test
