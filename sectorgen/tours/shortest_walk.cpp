#include "sectorgen/tours/shortest_walk.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sectorgen/geom/predicates.hpp"

namespace vicus {
namespace {

constexpr int kEnd = 3;

template <class A, class B>
std::int64_t cross(const A& a, const B& b) {
  return a.x * b.y - a.y * b.x;
}

double length(PlanPoint a, PlanPoint b) { return std::hypot(double(b.x) - a.x, double(b.y) - a.y); }

struct Vec {
  double x = 0, y = 0;
};

}  // namespace

ShortestWalk::ShortestWalk(const WalkMesh& walk, const WalkPlaces& places)
    : walk_(walk), places_(places), let_in_(walk.mesh.triangles.size(), 0) {
  for (auto& known : known_) known.assign(walk.mesh.points.size(), 0);
  for (auto& least : least_) least.assign(walk.mesh.points.size(), 0);
}

PlanPoint ShortestWalk::root_point(const Look& look) const {
  return look.root == kNone ? from_ : walk_.mesh.points[look.root];
}

/// From the root over the seen part of the side to `to`, through walls beyond: never more than any walk.
double ShortestWalk::rest_over(const Look& look) const {
  const PlanPoint o = root_point(look), left_end = walk_.at(look.triangle, look.side + 1),
                  right_end = walk_.at(look.triangle, look.side + 2);
  const auto from_root = [&](PlanPoint p) { return Vec{double(p.x) - o.x, double(p.y) - o.y}; };
  const Vec a = from_root(left_end), b = from_root(right_end), along{b.x - a.x, b.y - a.y};
  const auto hit = [&](Vec ray) {
    const double x = ray.x, y = ray.y, slope = x * along.y - y * along.x;
    const double share = slope != 0 ? (a.x * along.y - a.y * along.x) / slope : 0;
    return Vec{x * share, y * share};
  };
  const Vec left_ray{double(look.left.x), double(look.left.y)}, right_ray{double(look.right.x), double(look.right.y)};
  const Vec left = left_ray.x * a.y - left_ray.y * a.x > 0 ? hit(left_ray) : a;
  const Vec right = right_ray.x * b.y - right_ray.y * b.x < 0 ? hit(right_ray) : b;
  Vec goal = from_root(to_);
  // Seen from the root the triangle lies beyond the side; a goal on this side of it is mirrored there.
  const double beyond = along.x * (goal.y - a.y) - along.y * (goal.x - a.x);
  if (beyond < 0) {
    const double twice = 2 * beyond / (along.x * along.x + along.y * along.y);
    goal.x += twice * along.y;
    goal.y -= twice * along.x;
  }
  const auto over = [&](Vec p) { return std::hypot(p.x, p.y) + std::hypot(goal.x - p.x, goal.y - p.y); };
  if (left.x * goal.y - left.y * goal.x > 0) return over(left);
  if (right.x * goal.y - right.y * goal.x < 0) return over(right);
  return std::hypot(goal.x, goal.y);
}

void ShortestWalk::push(Look look, double least_f) {
  if (!is_let_in(look.triangle)) return;
  look.f = std::max(least_f, look.g + rest_over(look));
  const auto index = static_cast<std::uint32_t>(looks_.size());
  queue_.emplace_back(-look.f, index);
  std::push_heap(queue_.begin(), queue_.end());
  looks_.push_back(look);
}

/// `to` is seen from the root of `seen_from`, which looks_[index] leads to.
void ShortestWalk::push_end(const Look& seen_from, std::uint32_t index, double f) {
  Look end = seen_from;
  end.side = kEnd;
  end.before = index;
  end.f = f;
  queue_.emplace_back(-f, static_cast<std::uint32_t>(looks_.size()));
  std::push_heap(queue_.begin(), queue_.end());
  looks_.push_back(end);
}

void ShortestWalk::start() {
  for (const std::uint32_t t : places_.standing_at(from_))
    for (int k = 0; k < 3; ++k) {
      const PlanPoint right = walk_.at(t, k + 1), left = walk_.at(t, k + 2);
      if (!walk_.is_open(t, k) || orient(right, left, from_) == 0) continue;
      Look look;
      look.triangle = walk_.mesh.triangles[t].neighbour[static_cast<std::size_t>(k)];
      look.side = static_cast<std::int8_t>(walk_.mesh.twin_side(t, k));
      look.left = {std::int64_t{left.x} - from_.x, std::int64_t{left.y} - from_.y};
      look.right = {std::int64_t{right.x} - from_.x, std::int64_t{right.y} - from_.y};
      push(look, 0);
    }
}

/// Through the triangle to its other two sides, and round their ends where the rays touch them.
void ShortestWalk::expand(std::uint32_t index) {
  const Look look = looks_[index];
  const std::uint32_t t = look.triangle;
  const int k = look.side;
  const PlanPoint o = root_point(look);
  const auto ray_to = [&](PlanPoint p) { return Ray{std::int64_t{p.x} - o.x, std::int64_t{p.y} - o.y}; };
  const Ray apex = ray_to(walk_.at(t, k)), a = ray_to(walk_.at(t, k + 1)), b = ray_to(walk_.at(t, k + 2));
  if (std::find(to_triangles_.begin(), to_triangles_.end(), t) != to_triangles_.end()) {
    const Ray to = ray_to(to_);
    if (cross(look.right, to) >= 0 && cross(to, look.left) >= 0)
      push_end(look, index, std::max(look.f, look.g + length(o, to_)));
  }
  const auto pass = [&](int side, Ray right, Ray left) {
    if (!walk_.is_open(t, side)) return;
    Look next = look;
    next.before = index;
    next.triangle = walk_.mesh.triangles[t].neighbour[static_cast<std::size_t>(side % 3)];
    next.side = static_cast<std::int8_t>(walk_.mesh.twin_side(t, side % 3));
    next.left = left;
    next.right = right;
    push(next, look.f);
  };
  if (cross(apex, look.left) > 0) pass(k + 2, cross(look.right, apex) > 0 ? apex : look.right, look.left);
  if (cross(look.right, apex) > 0) pass(k + 1, look.right, cross(apex, look.left) > 0 ? apex : look.left);
  if (cross(a, look.left) == 0) turn(index, 1);
  if (cross(b, look.right) == 0) turn(index, -1);
}

/// The end of the side that the ray touches becomes a root: from there all that lies beyond the ray is seen, round the
/// point from triangle to triangle as far as a wall.
void ShortestWalk::turn(std::uint32_t index, int towards) {
  const Look look = looks_[index];
  const bool is_left = towards > 0;
  int j = (look.side + (is_left ? 1 : 2)) % 3;
  const std::uint32_t root = walk_.mesh.corner(look.triangle, j);
  if (!walk_.is_bend(look.triangle, j) || root == look.root) return;
  const PlanPoint o = root_point(look), p = walk_.mesh.points[root];
  if (o == p) return;  // the start stands on it
  const double g = look.g + length(o, p);
  const std::size_t hand = is_left ? 0 : 1;
  if (known_[hand][root] == query_ && least_[hand][root] <= g) return;
  known_[hand][root] = query_;
  least_[hand][root] = g;
  const Ray in{std::int64_t{p.x} - o.x, std::int64_t{p.y} - o.y};
  const auto ray_to = [&](PlanPoint q) { return Ray{std::int64_t{q.x} - p.x, std::int64_t{q.y} - p.y}; };
  const auto is_beyond = [&](Ray ray) {  // straight back, too: round the end of a wall without breadth
    const std::int64_t side = is_left ? cross(in, ray) : cross(ray, in);
    return side > 0 || (side == 0 && in.x * ray.x + in.y * ray.y < 0);
  };
  Look next;
  next.g = g;
  next.before = index;
  next.root = root;
  next.turn = static_cast<std::int8_t>(towards);
  std::uint32_t t = look.triangle;
  do {
    const Ray right = ray_to(walk_.at(t, j + 1)), left = ray_to(walk_.at(t, j + 2));
    if (std::find(to_triangles_.begin(), to_triangles_.end(), t) != to_triangles_.end()) {
      const Ray to = ray_to(to_);
      if (is_left ? cross(in, to) >= 0 : cross(to, in) >= 0) {
        next.triangle = t;
        push_end(next, index, std::max(look.f, g + length(p, to_)));
      }
    }
    if (walk_.is_open(t, j) && is_beyond(is_left ? left : right)) {
      next.triangle = walk_.mesh.triangles[t].neighbour[static_cast<std::size_t>(j)];
      next.side = static_cast<std::int8_t>(walk_.mesh.twin_side(t, j));
      next.left = is_left || is_beyond(left) ? left : in;
      next.right = !is_left || is_beyond(right) ? right : in;
      push(next, look.f);
    }
    t = is_left ? turned_left(walk_, t, j) : turned_right(walk_, t, j);
  } while (t != kNone && t != look.triangle);
}

std::optional<Walk> ShortestWalk::find(PlanPoint from, PlanPoint to) {
  from_ = from;
  to_ = to;
  looks_.clear();
  queue_.clear();
  to_triangles_ = places_.standing_at(to);
  const auto from_triangles = places_.standing_at(from);
  bool is_connected = false;
  for (const std::uint32_t f : from_triangles) {
    for (const std::uint32_t t : to_triangles_) {
      if (f == t) {
        Walk walk;
        walk.points = {from, to};
        walk.radius_mm = {0, 0};
        walk.sectors = {{walk_.sector[t], 0}};
        walk.length_mm = length(from, to);
        return walk;
      }
      is_connected |= walk_.part[f] == walk_.part[t];
    }
  }
  if (!is_connected) return std::nullopt;
  if (++query_ == 0) {  // the counter has gone round
    std::fill(let_in_.begin(), let_in_.end(), 0);
    for (auto& known : known_) std::fill(known.begin(), known.end(), 0);
    query_ = 1;
  }
  const auto let_in = [&](const std::vector<std::uint32_t>& ends) {
    for (std::uint32_t t : ends)
      for (; walk_.way_out[t] != kNone; t = walk_.way_out[t]) let_in_[t] = query_;
  };
  let_in(from_triangles);
  let_in(to_triangles_);
  start();
  while (!queue_.empty()) {
    const std::uint32_t index = queue_.front().second;
    std::pop_heap(queue_.begin(), queue_.end());
    queue_.pop_back();
    const Look& look = looks_[index];
    if (look.side == kEnd) return walk_of(index);
    if (look.root != kNone && look.g > least_[look.turn > 0 ? 0 : 1][look.root]) continue;
    expand(index);
  }
  return std::nullopt;
}

/// Back from the last look: the bends, the sides passed and where.
Walk ShortestWalk::walk_of(std::uint32_t last) const {
  std::vector<std::uint32_t> chain;
  for (std::uint32_t i = last; i != kNone; i = looks_[i].before) chain.push_back(i);
  std::reverse(chain.begin(), chain.end());
  Walk walk;
  walk.steps = looks_.size();
  walk.points = {from_};
  walk.radius_mm = {0};
  walk.length_mm = 0;
  std::vector<double> passed_mm;                 // per look of the chain, where it is passed
  std::vector<std::uint32_t> root_of{kNone};     // per point of the walk
  const auto bend = [&](PlanPoint p, std::int32_t radius, std::uint32_t root) {
    walk.length_mm += length(walk.points.back(), p);
    walk.points.push_back(p);
    walk.radius_mm.push_back(radius);
    root_of.push_back(root);
  };
  std::vector<double> begins{0};
  for (const std::uint32_t i : chain)
    if (const Look& look = looks_[i]; look.root != root_of.back()) {
      bend(walk_.mesh.points[look.root], walk_.radius_mm[look.root], look.root);
      begins.push_back(walk.length_mm);
    }
  bend(to_, 0, kNone);
  // Sectors: over each side in turn; round a bend through the triangles that were only touched there.
  std::size_t leg = 0;
  const auto enter = [&](std::uint32_t sector, double at_mm) {
    if (walk.sectors.empty() || walk.sectors.back().sector != sector) walk.sectors.push_back({sector, at_mm});
  };
  for (std::size_t c = 0; c < chain.size(); ++c) {
    const Look& look = looks_[chain[c]];
    const Look* before = c > 0 ? &looks_[chain[c - 1]] : nullptr;
    if (!before) {
      for (const std::uint32_t t : places_.standing_at(from_))  // the one that the first side belongs to
        for (int k = 0; k < 3; ++k)
          if (walk_.is_open(t, k) && walk_.mesh.triangles[t].neighbour[static_cast<std::size_t>(k)] == look.triangle &&
              walk_.mesh.twin_side(t, k) == look.side)
            enter(walk_.sector[t], 0);
    } else if (look.root != before->root) {
      ++leg;
      std::uint32_t t = before->triangle;
      int j = 0;
      while (walk_.mesh.corner(t, j) != look.root) ++j;
      const std::uint32_t goal =
          look.side == kEnd ? look.triangle
                            : walk_.mesh.triangles[look.triangle].neighbour[static_cast<std::size_t>(look.side)];
      while (t != kNone) {
        enter(walk_.sector[t], begins[leg]);
        if (t == goal) break;
        t = look.turn > 0 ? turned_left(walk_, t, j) : turned_right(walk_, t, j);
      }
    }
    if (look.side == kEnd) break;
    const PlanPoint a = walk.points[leg], b = walk.points[leg + 1], p = walk_.at(look.triangle, look.side + 1),
                    q = walk_.at(look.triangle, look.side + 2);
    const double before_side = double(orient(p, q, a)), beyond_side = double(orient(p, q, b));
    const double share = before_side != beyond_side
                             ? std::clamp(before_side / (before_side - beyond_side), 0.0, 1.0)
                             : 0;
    const double leg_length = length(a, b);
    enter(walk_.sector[look.triangle], begins[leg] + share * leg_length);
  }
  return walk;
}

}  // namespace vicus
