#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "city_db/rules.hpp"
#include "tests/support/random_partition.hpp"

/// The checker against a slow oracle: one point inside each triangle of a random field, located in every polygon.
namespace vicus {
namespace {

using test::RandomCity;

constexpr std::uint64_t kSeeds = 60;

/// Even-odd over all rings; p in thirds of a millimetre, so that a triangle's centroid is a lattice point.
/// Inside a polygon of the field, a centroid is never on an edge.
bool contains(const Polygon& polygon, std::int64_t px, std::int64_t py) {
  bool inside = false;
  const auto ring = [&](const Ring& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto a = points[i], b = points[(i + 1) % points.size()];
      const std::int64_t ax = 3 * std::int64_t{a.x}, ay = 3 * std::int64_t{a.y};
      const std::int64_t bx = 3 * std::int64_t{b.x}, by = 3 * std::int64_t{b.y};
      if ((ay > py) == (by > py)) continue;
      const auto side = (bx - ax) * (py - ay) - (by - ay) * (px - ax);
      if (by > ay ? side > 0 : side < 0) inside = !inside;
    }
  };
  ring(polygon.outer);
  for (const auto& hole : polygon.holes) ring(hole);
  return inside;
}

struct OracleSays {
  double error_mm2 = 0, walkable_mm2 = 0;
};

OracleSays ask_oracle(const RandomCity& rc) {
  std::int64_t twice_error = 0, twice_walkable = 0;
  for (const auto& t : rc.field.triangles) {
    const auto a = rc.field.points[t[0]], b = rc.field.points[t[1]], c = rc.field.points[t[2]];
    const std::int64_t x = std::int64_t{a.x} + b.x + c.x, y = std::int64_t{a.y} + b.y + c.y;
    int domain = 0, sectors = 0, blocks = 0;
    for (const auto& d : rc.city.domain) domain += contains(d, x, y);
    for (const auto& s : rc.city.sectors) sectors += contains(s.ground, x, y);
    for (const auto& h : rc.city.buildings) blocks += h.base_m <= 0 && contains(h.footprint, x, y);
    for (const auto& o : rc.city.obstacles) blocks += contains(o.area, x, y);
    const std::int64_t twice =
        (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
    const bool is_walkable = domain > 0 && blocks == 0;
    if (is_walkable) twice_walkable += twice;
    if (sectors != (is_walkable ? 1 : 0)) twice_error += twice;
  }
  return {static_cast<double>(twice_error) / 2, static_cast<double>(twice_walkable) / 2};
}

/// Returns whether the rule is broken, for tests that want to be sure they broke it often.
bool expect_as_oracle(const RandomCity& rc) {
  const auto report = check_rules(rc.city);
  const auto oracle = ask_oracle(rc);
  EXPECT_TRUE(report.is_noded);
  EXPECT_EQ(report.area_error_mm2, oracle.error_mm2);
  EXPECT_EQ(report.walkable_mm2, oracle.walkable_mm2);
  EXPECT_EQ(report.holds(Rule::partition), oracle.error_mm2 == 0);
  return oracle.error_mm2 > 0;
}

RandomCity small_city(std::uint64_t seed) {
  return test::random_city(seed, 6 + static_cast<std::uint32_t>(seed % 20), 3 + static_cast<std::uint32_t>(seed % 47));
}

/// The first sector's region from a random start, or nothing.
const RandomCity::Region* any_sector(const RandomCity& rc, std::uint64_t random, std::uint32_t& region) {
  for (std::size_t i = 0; i < rc.regions.size(); ++i) {
    region = static_cast<std::uint32_t>((random + i) % rc.regions.size());
    if (rc.regions[region].use == RandomCity::Use::sector) return &rc.regions[region];
  }
  return nullptr;
}

TEST(RulesOracle, RandomCitiesHoldEveryRule) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto rc = small_city(seed);
    const auto report = check_rules(rc.city);
    for (const auto& v : report.violations) ADD_FAILURE() << name_of(v.rule) << " " << v.id << " " << v.message;
    expect_as_oracle(rc);
  }
}

TEST(RulesOracle, AgreesWhenASectorTakesOrLosesTriangles) {
  int broken = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    auto rc = small_city(seed);
    std::mt19937_64 random(seed);
    std::uint32_t region = 0;
    const auto* sector = any_sector(rc, random(), region);
    if (!sector) continue;
    // A few triangles change sides: taken from whatever lies beside the sector, or given up.
    std::vector<bool> is_in(rc.field.triangles.size());
    for (const auto t : rc.triangles[region]) is_in[t] = true;
    for (int i = 0; i < 3; ++i) {
      auto t = rc.triangles[region][random() % rc.triangles[region].size()];
      if (const auto beside = rc.field.neighbours[t][random() % 3]; beside != test::Field::kNoTriangle) t = beside;
      is_in[t] = !is_in[t];
    }
    std::vector<std::uint32_t> all(is_in.size());
    for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
    std::erase_if(all, [&](auto t) { return !is_in[t]; });
    auto parts = test::polygons_of(rc.field, all, [&](auto t) { return is_in[t]; });
    if (parts.empty()) continue;
    rc.city.sectors[sector->index].ground = parts.back();
    broken += expect_as_oracle(rc);
  }
  EXPECT_GT(broken, 40);
}

