#include <gtest/gtest.h>

#include <algorithm>

#include "read_town.hpp"
#include "sectorgen/town/town.hpp"

using namespace town_test;

namespace {

struct Box {
  Place low{INT64_MAX, INT64_MAX}, high{INT64_MIN, INT64_MIN};
  void add(Place p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool meets(const Box& o) const {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y;
  }
};

Box box_of(const Outline& ring) {
  Box box;
  for (const Place p : ring) box.add(p);
  return box;
}

std::vector<std::pair<Place, Place>> edges_of(const Built& b) {
  std::vector<std::pair<Place, Place>> edges;
  for (const Outline* ring : {&b.outer, &b.inner})
    for (std::size_t i = 0; i < ring->size(); ++i) edges.emplace_back((*ring)[i], (*ring)[(i + 1) % ring->size()]);
  return edges;
}

/// Common inner points: a proper crossing of walls, or a point just inside a corner of one, or the middle of its wall,
/// that is inside the other.
bool overlap(const Built& a, const Built& b) {
  for (const auto& [p, q] : edges_of(a))
    for (const auto& [r, s] : edges_of(b))
      if (cross_properly(p, q, r, s)) return true;
  const auto times4 = [](Built x) {
    for (Outline* ring : {&x.outer, &x.inner})
      for (Place& p : *ring) p = {4 * p.x, 4 * p.y};
    return x;
  };
  const Built big_a = times4(a), big_b = times4(b);
  for (const auto& [from, other] : {std::pair{&big_a, &big_b}, std::pair{&big_b, &big_a}})
    for (std::size_t i = 0, n = from->outer.size(); i < n; ++i) {
      const Place p = from->outer[i], v = from->outer[(i + 1) % n], q = from->outer[(i + 2) % n];
      if (is_inside(*other, {(p.x + v.x) / 2, (p.y + v.y) / 2})) return true;
      const Place inner{(p.x + 2 * v.x + q.x) / 4, (p.y + 2 * v.y + q.y) / 4};
      if (is_inside(*from, inner) && is_inside(*other, inner)) return true;
    }
  return false;
}

void expect_sound_buildings(const ReadTown& town, bool may_overlap) {
  std::vector<Built> all = buildings_of(town);
  std::vector<std::pair<Box, const Built*>> order;
  for (const Built& b : all) {
    EXPECT_TRUE(is_simple(b.outer)) << b.what;
    EXPECT_TRUE(b.inner.empty() || is_simple(b.inner)) << b.what;
    for (const Place p : b.inner) EXPECT_EQ(where(b.outer, p), 1) << b.what;
    order.emplace_back(box_of(b.outer), &b);
  }
  if (may_overlap) return;
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first.low.x < b.first.low.x; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && order[j].first.low.x <= order[i].first.high.x; ++j)
      if (order[i].first.meets(order[j].first)) {
        EXPECT_FALSE(overlap(*order[i].second, *order[j].second))
            << order[i].second->what << ' ' << order[j].second->what;
      }
}

/// Number of places where an open-air street crosses a wall.
std::size_t streets_through_houses(const ReadTown& town) {
  std::vector<std::pair<Box, std::vector<std::pair<Place, Place>>>> built;
  for (const Built& b : buildings_of(town)) built.emplace_back(box_of(b.outer), edges_of(b));
  std::size_t count = 0;
  for (const auto& [id, way] : town.ways) {
    if (!way.tags.count("highway") || way.tags.count("tunnel")) continue;
    for (std::size_t i = 1; i < way.refs.size(); ++i) {
      const Place a = town.nodes.at(way.refs[i - 1]).at, b = town.nodes.at(way.refs[i]).at;
      Box box;
      box.add(a);
      box.add(b);
      for (const auto& [other, edges] : built)
        if (box.meets(other))
          for (const auto& [p, q] : edges)
            if (cross_properly(a, b, p, q)) ++count, ADD_FAILURE() << "way " << id;
    }
  }
  return count;
}

vicus::TownOptions options_for(int houses, std::uint64_t seed) {
  vicus::TownOptions options;
  options.houses = houses;
  options.seed = seed;
  return options;
}

}  // namespace

TEST(TownGeometry, HousesAreSimpleAndApartInFiveHundredRandomTowns) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const bool may_overlap = vicus::random_town_options(seed).features.zero_width_alley;
    expect_sound_buildings(read_town(vicus::make_random_town(seed)), may_overlap);
  }
}

TEST(TownGeometry, HousesAreSimpleAndApartInLargerTowns) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    expect_sound_buildings(read_town(vicus::make_town_osm(options_for(seed % 4 ? 300 : 2000, seed))), false);
  }
}

TEST(TownGeometry, HousesAreSimpleAndApartUnderEveryPreset) {
  for (const auto& preset : vicus::town_presets())
    for (const int houses : {20, 90, 300}) {
      SCOPED_TRACE(preset.name + ' ' + std::to_string(houses));
      vicus::TownOptions options = options_for(houses, 17);
      vicus::apply_town_preset(preset.name, options);
      expect_sound_buildings(read_town(vicus::make_town_osm(options)), options.features.zero_width_alley);
    }
}

TEST(TownGeometry, StreetsInTheOpenPassNoWall) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    EXPECT_EQ(streets_through_houses(read_town(vicus::make_town_osm(options_for(seed % 2 ? 300 : 90, seed)))), 0u);
  }
}

TEST(TownGeometry, ZeroWidthAlleyTouchesAndOverlapsByOneStep) {
  vicus::TownOptions options = options_for(20, 1);
  vicus::apply_town_preset("zero_width_alley", options);
  const ReadTown town = read_town(vicus::make_town_osm(options));
  std::vector<Built> all = buildings_of(town);
  std::size_t overlapping = 0, twins = 0;
  std::map<std::pair<std::int64_t, std::int64_t>, int> at;
  for (const auto& [id, n] : town.nodes) twins += ++at[{n.at.x, n.at.y}] == 2;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j)
      if (box_of(all[i].outer).meets(box_of(all[j].outer))) overlapping += overlap(all[i], all[j]);
  EXPECT_EQ(overlapping, 1u);
  EXPECT_GE(twins, 3u);  // two pairs of corners, and one where houses meet corner to corner
}

TEST(TownGeometry, RowsCloseTheStreets) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const ReadTown town = read_town(vicus::make_town_osm(options_for(300, seed)));
    std::map<std::pair<std::int64_t, std::int64_t>, int> walls;
    std::size_t houses = 0, joined = 0;
    const auto each_wall = [&](auto visit) {
      for (const auto& [id, way] : town.ways)
        if (way.tags.count("building"))
          for (std::size_t i = 1; i < way.refs.size(); ++i) visit(id, std::minmax(way.refs[i - 1], way.refs[i]));
    };
    each_wall([&](std::int64_t, const auto& wall) { ++walls[wall]; });
    std::map<std::int64_t, int> shared;
    each_wall([&](std::int64_t id, const auto& wall) { shared[id] += walls[wall] > 1; });
    for (const auto& [id, count] : shared) ++houses, joined += count >= 2;
    EXPECT_GT(static_cast<double>(joined), 0.55 * static_cast<double>(houses));
  }
}
