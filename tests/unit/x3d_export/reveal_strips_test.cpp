#include "x3d_export/reveal_strips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "x3d_export/frames.hpp"

namespace vicus {
namespace {

/// A wall of cells, some of them openings, some openings wider or higher than one cell; none overlap.
std::vector<Opening> random_openings(std::mt19937& random) {
  const auto pick = [&](int least, int most) { return std::uniform_int_distribution(least, most)(random); };
  const int columns = pick(1, 8), rows = pick(1, 6);
  std::vector<Opening> out;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns;) {
      const int width = std::min(pick(1, 3), columns - column);
      if (pick(0, 3) != 0) {
        Opening o;
        o.x0 = column + 0.1 * pick(0, 2);
        o.x1 = column + width - 0.1 * pick(1, 2);
        o.z0 = row * 3 + 0.5 * pick(0, 1);
        o.z1 = row * 3 + 2.5;
        out.push_back(o);
      }
      column += width;
    }
  return out;
}

bool has(const std::vector<RevealStrip>& strips, double at, double from, double to) {
  return std::any_of(strips.begin(), strips.end(), [&](const RevealStrip& s) {
    return s.at == height_mm(at) && s.from <= height_mm(from) && s.to >= height_mm(to);
  });
}

TEST(RevealStrips, CoverEverySideAndComeOutInNoOpening) {
  std::size_t sides = 0, faces = 0;
  for (unsigned seed = 1; seed <= 500; ++seed) {
    std::mt19937 random(seed);
    const auto openings = random_openings(random);
    const RevealStrips strips = reveal_strips(openings);
    for (const Opening& o : openings) {
      EXPECT_TRUE(has(strips.left, o.x0, o.z0, o.z1)) << "seed " << seed;
      EXPECT_TRUE(has(strips.right, o.x1, o.z0, o.z1)) << "seed " << seed;
      EXPECT_TRUE(has(strips.sill, o.z0, o.x0, o.x1)) << "seed " << seed;
      EXPECT_TRUE(has(strips.head, o.z1, o.x0, o.x1)) << "seed " << seed;
      const auto comes_out = [](const RevealStrip& s, double low, double high, double from, double to) {
        return height_mm(low) < s.at && s.at < height_mm(high) && s.from < height_mm(to) && height_mm(from) < s.to;
      };
      for (const auto* upright : {&strips.left, &strips.right})
        for (const RevealStrip& s : *upright)
          EXPECT_FALSE(comes_out(s, o.x0, o.x1, o.z0, o.z1)) << "seed " << seed << ", upright at " << s.at;
      for (const auto* level : {&strips.sill, &strips.head})
        for (const RevealStrip& s : *level)
          EXPECT_FALSE(comes_out(s, o.z0, o.z1, o.x0, o.x1)) << "seed " << seed << ", level at " << s.at;
    }
    sides += 4 * openings.size();
    faces += strips.left.size() + strips.right.size() + strips.sill.size() + strips.head.size();
  }
  EXPECT_LT(faces, sides) << "no side is joined to another";
}

TEST(RevealStrips, JoinWholeRowsAndColumnsOfAPlainFacade) {
  std::vector<Opening> openings;
  for (int floor = 0; floor < 4; ++floor)
    for (int bay = 0; bay < 5; ++bay) {
      Opening o;
      o.x0 = bay * 2 + 0.5;
      o.x1 = bay * 2 + 1.5;
      o.z0 = floor * 3 + 1;
      o.z1 = floor * 3 + 2.5;
      openings.push_back(o);
    }
  const RevealStrips strips = reveal_strips(openings);
  EXPECT_EQ(strips.left.size(), 5u);
  EXPECT_EQ(strips.right.size(), 5u);
  EXPECT_EQ(strips.sill.size(), 4u);
  EXPECT_EQ(strips.head.size(), 4u);
  EXPECT_EQ(strips.left.front(), (RevealStrip{500, 1000, 11'500}));
}

TEST(RevealStrips, AreNoneWithoutOpenings) { EXPECT_TRUE(reveal_strips({}).left.empty()); }

}  // namespace
}  // namespace vicus
