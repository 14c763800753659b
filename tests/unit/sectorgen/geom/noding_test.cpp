#include "sectorgen/geom/noding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sectorgen/geom/predicates.hpp"

namespace vicus {
namespace {

struct Piece {
  PlanPoint a, b;
};

std::vector<Piece> pieces_of(const Noded& noded) {
  std::vector<Piece> out;
  for (std::size_t s = 0; s + 1 < noded.begin.size(); ++s)
    for (std::uint32_t i = noded.begin[s]; i + 1 < noded.begin[s + 1]; ++i)
      out.push_back({noded.points[i], noded.points[i + 1]});
  return out;
}

/// The slow oracle: every pair.
std::size_t faults(const std::vector<Piece>& pieces) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = i + 1; j < pieces.size(); ++j) {
      const auto inside = [](const Piece& s, PlanPoint p) { return p != s.a && p != s.b && on_segment(s.a, s.b, p); };
      n += cross_properly(pieces[i].a, pieces[i].b, pieces[j].a, pieces[j].b);
      n += inside(pieces[i], pieces[j].a) + inside(pieces[i], pieces[j].b);
      n += inside(pieces[j], pieces[i].a) + inside(pieces[j], pieces[i].b);
    }
  return n;
}

double distance_to(PlanPoint a, PlanPoint b, PlanPoint p) {
  const double length2 = static_cast<double>(distance2(a, b));
  const double t = length2 > 0 ? std::clamp(static_cast<double>(dot(a, b, p)) / length2, 0.0, 1.0) : 0;
  const double dx = a.x + t * (double(b.x) - a.x) - p.x, dy = a.y + t * (double(b.y) - a.y) - p.y;
  return std::sqrt(dx * dx + dy * dy);
}

std::vector<Segment> random_segments(std::uint64_t seed, std::int32_t range, int count) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::int32_t> draw(-range, range);
  std::vector<Segment> out;
  for (int i = 0; i < count; ++i) out.push_back({{draw(random), draw(random)}, {draw(random), draw(random)}});
  return out;
}

TEST(NodeSegments, LeavesNoCrossingAndNoPointInsideAnEdge) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    for (std::int32_t range : {20, 300, 40'000}) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " range " << range);
      EXPECT_EQ(faults(pieces_of(node_segments(random_segments(seed, range, 40)))), 0u);
    }
}

TEST(NodeSegments, MovesNothingFartherThanItSays) {
  // Street-size segments, few crossings each: as in maps. Dense lattices (range 20) move farther, by design.
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const auto segments = random_segments(seed, 200'000, 60);
    const Noded noded = node_segments(segments);
    for (std::size_t s = 0; s < segments.size(); ++s)
      for (std::uint32_t i = noded.begin[s]; i < noded.begin[s + 1]; ++i)
        EXPECT_LE(distance_to(segments[s].a, segments[s].b, noded.points[i]), 1.0);
  }
}

TEST(NodeSegments, KeepsTheEndsAndTheOrder) {
  const Noded noded = node_segments({{{0, 0}, {1'000, 0}}, {{500, -500}, {500, 500}}, {{1'000, 0}, {0, 0}}});
  const auto line = [&](std::size_t s) {
    return std::vector<PlanPoint>(noded.points.begin() + noded.begin[s], noded.points.begin() + noded.begin[s + 1]);
  };
  EXPECT_EQ(line(0), (std::vector<PlanPoint>{{0, 0}, {500, 0}, {1'000, 0}}));
  EXPECT_EQ(line(1), (std::vector<PlanPoint>{{500, -500}, {500, 0}, {500, 500}}));
  EXPECT_EQ(line(2), (std::vector<PlanPoint>{{1'000, 0}, {500, 0}, {0, 0}}));
}

TEST(NodeSegments, GivesTheSameWhateverTheOrder) {
  auto segments = random_segments(9, 500, 50);
  const auto key = [](std::vector<Piece> pieces) {
    std::vector<std::pair<PlanPoint, PlanPoint>> out;
    for (const Piece& p : pieces) out.push_back({std::min(p.a, p.b), std::max(p.a, p.b)});
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  };
  const auto once = key(pieces_of(node_segments(segments)));
  std::reverse(segments.begin(), segments.end());
  EXPECT_EQ(once, key(pieces_of(node_segments(segments))));
}

}  // namespace
}  // namespace vicus
