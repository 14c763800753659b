#include "city_db/boxes.hpp"

#include <gtest/gtest.h>

namespace vicus {
namespace {

TEST(Boxes, HoldTheirPointsAndNothingMore) {
  const PlanBox box = box_of({{3, -2}, {-1, 5}, {0, 0}});
  EXPECT_EQ(box.min, (PlanPoint{-1, -2}));
  EXPECT_EQ(box.max, (PlanPoint{3, 5}));
  EXPECT_TRUE(box_of(std::vector<PlanPoint>{}).is_empty());
  EXPECT_EQ(box_of({7, 1}, {2, 9}).min, (PlanPoint{2, 1}));
  const Polygon polygon{{{0, 0}, {9, 0}, {9, 9}}, {{{-50, 0}, {1, 1}, {2, 2}}}};
  EXPECT_EQ(box_of(polygon).min, (PlanPoint{0, 0})) << "holes lie inside";
}

TEST(Boxes, MeetWhereTheyTouch) {
  const PlanBox box{{0, 0}, {10, 10}};
  EXPECT_TRUE(meet(box, {{10, 10}, {20, 20}}));
  EXPECT_FALSE(meet(box, {{11, 0}, {20, 10}}));
  EXPECT_TRUE(meet(grown(box, 1), {{11, 0}, {20, 10}}));
  const PlanBox all{{-kPlanLimit, -kPlanLimit}, {kPlanLimit, kPlanLimit}};
  EXPECT_TRUE(meet(all, box));
  EXPECT_FALSE(meet(all, PlanBox{})) << "an empty box meets nothing";
}

}  // namespace
}  // namespace vicus