TEST(RulesOracle, AgreesWhenHousesComeAndGo) {
  int broken = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    auto rc = small_city(seed);
    if (rc.city.buildings.empty()) continue;
    auto& house = rc.city.buildings[seed % rc.city.buildings.size()];
    house.base_m = 3;  // now one could walk below, unless another record covers the same ground
    broken += expect_as_oracle(rc);
    if (rc.city.obstacles.empty()) continue;
    rc.city.obstacles.push_back({ObstacleKind::water, "flood", 0, rc.city.domain[0]});
    broken += expect_as_oracle(rc);
  }
  EXPECT_GT(broken, 60);
}

TEST(RulesOracle, FindsEveryVertexMovedByOneMillimetre) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    auto rc = small_city(seed);
    std::mt19937_64 random(seed);
    std::uint32_t region = 0;
    const auto* sector = any_sector(rc, random(), region);
    if (!sector) continue;
    auto& ring = rc.city.sectors[sector->index].ground.outer;
    auto& p = ring[random() % ring.size()];
    (random() % 2 ? p.x : p.y) += random() % 2 ? 1 : -1;
    EXPECT_FALSE(check_rules(rc.city).holds(Rule::partition));
  }
}

TEST(RulesOracle, FindsASectorInTwoParts) {
  int tried = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    auto rc = small_city(seed);
    // Two sectors that share an edge nowhere become one record of two outer rings that meet in a vertex.
    for (std::size_t a = 0; a < rc.city.sectors.size(); ++a)
      for (std::size_t b = a + 1; b < rc.city.sectors.size(); ++b) {
        auto &first = rc.city.sectors[a], &second = rc.city.sectors[b];
        const bool are_joined = std::any_of(rc.city.gates.begin(), rc.city.gates.end(), [&](const Gate& g) {
          return g.sector_id == first.id && g.to_sector_id == second.id;
        });
        auto& ring = first.ground.outer;
        const auto& other = second.ground.outer;
        const auto at = std::find_first_of(ring.begin(), ring.end(), other.begin(), other.end());
        if (are_joined || at == ring.end()) continue;
        auto changed = rc.city;
        auto& joined = changed.sectors[a].ground;
        const auto start = std::find(other.begin(), other.end(), *at);
        Ring loop(start, other.end());
        loop.insert(loop.end(), other.begin(), start);
        joined.outer.insert(joined.outer.begin() + (at - ring.begin()), loop.begin(), loop.end());
        joined.holes.insert(joined.holes.end(), second.ground.holes.begin(), second.ground.holes.end());
        const auto rename = [&](std::string& id) {
          if (id == second.id) id = first.id;
        };
        for (auto& g : changed.gates) rename(g.sector_id), rename(g.to_sector_id);
        for (auto& border : changed.borders) rename(border.sector_id);
        changed.sectors.erase(changed.sectors.begin() + static_cast<std::ptrdiff_t>(b));
        const auto report = check_rules(changed);
        EXPECT_TRUE(report.holds(Rule::partition));
        EXPECT_TRUE(report.holds(Rule::edges));
        EXPECT_FALSE(report.holds(Rule::connected));
        a = b = rc.city.sectors.size();
        ++tried;
      }
  }
  EXPECT_GT(tried, 10);
}

TEST(RulesOracle, FindsEveryDroppedLine) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto rc = small_city(seed);
    std::mt19937_64 random(seed);
    if (!rc.city.gates.empty()) {
      auto city = rc.city;
      city.gates.erase(city.gates.begin() + static_cast<std::ptrdiff_t>(random() % city.gates.size()));
      EXPECT_FALSE(check_rules(city).holds(Rule::edges));
    }
    if (!rc.city.borders.empty()) {
      auto city = rc.city;
      const auto border = city.borders.begin() + static_cast<std::ptrdiff_t>(random() % city.borders.size());
      const bool is_facade = border->kind == BorderKind::facade;
      city.borders.erase(border);
      const auto report = check_rules(city);
      EXPECT_FALSE(report.holds(Rule::edges));
      EXPECT_EQ(report.holds(Rule::facades), !is_facade);
      EXPECT_TRUE(report.holds(Rule::partition));
    }
  }
}

}  // namespace
}  // namespace vicus
