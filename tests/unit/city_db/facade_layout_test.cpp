#include "city_db/facade_layout.hpp"

#include <gtest/gtest.h>

#include <random>

namespace vicus {
namespace {

Facade some_facade(std::mt19937& random) {
  const auto pick = [&](int least, int most) { return std::uniform_int_distribution(least, most)(random); };
  Facade f;
  f.style = static_cast<FacadeStyle>(pick(0, 5));
  f.floors = f.style == FacadeStyle::church || f.style == FacadeStyle::shed ? 1 : pick(1, 12);
  f.bays = pick(1, kMostBays);
  f.repeats = pick(1, 4);
  f.door_bay = pick(-1, f.bays - 1);
  f.has_shop = pick(0, 1) == 1;
  f.b = {pick(-500'000, 500'000), pick(-500'000, 500'000)};
  // Within what the layout chooses: bays of 0.7 to 1.5 times the style's own.
  const double length = f.bays * f.repeats * figures_of(f.style).bay * (0.7 + 0.08 * pick(0, 10));
  f.a = {f.b.x + lattice_mm(length * 0.6), f.b.y - lattice_mm(length * 0.8)};
  f.bottom_m = pick(0, 1) * 2.5;
  f.top_m = f.bottom_m + pattern_height_m(f) * (0.75 + 0.06 * pick(0, 10));
  return f;
}

TEST(OpeningsOf, LieInsideTheFacadeAndApartFromEachOther) {
  for (unsigned seed = 1; seed <= 500; ++seed) {
    std::mt19937 random(seed);
    const Facade f = some_facade(random);
    const auto openings = openings_of(f);
    for (std::size_t i = 0; i < openings.size(); ++i) {
      const Opening& o = openings[i];
      EXPECT_LT(o.x0, o.x1);
      EXPECT_LT(o.z0, o.z1);
      EXPECT_GE(o.x0, 0) << "seed " << seed;
      EXPECT_LE(o.x1, length_m(f)) << "seed " << seed;
      EXPECT_GE(o.z0, 0) << "seed " << seed;
      EXPECT_LE(o.z1, f.top_m - f.bottom_m) << "seed " << seed;
      for (std::size_t k = 0; k < i; ++k) {
        const Opening& p = openings[k];
        EXPECT_TRUE(o.x1 <= p.x0 || p.x1 <= o.x0 || o.z1 <= p.z0 || p.z1 <= o.z0)
            << "seed " << seed << ": openings " << k << " and " << i << " overlap";
      }
    }
  }
}

TEST(OpeningsOf, RepeatThePatternFromTheLeft) {
  std::mt19937 random(7);
  for (int n = 0; n < 100; ++n) {
    Facade f = some_facade(random);
    const auto openings = openings_of(f), pattern = pattern_openings(f);
    ASSERT_EQ(openings.size(), pattern.size() * static_cast<std::size_t>(f.repeats));
    const double width = length_m(f) / f.repeats;
    for (std::size_t i = 0; i < openings.size(); ++i) {
      const Opening& o = pattern[i % pattern.size()];
      EXPECT_EQ(openings[i].kind, o.kind);
      EXPECT_NEAR(openings[i].x0, static_cast<double>(i / pattern.size()) * width + o.x0 / pattern_width_m(f) * width,
                  1e-9);
    }
  }
}

TEST(OpeningsOf, ADoorStandsOnTheGroundInItsBay) {
  Facade f;
  f.b = {0, 0};
  f.a = {10'000, 0};
  f.top_m = 9;
  f.floors = 3;
  f.bays = 4;
  f.door_bay = 1;
  int doors = 0;
  for (const Opening& o : openings_of(f)) {
    if (o.kind != OpeningKind::house_door) continue;
    ++doors;
    EXPECT_EQ(o.z0, 0);
    EXPECT_NEAR((o.x0 + o.x1) / 2, 3.75, 1e-9);  // the second of four bays of 2.5 m
  }
  EXPECT_EQ(doors, 1);
}

/// The image of a facade has a ground floor window where another house has its door, hidden by it.
TEST(ImagePattern, HouseDoorsHideTheWindowInTheirPlace) {
  for (const FacadeStyle style : {FacadeStyle::plaster, FacadeStyle::stone, FacadeStyle::brick, FacadeStyle::modern}) {
    Facade f;
    f.style = style;
    f.door_bay = 0;
    const Opening door = pattern_openings(f).front(), window = pattern_openings(image_pattern(f)).front();
    EXPECT_EQ(door.kind, OpeningKind::house_door);
    EXPECT_LT(door.x0, window.x0);
    EXPECT_GT(door.x1, window.x1);
    EXPECT_LT(door.z0, window.z0);
    EXPECT_GT(door.z1, window.z1);
  }
}

TEST(AtlasTile, EachKindHasItsOwnPartOfTheImage) {
  for (std::size_t i = 0; i < kOpeningKinds; ++i) {
    const AtlasTile t = atlas_tile(static_cast<OpeningKind>(i));
    EXPECT_TRUE(0 < t.u0 && t.u0 < t.u1 && t.u1 < 1 && 0 < t.v0 && t.v0 < t.v1 && t.v1 < 1);
    for (std::size_t k = 0; k < i; ++k) {
      const AtlasTile p = atlas_tile(static_cast<OpeningKind>(k));
      EXPECT_TRUE(t.u1 < p.u0 || p.u1 < t.u0 || t.v1 < p.v0 || p.v1 < t.v0);
    }
  }
}

TEST(StraightRuns, PassOverPointsOnTheLine) {
  EXPECT_EQ(straight_runs({{0, 0}, {1000, 1}, {5000, 0}, {9000, 2}, {9000, 4000}}),
            (std::vector<std::size_t>{0, 3, 4}));
  EXPECT_EQ(straight_runs({{0, 0}, {1000, 20}, {2000, 0}}), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(straight_runs({{0, 0}, {9000, 0}, {4000, 0}}), (std::vector<std::size_t>{0, 1, 2})) << "there and back";
  EXPECT_EQ(straight_runs({{0, 0}, {9000, 0}}), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(straight_runs({}).empty());
}

TEST(HexOf, IsTheInverseOfColourFromHex) {
  for (int v = 0; v < 256; ++v) {
    const Colour c{static_cast<std::uint8_t>(v), static_cast<std::uint8_t>(255 - v), 7};
    EXPECT_EQ(colour_from_hex(hex_of(c)), c);
  }
  for (const char* bad : {"", "#", "#12", "#12345g", "123456", "#1234567"})
    EXPECT_EQ(colour_from_hex(bad), std::nullopt);
}

}  // namespace
}  // namespace vicus
