#include "city_db/store_rtree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/scratch.hpp"

namespace vicus {
namespace {

PlanBox random_box(std::mt19937& random, std::int32_t spread) {
  std::uniform_int_distribution<std::int32_t> place(-spread, spread), size(0, spread / 50);
  PlanBox box;
  box.min = {place(random), place(random)};
  box.max = {box.min.x + size(random), box.min.y + size(random)};
  return box;
}

bool meets(const PlanBox& a, const PlanBox& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

std::vector<std::int64_t> found(Statement& query, const PlanBox& box) {
  query.bind(0, metres(box.min.x));
  query.bind(1, metres(box.max.x));
  query.bind(2, metres(box.min.y));
  query.bind(3, metres(box.max.y));
  std::vector<std::int64_t> ids;
  while (query.step()) ids.push_back(query.integer(0));
  query.reset();
  return ids;
}

/// A packed tree of `n` boxes: SQLite's own check, then every box query against a loop over all boxes.
void check_packed(std::size_t n, std::int32_t spread, std::mt19937& random) {
  SCOPED_TRACE(std::to_string(n) + " boxes, spread " + std::to_string(spread));
  test::ScratchDirectory scratch;
  auto db = Database::create(scratch / "rtree", scratch / "rtree");
  db.execute("BEGIN; CREATE VIRTUAL TABLE r USING rtree(id, minx, maxx, miny, maxy)");
  std::vector<RtreeEntry> entries;
  for (std::size_t i = 0; i < n; ++i)
    entries.push_back({static_cast<std::int64_t>(3 * i + 1), random_box(random, spread)});
  fill_rtree(db, "r", entries);
  db.execute("COMMIT");
  auto check = db.prepare("SELECT rtreecheck('r')");
  ASSERT_TRUE(check.step());
  EXPECT_EQ(check.text(0), "ok");
  check.reset();
  auto query = db.prepare("SELECT id FROM r WHERE maxx >= ?1 AND minx <= ?2 AND maxy >= ?3 AND miny <= ?4 ORDER BY id");
  for (int i = 0; i < 50; ++i) {
    const PlanBox box = random_box(random, spread);
    const auto ids = found(query, box);
    std::size_t expected = 0;
    for (const auto& entry : entries) {
      if (!meets(entry.box, box)) continue;
      ++expected;
      ASSERT_TRUE(std::binary_search(ids.begin(), ids.end(), entry.id));
    }
    // Float boxes are at most one step larger: 64 um at 1 km.
    EXPECT_GE(ids.size(), expected);
    if (spread <= 1'000'000) {
      EXPECT_EQ(ids.size(), expected);
    }
  }
}

TEST(FillRtree, FindsWhatALoopFinds) {
  const unsigned seed = std::random_device{}();
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  for (std::size_t n : {0u, 1u, 50u, 51u, 52u, 102u, 2601u, 2602u, 5000u}) check_packed(n, 1'000'000, random);
  check_packed(300, kPlanLimit / 2, random);
  check_packed(300, 100, random);
}

TEST(FillRtree, LeavesATreeThatSqliteCanGoOnEditing) {
  std::mt19937 random(5);
  test::ScratchDirectory scratch;
  auto db = Database::create(scratch / "rtree", scratch / "rtree");
  db.execute("CREATE VIRTUAL TABLE r USING rtree(id, minx, maxx, miny, maxy)");
  std::vector<RtreeEntry> entries;
  for (int i = 1; i <= 3000; ++i) entries.push_back({i, random_box(random, 1'000'000)});
  fill_rtree(db, "r", entries);
  db.execute("DELETE FROM r WHERE id % 3 = 0; INSERT INTO r SELECT id + 10000, minx, maxx, miny, maxy FROM r");
  auto check = db.prepare("SELECT rtreecheck('r'), count(*) FROM r");
  ASSERT_TRUE(check.step());
  EXPECT_EQ(check.text(0), "ok");
  EXPECT_EQ(check.integer(1), 4000);
}

}  // namespace
}  // namespace vicus
