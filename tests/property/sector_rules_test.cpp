#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "city_db/rules.hpp"
#include "sectorgen/build_city.hpp"
#include "sectorgen/town/town.hpp"
#include "tests/support/scratch.hpp"

/// DESIGN §3 on random towns: every rule holds on every one, by the checker that shares no code with the generator.
namespace vicus {
namespace {

City city_of(const std::string& osm, const std::filesystem::path& file, const City* previous = nullptr) {
  test::write_bytes(file, osm);
  LoadOptions load;
  load.inputs = {file};
  std::vector<Issue> issues;
  SourceMap map = load_source_map(load, issues);
  BuildOptions options;
  options.previous = previous;
  BuildReport report;
  return build_city(std::move(map), options, std::move(issues), report);
}

void expect_rules_hold(const City& city) {
  const RuleReport report = check_rules(city);
  EXPECT_TRUE(report.all_hold());
  for (std::size_t i = 0; i < std::min<std::size_t>(3, report.violations.size()); ++i)
    ADD_FAILURE() << name_of(report.violations[i].rule) << " " << report.violations[i].id << ": "
                  << report.violations[i].message << " at " << report.violations[i].at.x << ", "
                  << report.violations[i].at.y << " mm";
}

/// VICUS_SEEDS=first,count runs others.
std::pair<std::uint64_t, std::uint64_t> seeds() {
  std::uint64_t first = 1, count = 500;
  if (const char* text = std::getenv("VICUS_SEEDS")) {
    char* end = nullptr;
    first = std::strtoull(text, &end, 10);
    if (*end == ',') count = std::strtoull(end + 1, nullptr, 10);
  }
  return {first, count};
}

TEST(SectorRules, HoldOnRandomTowns) {
  const test::ScratchDirectory scratch;
  const auto [first, count] = seeds();
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const City city = city_of(make_random_town(seed), scratch.path() / "town.osm");
    EXPECT_FALSE(city.sectors.empty());
    expect_rules_hold(city);
  }
}

TEST(SectorRules, HoldOnEveryKindOfHardTown) {
  const test::ScratchDirectory scratch;
  for (const TownPreset& preset : town_presets()) {
    SCOPED_TRACE(preset.name);
    TownOptions options;
    options.houses = 150;
    options.seed = 3;
    ASSERT_TRUE(apply_town_preset(preset.name, options));
    const City city = city_of(make_town_osm(options), scratch.path() / "town.osm");
    EXPECT_FALSE(city.sectors.empty());
    expect_rules_hold(city);
  }
}

TEST(SectorRules, GiveEqualCitiesForEqualMaps) {
  const test::ScratchDirectory scratch;
  const std::string osm = make_random_town(11);
  const City a = city_of(osm, scratch.path() / "a.osm"), b = city_of(osm, scratch.path() / "b.osm");
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
  const test::ScratchDirectory scratch;
  TownOptions options;
  options.houses = 200;
  options.seed = 5;
  const std::string osm = make_town_osm(options);
  const City before = city_of(osm, scratch.path() / "before.osm");
  for (std::size_t which : {7u, 31u, 64u}) {
    SCOPED_TRACE(which);
    const City after = city_of(without_house(osm, which), scratch.path() / "after.osm", &before);
    std::size_t kept = 0;
    for (const auto& s : before.sectors)
      kept += std::any_of(after.sectors.begin(), after.sectors.end(), [&](const Sector& t) { return t.id == s.id; });
    EXPECT_GE(kept + 3, before.sectors.size());  // one street, and at most the two it meets
    expect_rules_hold(after);
  }
}

}  // namespace
}  // namespace vicus
