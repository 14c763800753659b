#include "sectorgen/sectors/overlay.hpp"

#include <gtest/gtest.h>

#include <random>

#include "sectorgen/geom/polygon.hpp"

namespace vicus {
namespace {

double area_of(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& p : polygons) sum += area_m2(p);
  return sum;
}

/// A block of two boxes that overlap, and lines with bends all over the place.
struct Scene {
  explicit Scene(unsigned seed) : random(seed) {
    const auto box = [&](int x, int y, int w, int h) {
      return Polygon{{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, {}};
    };
    area = unite({box(0, 0, number(20'000, 60'000), number(5'000, 9'000)),
                  box(number(0, 9'000), 0, number(5'000, 9'000), number(20'000, 60'000)),
                  box(number(70'000, 90'000), number(0, 40'000), 9'000, 9'000)});
    for (int i = 0; i < 40; ++i) {
      Stroke stroke{{}, 0.1 * number(2, 15)};
      PlanPoint p{number(-40'000, 120'000), number(-40'000, 120'000)};
      for (int k = 0; k < 3; ++k) {
        stroke.line.push_back(p);
        p = {p.x + number(500, 9'000), p.y + number(-9'000, 9'000)};
      }
      strokes.push_back(std::move(stroke));
    }
  }
  int number(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random); }
  std::mt19937 random;
  std::vector<Polygon> area;
  std::vector<Stroke> strokes;
};

TEST(KeepOff, IsWhatSubtractingAllOutlinesLeaves) {
  double cut_m2 = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene(seed);
    for (const Cap cap : {Cap::flat, Cap::round}) {
      const auto fast = keep_off(scene.area, scene.strokes, cap),
                 slow = subtract(scene.area, stroke_outlines(scene.strokes, cap));
      // Outlines united all together are rounded once more than those near the area.
      const double rounding_m2 = 0.002 * 500;
      EXPECT_LT(area_of(subtract(fast, slow)), rounding_m2);
      EXPECT_LT(area_of(subtract(slow, fast)), rounding_m2);
      cut_m2 += area_of(scene.area) - area_of(fast);
    }
  }
  EXPECT_GT(cut_m2, 1000);
}

TEST(KeepOff, LeavesAloneWhatNothingIsNear) {
  const Scene scene(1);
  const std::vector<Stroke> far{{{{900'000, 900'000}, {950'000, 900'000}}, 1}};
  EXPECT_EQ(area_of(keep_off(scene.area, far, Cap::flat)), area_of(scene.area));
  EXPECT_EQ(area_of(keep_off(scene.area, {}, Cap::flat)), area_of(scene.area));
  EXPECT_TRUE(keep_off({}, far, Cap::flat).empty());
}

}  // namespace
}  // namespace vicus
