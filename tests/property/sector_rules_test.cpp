#include <gtest/gtest.h>

#include <algorithm>

#include "city_db/rules.hpp"
#include "sectorgen/build_city.hpp"
#include "sectorgen/town/town.hpp"
#include "tests/support/built_city.hpp"

/// DESIGN §3 on random towns: every rule holds on every one, by the checker that shares no code with the generator.
namespace vicus {
namespace {

void expect_rules_hold(const City& city) {
  const RuleReport report = check_rules(city);
  EXPECT_TRUE(report.all_hold());
  for (std::size_t i = 0; i < std::min<std::size_t>(3, report.violations.size()); ++i)
    ADD_FAILURE() << name_of(report.violations[i].rule) << " " << report.violations[i].id << ": "
                  << report.violations[i].message << " at " << report.violations[i].at.x << ", "
                  << report.violations[i].at.y << " mm";
}

TEST(SectorRules, HoldOnRandomTowns) {
  for (const std::uint64_t seed : test::seeds(1, 500)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const City city = test::random_town_city(seed);
    EXPECT_FALSE(city.sectors.empty());
    expect_rules_hold(city);
  }
}

TEST(SectorRules, HoldOnEveryKindOfHardTown) {
  for (const TownPreset& preset : town_presets()) {
    SCOPED_TRACE(preset.name);
    TownOptions options;
    options.houses = 150;
    options.seed = 3;
    ASSERT_TRUE(apply_town_preset(preset.name, options));
    const City city = test::city_of_osm(make_town_osm(options));
    EXPECT_FALSE(city.sectors.empty());
    expect_rules_hold(city);
  }
}

TEST(SectorRules, GiveEqualCitiesForEqualMaps) {
  const std::string osm = make_random_town(11);
  const City a = test::city_of_osm(osm), b = test::city_of_osm(osm);
  ASSERT_EQ(a.sectors.size(), b.sectors.size());
  for (std::size_t i = 0; i < a.sectors.size(); ++i) {
    EXPECT_EQ(a.sectors[i].id, b.sectors[i].id);
    EXPECT_EQ(a.sectors[i].ground.outer, b.sectors[i].ground.outer);
  }
}

/// The same town without one of its plain houses (a way that no relation uses).
std::string without_house(const std::string& osm, std::size_t which) {
  std::size_t at = 0, found = 0;
  while ((at = osm.find("<way ", at)) != std::string::npos) {
    const std::size_t end = osm.find("</way>", at) + 6;
    if (osm.substr(at, end - at).find("k=\"building\"") != std::string::npos && found++ == which)
      return osm.substr(0, at) + osm.substr(end);
    at = end;
  }
  return osm;
}

TEST(SectorIdentity, AnEditRenamesNoFarSector) {
  TownOptions options;
  options.houses = 200;
  options.seed = 5;
  const std::string osm = make_town_osm(options);
  const City before = test::city_of_osm(osm);
  for (std::size_t which : {7u, 31u, 64u}) {
    SCOPED_TRACE(which);
    const City after = test::city_of_osm(without_house(osm, which), &before);
    std::size_t kept = 0;
    for (const auto& s : before.sectors)
      kept += std::any_of(after.sectors.begin(), after.sectors.end(), [&](const Sector& t) { return t.id == s.id; });
    EXPECT_GE(kept + 3, before.sectors.size());  // one street, and at most the two it meets
    expect_rules_hold(after);
  }
}

}  // namespace
}  // namespace vicus
