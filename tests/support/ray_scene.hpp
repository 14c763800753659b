#pragma once
#include <embree3/rtcore.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "city_db/city.hpp"

/// A city for Embree, as it is drawn: what a ray meets first, and who sends that.
namespace vicus::test {

inline constexpr std::uint32_t kNobody = 0xffffffffu;

/// What a triangle belongs to: a house's wall (the sector whose border it is, else the house's own), a roof (the
/// house's own sector), a sector's ground; nobody: a wall that stops sight.
struct Owner {
  std::uint32_t sector = kNobody, house = kNobody;
  bool is_wall = false;
};

struct Vec {
  float x, y, z;
};

/// With a terrain each house's own 0 is the ground's height at one of its corners, houses reach down for ever, and
/// neither the ground nor walls that stop sight are there.
///
/// Frame   metres from the middle of the city's box: 32-bit floats hold under 0.1 mm within 1 km.
class RayScene {
 public:
  explicit RayScene(const City& city);  ///< keeps a reference
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// What 16 rays from one point meet first, no farther than so many times `directions`; nobody where nothing.
  /// `distances`: of what they meet, in the same measure.
  void meet(Vec eye, const Vec* directions, Owner* found, float farthest = INFINITY, float* distances = nullptr) const;

  double x_of(PlanPoint p) const { return metres(std::int64_t{p.x} - middle().x); }
  double y_of(PlanPoint p) const { return metres(std::int64_t{p.y} - middle().y); }
  double zero_of(const Building& b) const;  ///< the height of the house's own 0
  double ground_at(double x, double y) const;

 private:
  struct Triangle3 {
    std::uint32_t a, b, c;
  };
  PlanPoint middle() const;
  std::uint32_t add_point(PlanPoint p, double up_m);
  void add_flat(const Polygon& polygon, const Triangles& triangles, double up_m, Owner owner);
  void add_roof(const Roof& roof, double zero_m, Owner owner);
  template <class OwnerOf>
  void add_walls(const Polygon& polygon, double low_m, double high_m, OwnerOf owner_of);
  void find_facades();
  void add_house(std::uint32_t h);
  void commit();

  const City& city_;
  bool is_flat_ = true;
  PlanBox box_;
  std::unordered_map<std::string, std::uint32_t> sectors_, houses_;
  std::map<std::pair<std::uint32_t, std::pair<PlanPoint, PlanPoint>>, std::uint32_t> facade_;
  std::vector<float> points_;
  std::vector<Triangle3> triangles_;
  std::vector<Owner> owners_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace vicus::test
