#include <algorithm>
#include <numeric>

#include "sectorgen/sectors/cells.hpp"
#include "sectorgen/sectors/tracing.hpp"

namespace vicus {
namespace {

/// Sides of the ground in each triangle: what a sector's bytes grow with.
std::uint32_t sides_of(const Ground& g, std::uint32_t t) {
  std::uint32_t n = 0;
  for (int k = 0; k < 3; ++k) n += !g.is_crossable(t, k);
  return n;
}

struct Member {
  std::int64_t along;
  std::uint32_t triangle;
};

/// Parts a cell's triangles in two halves of like weight across its longer side; a piece cut off from its half goes to
/// the other, so that both hang together. Returns the triangles of the new half, empty when it cannot be parted.
std::vector<std::uint32_t> halve(const Ground& g, const std::vector<std::uint32_t>& triangles,
                                 std::vector<char>& mark) {
  PlanBox box;
  for (std::uint32_t t : triangles)
    for (int k = 0; k < 3; ++k) box.add(g.mesh.points[g.mesh.corner(t, k)]);
  const bool by_x = box.max.x - box.min.x >= box.max.y - box.min.y;
  std::vector<Member> members;
  std::uint64_t total = 0;
  for (std::uint32_t t : triangles) {
    std::int64_t sum = 0;
    for (int k = 0; k < 3; ++k) {
      const PlanPoint p = g.mesh.points[g.mesh.corner(t, k)];
      sum += by_x ? p.x : p.y;
    }
    members.push_back({sum, t});
    total += sides_of(g, t);
  }
  std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
    return a.along != b.along ? a.along < b.along : a.triangle < b.triangle;
  });
  std::uint64_t weight = 0;
  for (const Member& m : members) {
    weight += sides_of(g, m.triangle);
    mark[m.triangle] = 2 * weight <= total ? 1 : 2;
  }
  for (int side = 1; side <= 2; ++side) {  // keep the largest piece of this half, hand over the rest
    std::vector<std::vector<std::uint32_t>> pieces;
    for (std::uint32_t seed : triangles) {
      if (mark[seed] != side) continue;
      std::vector<std::uint32_t> piece{seed};
      mark[seed] = 3;
      for (std::size_t i = 0; i < piece.size(); ++i)
        for (int k = 0; k < 3; ++k) {
          if (!g.is_crossable(piece[i], k) || mark[g.beyond(piece[i], k)] != side) continue;
          mark[g.beyond(piece[i], k)] = 3;
          piece.push_back(g.beyond(piece[i], k));
        }
      pieces.push_back(std::move(piece));
    }
    std::size_t largest = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i)
      if (pieces[i].size() > pieces[largest].size()) largest = i;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::uint32_t t : pieces[i]) mark[t] = static_cast<char>(i == largest ? 3 + side : 3 - side);
    for (std::uint32_t t : triangles)
      if (mark[t] == 3 + side) mark[t] = static_cast<char>(side);
  }
  std::vector<std::uint32_t> half;
  for (std::uint32_t t : triangles) {
    if (mark[t] == 2) half.push_back(t);
    mark[t] = 0;
  }
  if (half.size() == triangles.size()) half.clear();
  return half;
}

}  // namespace

std::vector<PlanPoint> islands_in_heavy_cells(const Ground& g, const Cells& cells, std::uint32_t limit) {
  std::vector<std::vector<std::uint32_t>> islands(cells.kind.size());
  std::vector<std::uint32_t> weight(cells.kind.size(), 0);
  for (std::uint32_t t = 0; t < cells.of.size(); ++t)
    if (cells.of[t] != kNone) weight[cells.of[t]] += sides_of(g, t);
  locate_islands(g, cells.of, islands);
  std::vector<PlanPoint> out;
  for (std::size_t c = 0; c < islands.size(); ++c) {
    for (std::uint32_t i : islands[c]) weight[c] += static_cast<std::uint32_t>(g.islands[i].area.outer.size());
    if (weight[c] <= limit) continue;
    for (std::uint32_t i : islands[c]) out.push_back(g.islands[i].area.outer.front());
  }
  return out;
}

void split_heavy_cells(const Ground& g, Cells& cells, std::uint32_t limit) {
  std::vector<std::vector<std::uint32_t>> members(cells.kind.size());
  for (std::uint32_t t = 0; t < cells.of.size(); ++t)
    if (cells.of[t] != kNone) members[cells.of[t]].push_back(t);
  std::vector<char> mark(cells.of.size(), 0);
  for (std::size_t c = 0; c < members.size(); ++c) {  // halves are appended, and looked at in their turn
    while (true) {
      std::uint64_t weight = 0;
      for (std::uint32_t t : members[c]) weight += sides_of(g, t);
      if (weight <= limit) break;
      auto half = halve(g, members[c], mark);
      if (half.empty()) break;
      const auto number = static_cast<std::uint32_t>(members.size());
      for (std::uint32_t t : half) cells.of[t] = number;
      std::erase_if(members[c], [&](std::uint32_t t) { return cells.of[t] == number; });
      cells.kind.push_back(cells.kind[c]);
      members.push_back(std::move(half));
    }
  }
}

}  // namespace vicus
