#include "city_db/wall_stretches.hpp"

#include <gtest/gtest.h>

namespace vicus {
namespace {

Door door(PlanPoint a, PlanPoint b) {
  Door d;
  d.a = a;
  d.b = b;
  return d;
}

TEST(WallStretches, RunFromEndToEndWithEachDoorInItsPlace) {
  const PlanPoint a{0, 0}, b{10'000, 0};
  const Door first = door({1'000, -3}, {2'000, -3}), second = door({7'000, 0}, {8'000, 0});
  const auto pieces = wall_stretches(a, b, {&second, &first});
  ASSERT_EQ(pieces.size(), 5u);
  EXPECT_EQ(pieces.front().a, a);
  EXPECT_EQ(pieces.back().b, b);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) EXPECT_EQ(pieces[i].b, pieces[i + 1].a);
  EXPECT_EQ(pieces[1].door, &first);
  EXPECT_EQ(pieces[3].door, &second);
}

TEST(WallStretches, ADoorOfAnotherWallOrTheOtherSideIsNone) {
  const PlanPoint a{0, 0}, b{10'000, 0};
  const Door off = door({1'000, 13}, {2'000, 13}), turned = door({2'000, 0}, {1'000, 0}),
             across = door({9'500, 0}, {10'500, 0});
  const auto pieces = wall_stretches(a, b, {&off, &turned, &across});
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].door, nullptr);
}

TEST(WallStretches, ADoorAtTheEndLeavesNoPieceWithoutLength) {
  const Door at_end = door({0, 0}, {1'000, 0});
  EXPECT_EQ(wall_stretches({0, 0}, {10'000, 0}, {&at_end}).size(), 2u);
}

}  // namespace
}  // namespace vicus
