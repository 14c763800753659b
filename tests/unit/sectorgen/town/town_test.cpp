#include "sectorgen/town/town.hpp"

#include <gtest/gtest.h>

#include <set>

#include "read_town.hpp"

using namespace town_test;
using vicus::TownOptions;

namespace {

std::uint64_t fnv1a(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return hash;
}

TownOptions options_for(int houses, std::uint64_t seed) {
  TownOptions options;
  options.houses = houses;
  options.seed = seed;
  return options;
}

std::string only_feature(const std::string& preset, int houses, std::uint64_t seed) {
  TownOptions options = options_for(houses, seed);
  EXPECT_TRUE(vicus::apply_town_preset(preset, options));
  return vicus::make_town_osm(options);
}

}  // namespace

TEST(Town, EqualSeedsGiveEqualBytes) {
  EXPECT_EQ(vicus::make_town_osm(options_for(300, 7)), vicus::make_town_osm(options_for(300, 7)));
  EXPECT_EQ(vicus::make_random_town(11), vicus::make_random_town(11));
}

TEST(Town, BytesOfOneSeedAreTheSameOnEveryMachine) {
  EXPECT_EQ(fnv1a(vicus::make_town_osm(options_for(300, 1))), 0x397879ff268c7dc1ull);
}

TEST(Town, SeedsDiffer) {
  std::set<std::uint64_t> hashes;
  for (std::uint64_t seed = 0; seed < 40; ++seed) hashes.insert(fnv1a(vicus::make_town_osm(options_for(60, seed))));
  EXPECT_EQ(hashes.size(), 40u);
}

TEST(Town, HasExactlyTheHousesAskedFor) {
  for (const int houses : {20, 21, 59, 60, 199, 200, 300, 777, 3000}) {
    SCOPED_TRACE(houses);
    const auto town = vicus::make_town(options_for(houses, 5));
    EXPECT_EQ(town.counts.houses, static_cast<std::size_t>(houses));
    const ReadTown read = read_town(town.osm);
    EXPECT_EQ(read.count("building"), town.counts.buildings);
    EXPECT_EQ(read.count("highway") - read.count("highway", "street_lamp"), town.counts.streets);
    EXPECT_EQ(read.nodes.size(), town.counts.nodes);
    EXPECT_EQ(read.ways.size(), town.counts.ways);
    EXPECT_EQ(read.relations.size(), town.counts.relations);
    std::size_t others = 0;
    for (const char* kind : {"church", "gatehouse", "tower", "shed", "garage", "outbuilding"})
      others += read.count("building", kind);
    EXPECT_EQ(read.count("building") - others, static_cast<std::size_t>(houses));
  }
}

TEST(Town, RefersOnlyToWhatExists) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    const ReadTown town =
        read_town(seed % 3 ? vicus::make_random_town(seed) : vicus::make_town_osm(options_for(400, seed)));
    for (const auto& [id, way] : town.ways) {
      ASSERT_GE(way.refs.size(), 2u) << "way " << id;
      ASSERT_LE(way.refs.size(), 2000u) << "way " << id;
      for (std::size_t i = 0; i < way.refs.size(); ++i) {
        ASSERT_TRUE(town.nodes.count(way.refs[i])) << "way " << id;
        if (i > 0) {
          EXPECT_NE(way.refs[i], way.refs[i - 1]) << "way " << id;
        }
      }
    }
    for (const auto& [id, relation] : town.relations)
      for (const Member& m : relation.members) ASSERT_TRUE(town.ways.count(m.ref)) << "relation " << id;
    EXPECT_EQ(town.nodes.begin()->first, 1);
    EXPECT_EQ(town.nodes.rbegin()->first, static_cast<std::int64_t>(town.nodes.size()));
  }
}

TEST(Town, HasEveryPromisedPartFrom300HousesOn) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const ReadTown town = read_town(vicus::make_town_osm(options_for(300, seed)));
    const std::pair<const char*, const char*> kPromised[] = {{"building", "church"},
                                                             {"building:part", "yes"},
                                                             {"roof:shape", "pyramidal"},
                                                             {"place", "square"},
                                                             {"building", "palace"},
                                                             {"type", "multipolygon"},
                                                             {"tunnel", "building_passage"},
                                                             {"highway", "steps"},
                                                             {"highway", "footway"},
                                                             {"leisure", "park"},
                                                             {"water", "pond"},
                                                             {"water", "river"},
                                                             {"waterway", "river"},
                                                             {"bridge", "yes"},
                                                             {"man_made", "bridge"},
                                                             {"barrier", "city_wall"},
                                                             {"historic", "city_gate"},
                                                             {"barrier", "wall"},
                                                             {"barrier", "fence"},
                                                             {"barrier", "gate"},
                                                             {"natural", "tree"},
                                                             {"highway", "street_lamp"},
                                                             {"amenity", "fountain"},
                                                             {"amenity", "bench"},
                                                             {"shop", ""},
                                                             {"addr:housenumber", ""},
                                                             {"addr:street", ""},
                                                             {"building:levels", ""},
                                                             {"height", ""},
                                                             {"roof:colour", ""},
                                                             {"building:colour", ""},
                                                             {"dual_carriageway", "yes"},
                                                             {"noexit", "yes"},
                                                             {"indoor", "room"},
                                                             {"indoor", "corridor"},
                                                             {"indoor", "door"},
                                                             {"entrance", ""},
                                                             {"building", "detached"},
                                                             {"highway", "primary"}};
    for (const auto& [key, value] : kPromised) EXPECT_GT(town.count(key, value), 0u) << key << '=' << value;
    EXPECT_EQ(town.count("place", "square"), 2u);
    EXPECT_GE(town.count("name", "\"Zum <Löwen> & Co\""), 1u);
    EXPECT_EQ(town.count("name", "Zum <Löwen> & Co"), 1u);
  }
}

