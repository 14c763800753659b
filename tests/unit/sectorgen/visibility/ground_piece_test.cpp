#include "sectorgen/visibility/ground_piece.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "sectorgen/geom/predicates.hpp"

namespace vicus::test {
namespace {

/// a x + b y + c >= 0.
struct HalfPlane {
  Int128 a, b, c;
};

HalfPlane left_of(PlanPoint p, PlanPoint q) {
  return {std::int64_t{p.y} - q.y, std::int64_t{q.x} - p.x,
          std::int64_t{q.y - p.y} * p.x - std::int64_t{q.x - p.x} * p.y};
}
void add_sides(std::vector<HalfPlane>& planes, const Corners& triangle) {
  for (std::size_t k = 0; k < 3; ++k) planes.push_back(left_of(triangle[k], triangle[(k + 1) % 3]));
}

/// What bounded half-planes have in common has a corner where two of their lines cross. Exact: 128 bits.
bool have_a_common_point(const std::vector<HalfPlane>& planes) {
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      Int128 det = planes[i].a * planes[j].b - planes[j].a * planes[i].b;
      if (det == 0) continue;
      Int128 x = planes[i].b * planes[j].c - planes[j].b * planes[i].c,
             y = planes[j].a * planes[i].c - planes[i].a * planes[j].c;
      if (det < 0) det = -det, x = -x, y = -y;
      if (std::all_of(planes.begin(), planes.end(),
                      [&](const HalfPlane& p) { return p.a * x + p.b * y + p.c * det >= 0; }))
        return true;
    }
  return false;
}

class Draw {
 public:
  PlanPoint point() { return {within(-9, 9), within(-9, 9)}; }
  Corners triangle() {
    for (;;) {
      const Corners t{point(), point(), point()};
      if (orient(t[0], t[1], t[2]) > 0) return t;
    }
  }

 private:
  std::int32_t within(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }
  std::mt19937_64 random_{7};
};

/// A bundle through one more side before the cell's side 0, so that its lines are bounded on both sides.
struct Look {
  Corners cell;
  Wedge lines;
};

/// Both ends of the side behind, seen through the cell's side; false: not a bundle of lines.
bool make_look(Draw& draw, Look& look) {
  look.cell = draw.triangle();
  const PlanPoint left = look.cell[1], right = look.cell[2], behind_left = draw.point(), behind_right = draw.point();
  // The cell lies left of left -> right; what is behind lies on the other side, its left end on the left.
  if (orient(left, right, behind_left) >= 0 || orient(left, right, behind_right) >= 0) return false;
  if (orient(behind_right, left, right) > 0 || orient(behind_left, right, left) < 0) return false;
  if (orient(behind_right, behind_left, left) > 0 || orient(behind_right, behind_left, right) > 0) return false;
  look.lines = {behind_right, left, behind_left, right, left, right};
  return true;
}

TEST(Overlap, IsThatOfInnerPoints) {
  Draw draw;
  int yes = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Corners a = draw.triangle(), b = draw.triangle();
    // A hair inside every side: nothing in common any more where sides only touch.
    std::vector<HalfPlane> planes;
    add_sides(planes, a);
    add_sides(planes, b);
    for (auto& p : planes) p.a *= 100'000'000, p.b *= 100'000'000, p.c = p.c * 100'000'000 - 1;
    EXPECT_EQ(overlap(a, b), have_a_common_point(planes)) << i;
    yes += overlap(a, b);
  }
  EXPECT_GT(yes, 5'000);
  EXPECT_LT(yes, 15'000);
}

TEST(Meets, IsExact) {
  Draw draw;
  int yes = 0, no = 0;
  while (yes + no < 20'000) {
    Look look;
    if (!make_look(draw, look)) continue;
    const Corners piece = draw.triangle();
    if (!overlap(piece, look.cell)) continue;
    const auto& lines = look.lines;
    const bool turns = std::count(piece.begin(), piece.end(), lines.left_end) +
                           std::count(piece.begin(), piece.end(), lines.right_end) >
                       0;
    if (turns) continue;  // below
    std::vector<HalfPlane> planes{left_of(lines.leftmost_to, lines.leftmost_from),
                                  left_of(lines.rightmost_from, lines.rightmost_to)};
    add_sides(planes, look.cell);
    add_sides(planes, piece);
    const bool expected = have_a_common_point(planes);
    EXPECT_EQ(meets(piece, look.cell, lines), expected) << yes + no;
    (expected ? yes : no) += 1;
  }
  EXPECT_GT(yes, 1'000);
  EXPECT_GT(no, 1'000);
}

/// From below through the side from (0, 0) to (4, 0) into the cell above; the rightmost line goes up at x = 4.
TEST(Meets, NotWhatALinePassesOnlyWhereItTurns) {
  const Corners cell{{{6, 9}, {0, 0}, {4, 0}}};
  const Wedge lines{{4, -4}, {0, 0}, {4, -4}, {4, 0}, {0, 0}, {4, 0}};
  EXPECT_FALSE(meets({{{4, 0}, {9, 3}, {6, 9}}}, cell, lines)) << "right of the rightmost line, from its turn on";
  EXPECT_TRUE(meets({{{4, 0}, {9, 3}, {4, 9}}}, cell, lines)) << "a side along the line";
  EXPECT_TRUE(meets({{{4, 0}, {6, 9}, {3, 9}}}, cell, lines)) << "both sides of the line";
  EXPECT_TRUE(meets({{{4, 1}, {9, 3}, {6, 9}}}, cell, lines)) << "beyond the turn the line touches a corner";
}

/// As far apart as is allowed: shares of 2^60.
TEST(Meets, IsExactOverHundredsOfKilometres) {
  constexpr std::int32_t kFar = 1 << 28;
  const Corners cell{{{0, kFar}, {-kFar, -kFar}, {kFar, -kFar}}};
  // Both lines are one, up the middle; pieces begin beside it.
  const Wedge lines{{0, -kFar}, {0, kFar}, {0, -kFar}, {0, kFar}, {-kFar, -kFar}, {kFar, -kFar}};
  EXPECT_TRUE(meets({{{0, 0}, {kFar, -1}, {kFar, 1}}}, cell, lines));
  EXPECT_FALSE(meets({{{1, 0}, {kFar, -1}, {kFar, 1}}}, cell, lines));
  EXPECT_TRUE(meets({{{-1, 1}, {kFar, -1}, {kFar, 0}}}, cell, lines));
}

}  // namespace
}  // namespace vicus::test
