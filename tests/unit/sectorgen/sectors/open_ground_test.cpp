#include <gtest/gtest.h>

#include <algorithm>

#include "sectorgen/geom/polygon.hpp"
#include "tests/unit/sectorgen/sectors/drawn_map.hpp"

/// Large open ground is cut, and only there.
namespace vicus::test {
namespace {

/// A green of `length` x 120 m with streets and rows of houses around it, west end at 0.
SourceMap green(double length) {
  SourceMap map;
  const auto row = [&](double x0, double y0, double x1, double y1) {
    map.footprints.push_back(house("h" + std::to_string(map.footprints.size()), box(x0, y0, x1, y1)));
  };
  for (double x = -40; x < length + 40; x += 10) row(x, 150, x + 10, 160), row(x, -40, x + 10, -30);
  for (double y = -30; y < 150; y += 10) row(-50, y, -40, y + 10), row(length + 40, y, length + 50, y + 10);
  map.axes.push_back(street("South Side", {at(-30, -15), at(length + 30, -15)}));
  map.axes.push_back(street("North Side", {at(-30, 135), at(length + 30, 135)}));
  map.axes.push_back(street("West Side", {at(-30, -15), at(-30, 135)}));
  map.axes.push_back(street("East Side", {at(length + 30, -15), at(length + 30, 135)}));
  return map;
}

std::vector<const Sector*> open_sectors(const City& city) {
  std::vector<const Sector*> out;
  for (const auto& s : city.sectors)
    if (s.kind == SectorKind::open) out.push_back(&s);
  return out;
}

TEST(OpenGround, ALongGreenIsCutAcrossInPiecesOfSensibleSize) {
  const City city = built(green(500));
  const auto open = open_sectors(city);
  EXPECT_EQ(open.size(), 3u);
  for (const Sector* s : open) {
    EXPECT_LT(diameter_m(convex_hull(s->ground.outer)), 240) << s->id;
    EXPECT_GT(area_m2(s->ground), 10'000) << s->id;  // no slivers
  }
}

TEST(OpenGround, ASmallGreenStaysWhole) { EXPECT_EQ(open_sectors(built(green(100))).size(), 1u); }

TEST(OpenGround, ACutRunsBesideABandstand) {
  SourceMap map = green(500);
  map.footprints.push_back(house("bandstand", box(160, 50, 165, 55)));  // an island where a cut would lie
  map.footprints.push_back(house("kiosk", box(333, 70, 336, 73)));
  EXPECT_EQ(open_sectors(built(std::move(map))).size(), 3u);
}

TEST(OpenGround, AnEditFarAwayMovesNoCut) {
  const auto grounds = [](const City& city) {
    std::vector<Ring> out;
    for (const Sector* s : open_sectors(city)) out.push_back(s->ground.outer);
    std::sort(out.begin(), out.end());
    return out;
  };
  SourceMap map = green(500);
  map.axes.push_back(street("Far Street", {at(-30, -15), at(-400, -15)}));
  for (double x = -400; x < -60; x += 10) {
    map.footprints.push_back(house("n" + std::to_string(int(x)), box(x, 0, x + 10, 10)));
    map.footprints.push_back(house("s" + std::to_string(int(x)), box(x, -40, x + 10, -30)));
  }
  const auto before = grounds(built(map));
  std::erase_if(map.footprints, [](const Footprint& f) { return f.source_id == "n-300" || f.source_id == "s-200"; });
  EXPECT_EQ(grounds(built(std::move(map))), before);
}

}  // namespace
}  // namespace vicus::test
