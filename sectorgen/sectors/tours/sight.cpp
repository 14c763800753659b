#include "sectorgen/sectors/tours/sight.hpp"

#include <algorithm>

#include "sectorgen/geom/predicates.hpp"

namespace vicus {

Sight::Sight(const WalkMesh& walk) : walk_(walk), listed_(walk.mesh.points.size(), 0) {}

void Sight::begin(PlanPoint root) {
  root_ = root;
  looks_.clear();
  corners_.clear();
  met_head_on_.clear();
  has_seen_goal_ = false;
  if (++look_ == 0) {  // the counter has gone round
    std::fill(listed_.begin(), listed_.end(), 0);
    look_ = 1;
  }
}

void Sight::watch_for(PlanPoint goal, const std::vector<std::uint32_t>& goal_triangles) {
  goal_ = goal;
  goal_triangles_ = goal_triangles;
  has_goal_ = true;
}

/// Corner k of t is seen: is it one to bend at, for who comes straight from the root?
void Sight::touch(std::uint32_t t, int k) {
  const std::uint32_t point = walk_.mesh.corner(t, k);
  if (listed_[point] == look_) return;
  const PlanPoint p = walk_.mesh.points[point];
  if (p == root_) return;
  if (!walk_.is_bend(t, k)) return;
  const Ray in = ray_to(p);
  const auto &right = walk_.right_wall[point], &left = walk_.left_wall[point];
  const Ray r{std::int64_t{right.x} - p.x, std::int64_t{right.y} - p.y},
      l{std::int64_t{left.x} - p.x, std::int64_t{left.y} - p.y};
  listed_[point] = look_;
  (cross(l, in) > 0 && cross(in, r) > 0 ? met_head_on_ : corners_).push_back(point);
}

void Sight::pass(std::uint32_t t, int side, Ray right, Ray left, std::uint32_t before) {
  side %= 3;
  if (!walk_.is_open(t, side)) return;
  if (is_narrow_) {
    const Ray goal = ray_to(goal_);
    if (cross(right, goal) < 0 || cross(goal, left) < 0) return;
  }
  const std::uint32_t n = walk_.mesh.triangles[t].neighbour[static_cast<std::size_t>(side)];
  looks_.push_back({n, before, walk_.mesh.twin_side(t, side), right, left});
}

/// true: this look has found the goal.
bool Sight::expand(std::uint32_t index) {
  const Look look = looks_[index];
  const std::uint32_t t = look.triangle;
  if (has_goal_ && std::find(goal_triangles_.begin(), goal_triangles_.end(), t) != goal_triangles_.end()) {
    const Ray goal = ray_to(goal_);
    if (cross(look.right, goal) >= 0 && cross(goal, look.left) >= 0) {
      has_seen_goal_ = true;
      if (is_narrow_) return true;
    }
  }
  const Ray apex = ray_to(walk_.at(t, look.side));
  const std::int64_t of_right = cross(look.right, apex), of_left = cross(apex, look.left);
  if (of_right >= 0 && of_left >= 0 && !is_narrow_) touch(t, look.side);
  if (of_left > 0) pass(t, look.side + 2, of_right > 0 ? apex : look.right, look.left, index);
  if (of_right > 0) pass(t, look.side + 1, look.right, of_left > 0 ? apex : look.left, index);
  return false;
}

void Sight::look_all() {
  for (std::uint32_t i = 0; i < looks_.size(); ++i) expand(i);
  has_goal_ = false;
}

void Sight::look_round(PlanPoint p, const std::vector<std::uint32_t>& standing) {
  begin(p);
  for (const std::uint32_t t : standing)
    for (int k = 0; k < 3; ++k) {
      touch(t, k);
      const PlanPoint right = walk_.at(t, k + 1), left = walk_.at(t, k + 2);
      if (orient(right, left, p) != 0) pass(t, k, ray_to(right), ray_to(left), kNone);
    }
  if (has_goal_ && std::any_of(standing.begin(), standing.end(), [&](std::uint32_t t) {
        return std::find(goal_triangles_.begin(), goal_triangles_.end(), t) != goal_triangles_.end();
      }))
    has_seen_goal_ = true;
  const bool has_seen = has_seen_goal_;
  look_all();
  has_seen_goal_ |= has_seen;
}

void Sight::look_on(std::uint32_t t, int j) {
  const std::uint32_t point = walk_.mesh.corner(t, j);
  const PlanPoint p = walk_.mesh.points[point];
  begin(p);
  const Ray e1 = ray_to(walk_.right_wall[point]), e2 = ray_to(walk_.left_wall[point]);
  const Ray back1{-e1.x, -e1.y}, back2{-e2.x, -e2.y};
  while (t != kNone) {
    const Ray right = ray_to(walk_.at(t, j + 1)), left = ray_to(walk_.at(t, j + 2));
    // Off along the right wall and as far as straight on from the left one; and the other way round.
    const bool is_first = is_before(right, back2), is_second = is_before(back1, left);
    const bool touches_first = cross(right, back2) >= 0, touches_second = cross(back1, left) >= 0;
    if (touches_first) touch(t, (j + 1) % 3);
    if (touches_second) touch(t, (j + 2) % 3);
    if (cross(left, back2) >= 0 && is_first) touch(t, (j + 2) % 3);
    if (cross(back1, right) >= 0 && is_second) touch(t, (j + 1) % 3);
    const bool is_all_first = is_first && cross(left, back2) >= 0,
               is_all_second = is_second && cross(back1, right) >= 0;
    if (is_all_first || is_all_second) {
      pass(t, j, right, left, kNone);
    } else {
      if (is_first) pass(t, j, right, back2, kNone);
      if (is_second) pass(t, j, back1, left, kNone);
    }
    t = turned_left(walk_, t, j);
  }
  look_all();
}

std::vector<SidePassed> Sight::way_to(PlanPoint p, const std::vector<std::uint32_t>& from, PlanPoint goal,
                                      const std::vector<std::uint32_t>& to) {
  begin(p);
  for (const std::uint32_t t : from)
    if (std::find(to.begin(), to.end(), t) != to.end()) return {};
  watch_for(goal, to);
  is_narrow_ = true;
  for (const std::uint32_t t : from)
    for (int k = 0; k < 3; ++k) {
      const PlanPoint right = walk_.at(t, k + 1), left = walk_.at(t, k + 2);
      if (orient(right, left, p) != 0) pass(t, k, ray_to(right), ray_to(left), kNone);
    }
  std::vector<SidePassed> way;
  for (std::uint32_t i = 0; i < looks_.size() && way.empty(); ++i)
    if (expand(i))
      for (std::uint32_t at = i; at != kNone; at = looks_[at].before)
        way.push_back({looks_[at].triangle, looks_[at].side});
  is_narrow_ = has_goal_ = false;
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace vicus
