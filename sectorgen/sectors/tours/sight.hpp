#pragma once
#include <cstdint>
#include <vector>

#include "sectorgen/sectors/tours/walk_mesh.hpp"

/// What is seen from a place over the ground one walks on.
namespace vicus {

/// A side of a triangle that is looked through, into that triangle.
struct SidePassed {
  std::uint32_t triangle = 0;
  int side = 0;
};

/// Exact: rays have whole-number directions, touching is seeing. One per thread.
/// Cost    sides looked through: some 60 ns each.
/// Source  Bungiu et al., "Efficient computation of visibility polygons", EuroCG 2014 (triangular expansion).
class Sight {
 public:
  explicit Sight(const WalkMesh& walk);

  /// All corners (points of the mesh) seen from p. `standing`: the triangles at p.
  void look_round(PlanPoint p, const std::vector<std::uint32_t>& standing);
  /// The same from a corner, in the directions that a walk which bends there can leave in. `t`, `j`: the triangle on
  /// the right of its ground, at its right wall, and the corner's number in it.
  void look_on(std::uint32_t t, int j);
  /// Those that a straight walk there touches and can bend at, each once, in no order.
  const std::vector<std::uint32_t>& corners() const { return corners_; }
  /// Those that it meets head on: it ends there.
  const std::vector<std::uint32_t>& met_head_on() const { return met_head_on_; }
  /// After look_round: is `goal` seen, which lies in these triangles? Tells of the last look only.
  void watch_for(PlanPoint goal, const std::vector<std::uint32_t>& goal_triangles);
  bool has_seen_goal() const { return has_seen_goal_; }

  /// The sides passed straight from p to a goal that is seen from it; none: both are in one triangle.
  /// Needs   `goal` is seen from p, out of one of `from` and into one of `to`.
  std::vector<SidePassed> way_to(PlanPoint p, const std::vector<std::uint32_t>& from, PlanPoint goal,
                                 const std::vector<std::uint32_t>& to);

 private:
  struct Ray {
    std::int64_t x = 0, y = 0;
  };
  struct Look {
    std::uint32_t triangle = 0, before = kNone;
    int side = 0;
    Ray right, left;
  };
  static std::int64_t cross(Ray a, Ray b) { return a.x * b.y - a.y * b.x; }
  /// Up to half a turn counter-clockwise from a to b, and not none.
  static bool is_before(Ray a, Ray b) {
    const std::int64_t side = cross(a, b);
    return side > 0 || (side == 0 && a.x * b.x + a.y * b.y < 0);
  }
  Ray ray_to(PlanPoint p) const { return {std::int64_t{p.x} - root_.x, std::int64_t{p.y} - root_.y}; }
  void begin(PlanPoint root);
  void touch(std::uint32_t t, int k);
  void pass(std::uint32_t t, int side, Ray right, Ray left, std::uint32_t before);
  bool expand(std::uint32_t index);
  void look_all();

  const WalkMesh& walk_;
  PlanPoint root_, goal_;
  std::vector<std::uint32_t> goal_triangles_;
  bool has_goal_ = false, is_narrow_ = false, has_seen_goal_ = false;
  std::vector<Look> looks_;
  std::vector<std::uint32_t> corners_, met_head_on_;
  std::vector<std::uint32_t> listed_;  // per point: the look that listed it
  std::uint32_t look_ = 0;
};

}  // namespace vicus