TEST(Town, SomeHousesTellNothing) {
  const ReadTown town = read_town(vicus::make_town_osm(options_for(300, 3)));
  std::size_t bare = 0;
  for (const auto& [id, way] : town.ways) bare += way.tags == TagMap{{"building", "yes"}};
  EXPECT_GT(bare, 15u);
  EXPECT_LT(bare, 80u);
}

TEST(Town, SecondSquareIsConcaveAndHoldsAnIsland) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const ReadTown town = read_town(vicus::make_town_osm(options_for(300, seed)));
    for (const auto& [id, way] : town.ways) {
      if (town.tag(way.tags, "name") != "Kohlmarkt") continue;
      const Outline ring = outline_of(town, way);
      std::size_t turns[2] = {0, 0}, inside = 0;
      for (std::size_t i = 0; i < ring.size(); ++i)
        ++turns[side(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) > 0];
      EXPECT_GT(turns[0], 0u);
      for (const Built& b : buildings_of(town)) {
        bool is_within = true;
        for (const Place p : b.outer) is_within = is_within && where(ring, p) == 1;
        inside += is_within;
      }
      EXPECT_GE(inside, 4u);
    }
  }
}

TEST(Town, PassagesLeadThroughSharedNodesOfTheHouse) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const ReadTown town = read_town(vicus::make_town_osm(options_for(300, seed)));
    std::set<std::int64_t> walls, paths;
    for (const auto& [id, way] : town.ways) {
      const bool is_wall = way.tags.count("building") || way.tags.empty();  // outer and inner ways have no tags
      const bool is_path = way.tags.count("highway") && !way.tags.count("tunnel");
      if (is_wall) walls.insert(way.refs.begin(), way.refs.end());
      if (is_path) paths.insert(way.refs.begin(), way.refs.end());
    }
    for (const auto& [id, way] : town.ways) {
      if (!way.tags.count("tunnel")) continue;
      for (const std::int64_t end : {way.refs.front(), way.refs.back()}) {
        EXPECT_TRUE(walls.count(end)) << "way " << id;
        EXPECT_TRUE(paths.count(end)) << "way " << id;
      }
    }
  }
}

TEST(Town, PresetsDoWhatTheirNamesSay) {
  const auto box = [](const ReadTown& town) {
    Place low{INT64_MAX, INT64_MAX}, high{INT64_MIN, INT64_MIN};
    for (const auto& [id, n] : town.nodes) {
      low = {std::min(low.x, n.at.x), std::min(low.y, n.at.y)};
      high = {std::max(high.x, n.at.x), std::max(high.y, n.at.y)};
    }
    return std::pair{low, high};
  };
  EXPECT_EQ(read_town(only_feature("no_streets", 80, 1)).count("highway") -
                read_town(only_feature("no_streets", 80, 1)).count("highway", "street_lamp"),
            0u);
  const auto [low, high] = box(read_town(only_feature("antimeridian", 80, 1)));
  EXPECT_LT(low.x, 1'800'000'000);
  EXPECT_GT(high.x, 1'800'000'000);
  const std::string wrapped = only_feature("antimeridian", 80, 1);
  EXPECT_NE(wrapped.find("lon=\"-179.99"), std::string::npos);
  EXPECT_NE(wrapped.find("lon=\"179.99"), std::string::npos);
  EXPECT_NEAR(static_cast<double>(box(read_town(only_feature("arctic", 80, 1))).first.y), 85e7, 0.01e7);
  const auto [west, east] = box(read_town(only_feature("huge", 80, 1)));
  EXPECT_NEAR(static_cast<double>(east.x - west.x) * 1e-7 * 111.19 * 0.6416, 58.5, 1.5);  // km, at 50.087 degrees
  EXPECT_EQ(read_town(only_feature("detached", 300, 1)).count("building", "apartments"), 0u);
}

TEST(Town, EveryPresetIsListedAndAnUnknownOneRefused) {
  EXPECT_EQ(vicus::town_presets().size(), 13u);
  for (const auto& preset : vicus::town_presets()) {
    TownOptions options;
    EXPECT_TRUE(vicus::apply_town_preset(preset.name, options)) << preset.name;
    EXPECT_FALSE(preset.what.empty());
  }
  TownOptions options;
  EXPECT_FALSE(vicus::apply_town_preset("atlantis", options));
}
