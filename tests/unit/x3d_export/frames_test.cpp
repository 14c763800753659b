#include "x3d_export/frames.hpp"

#include <gtest/gtest.h>

namespace vicus {
namespace {

TEST(Frames, EastIsXUpIsYNorthIsMinusZ) {
  EXPECT_EQ(x3d_from_plan({5000, 7000}, 1700, {1000, 2000}), (X3dPoint{4000, 1700, -5000}));
}

TEST(Frames, PlanFromX3dIsTheInverse) {
  const PlanPoint origin{-123456, 987654};
  for (const PlanPoint p : {PlanPoint{0, 0}, PlanPoint{1, -1}, PlanPoint{-99999, 500000}})
    EXPECT_EQ(plan_from_x3d(x3d_from_plan(p, 3, origin), origin), p);
}

TEST(Frames, AHeadingTurnsAViewpointClockwise) {
  // A Viewpoint looks along -z, north. Turned by yaw about y it looks along (-sin yaw, 0, -cos yaw).
  const double yaw = x3d_yaw_from_heading(90);
  EXPECT_NEAR(-std::sin(yaw), 1, 1e-12) << "east";
  EXPECT_NEAR(-std::cos(yaw), 0, 1e-12);
}

}  // namespace
}  // namespace vicus
