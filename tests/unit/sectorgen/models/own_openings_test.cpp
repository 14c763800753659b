#include "sectorgen/models/own_openings.hpp"

#include <gtest/gtest.h>

#include <random>

#include "city_db/facade_layout.hpp"

namespace vicus {
namespace {

PlanPoint at(double east, double north) { return {lattice_mm(east), lattice_mm(north)}; }

/// 10 m wide, seen from the south; the house lies in the north.
Facade south_front() {
  Facade f;
  f.a = at(10, 0);
  f.b = at(0, 0);
  f.top_m = 9;
  return f;
}

ModelOpening upright(bool is_door, double x0, double x1, double z0, double z1, double north = 0.1) {
  return {is_door, {{at(x0, north), z0}, {at(x1, north), z0}, {at(x1, north), z1}, {at(x0, north), z1}}};
}

TEST(HangOpenings, StandWhereTheModelHasThem) {
  Facade f = south_front();
  HouseModel model;
  model.openings = {upright(false, 6, 7, 4, 5.5), upright(true, 4.5, 5.5, 0, 2.1), upright(false, 1, 2.5, 4, 5)};
  EXPECT_EQ(hang_openings(model, {&f}), 3u);
  const auto openings = openings_of(f);
  ASSERT_EQ(openings.size(), 3u);
  EXPECT_EQ(openings[0], (Opening{OpeningKind::house_door, 4.5, 5.5, 0, 2.1, 0, 0, 0.1}));
  EXPECT_EQ(openings[1], (Opening{OpeningKind::wide_window, 1, 2.5, 4, 5, 1, 1, 0.1}));
  EXPECT_EQ(openings[2], (Opening{OpeningKind::window, 6, 7, 4, 5.5, 1, 2, 0.1}));
  EXPECT_EQ(f.floors, 2);
  EXPECT_EQ(f.bays, 2);
  EXPECT_EQ(f.repeats, 1);
  EXPECT_EQ(f.door_bay, 1);
}

TEST(HangOpenings, GoToTheNearestWallThatTheyLieAlong) {
  Facade front = south_front(), back = south_front(), side = south_front();
  back.a = at(10, 0.6), back.b = at(0, 0.6);
  side.a = at(10, 8), side.b = at(10, 0);
  HouseModel model;
  model.openings = {upright(false, 6, 7, 1, 2, 0.5)};
  EXPECT_EQ(hang_openings(model, {&front, &side, &back}), 1u);
  EXPECT_TRUE(front.openings.empty());
  EXPECT_TRUE(side.openings.empty());
  EXPECT_EQ(back.openings.size(), 1u);
  model.openings = {upright(false, 6, 7, 1, 2, 3), upright(false, 12, 13, 1, 2), upright(false, 6, 7, 9.5, 10)};
  EXPECT_EQ(hang_openings(model, {&front}), 0u) << "too far behind, beside it, over its top";
}

TEST(HangOpenings, OfStoreysThatHangOutGoToTheWallBehindUnlessOneIsNearer) {
  Facade front = south_front(), back = south_front();
  back.a = at(10, 3), back.b = at(0, 3);
  HouseModel model;
  model.openings = {upright(false, 6, 7, 4, 5.5, -1.8), upright(false, 2, 3, 4, 5.5, 2.7)};
  EXPECT_EQ(hang_openings(model, {&front, &back}), 2u);
  ASSERT_EQ(front.openings.size(), 1u) << "1.8 m before it";
  EXPECT_NEAR(front.openings[0].x0, 6, 1e-9);
  EXPECT_EQ(front.openings[0].depth, figures_of(front.style).depth) << "not as deep as it hangs out";
  EXPECT_EQ(back.openings.size(), 1u) << "within 0.8 m of it, though within 2.7 m of the front";
}

TEST(HangOpenings, LieApartAndWithinTheFacade) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    Facade f = south_front();
    HouseModel model;
    for (int i = 0; i < 30; ++i) {
      const double x = pick(-1, 10), z = pick(-1, 9);
      model.openings.push_back(upright(i % 7 == 0, x, x + pick(0.3, 3), z, z + pick(0.3, 3), pick(-0.5, 0.05)));
    }
    hang_openings(model, {&f});
    ASSERT_FALSE(f.openings.empty());
    for (std::size_t i = 0; i < f.openings.size(); ++i) {
      const Opening& o = f.openings[i];
      EXPECT_TRUE(o.x0 >= 0 && o.x1 <= 10 && o.z0 >= 0 && o.z1 <= 9 && o.x1 - o.x0 > 0.19 && o.z1 - o.z0 > 0.19)
          << "seed " << seed;
      for (std::size_t k = 0; k < i; ++k) {
        const Opening& p = f.openings[k];
        EXPECT_TRUE(o.x1 < p.x0 || p.x1 < o.x0 || o.z1 < p.z0 || p.z1 < o.z0) << "seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace vicus
