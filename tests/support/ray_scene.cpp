#include "tests/support/ray_scene.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "city_db/terrain.hpp"

namespace vicus::test {
namespace {

constexpr double kDeep_m = -1000;
constexpr double kStops_m = 2.5;  // walls that stop sight are in the scene, but nobody's

}  // namespace

RayScene::RayScene(const City& city) : city_(city) {
  for (std::uint32_t s = 0; s < city.sectors.size(); ++s) sectors_.emplace(city.sectors[s].id, s);
  for (std::uint32_t h = 0; h < city.buildings.size(); ++h) houses_.emplace(city.buildings[h].id, h);
  for (const auto& s : city.sectors)
    for (const PlanPoint p : s.ground.outer) box_.add(p);
  is_flat_ = city.terrain.height_mm.empty();
  for (std::uint32_t s = 0; is_flat_ && s < city.sectors.size(); ++s)
    add_flat(city.sectors[s].ground, city.sectors[s].ground_triangles, 0, {s, kNobody, false});
  find_facades();
  for (std::uint32_t h = 0; h < city.buildings.size(); ++h) add_house(h);
  for (const auto& o : city.obstacles)
    if (is_flat_ && o.height_m > kStops_m)
      add_walls(o.area, 0, o.height_m, [](PlanPoint, PlanPoint) { return Owner{}; });
  commit();
}

RayScene::~RayScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void RayScene::commit() {
  device_ = rtcNewDevice("threads=1");
  scene_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                             3 * sizeof(float), points_.size() / 3));
  std::copy(points_.begin(), points_.end(), points);
  auto* triangles = static_cast<Triangle3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle3), triangles_.size()));
  std::copy(triangles_.begin(), triangles_.end(), triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
  if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree cannot hold the city");
}

double RayScene::zero_of(const Building& b) const {
  const auto& ring = b.footprint.outer;
  return height_m(city_.terrain, ring[ring.size() / 2]);
}

double RayScene::ground_at(double x, double y) const {
  const auto mm = [](double m, std::int32_t from) {
    return from + static_cast<std::int32_t>(std::lround(m * kMmPerMetre));
  };
  return height_m(city_.terrain, {mm(x, middle().x), mm(y, middle().y)});
}

PlanPoint RayScene::middle() const {
  return {static_cast<std::int32_t>((std::int64_t{box_.min.x} + box_.max.x) / 2),
          static_cast<std::int32_t>((std::int64_t{box_.min.y} + box_.max.y) / 2)};
}

std::uint32_t RayScene::add_point(PlanPoint p, double up_m) {
  for (const double v : {x_of(p), y_of(p), up_m}) points_.push_back(static_cast<float>(v));
  return static_cast<std::uint32_t>(points_.size() / 3 - 1);
}

void RayScene::add_flat(const Polygon& polygon, const Triangles& triangles, double up_m, Owner owner) {
  std::vector<std::uint32_t> at;
  for (const PlanPoint p : polygon.outer) at.push_back(add_point(p, up_m));
  for (const auto& hole : polygon.holes)
    for (const PlanPoint p : hole) at.push_back(add_point(p, up_m));
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    triangles_.push_back({at[triangles[i]], at[triangles[i + 1]], at[triangles[i + 2]]});
    owners_.push_back(owner);
  }
}

void RayScene::add_roof(const Roof& roof, double zero_m, Owner owner) {
  std::vector<std::uint32_t> at;
  for (const auto& p : roof.points) at.push_back(add_point(p.at, zero_m + p.up / kRoofStepsPerMetre));
  for (const auto& facet : roof.facets)
    for (std::size_t i = 0; i + 2 < facet.triangles.size(); i += 3) {
      triangles_.push_back({at[facet.triangles[i]], at[facet.triangles[i + 1]], at[facet.triangles[i + 2]]});
      owners_.push_back(owner);
    }
}

template <class OwnerOf>
void RayScene::add_walls(const Polygon& polygon, double low_m, double high_m, OwnerOf owner_of) {
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      const auto p = add_point(a, low_m), q = add_point(b, low_m), r = add_point(b, high_m), s = add_point(a, high_m);
      triangles_.push_back({p, q, r});
      triangles_.push_back({p, r, s});
      owners_.insert(owners_.end(), 2, owner_of(a, b));
    }
  };
  add(polygon.outer);
  for (const auto& hole : polygon.holes) add(hole);
}

void RayScene::find_facades() {
  for (const auto& border : city_.borders)
    if (border.kind == BorderKind::facade)
      for (std::size_t i = 0; i + 1 < border.line.size(); ++i)
        facade_[{houses_.at(border.building_id), {border.line[i + 1], border.line[i]}}] = sectors_.at(border.sector_id);
}

void RayScene::add_house(std::uint32_t h) {
  const Building& b = city_.buildings[h];
  const auto own = sectors_.find(b.sector_id);
  const std::uint32_t sector = own == sectors_.end() ? kNobody : own->second;
  const double zero = zero_of(b), top = zero + (b.eave_m > b.base_m ? b.eave_m : b.height_m);  // as it is drawn
  add_roof(b.roof, zero, {sector, h, false});
  add_walls(b.footprint, is_flat_ ? b.base_m : kDeep_m, top, [&](PlanPoint from, PlanPoint to) {
    const auto facade = facade_.find({h, {from, to}});
    return Owner{facade == facade_.end() ? sector : facade->second, h, true};
  });
}

void RayScene::meet(Vec eye, const Vec* directions, Owner* found, float farthest, float* distances) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) RTCRayHit16 packet;
  alignas(64) int valid[16];
  for (int i = 0; i < 16; ++i) {
    valid[i] = -1;
    packet.ray.org_x[i] = eye.x, packet.ray.org_y[i] = eye.y, packet.ray.org_z[i] = eye.z;
    packet.ray.dir_x[i] = directions[i].x, packet.ray.dir_y[i] = directions[i].y, packet.ray.dir_z[i] = directions[i].z;
    packet.ray.tnear[i] = 0, packet.ray.tfar[i] = farthest;
    packet.ray.mask[i] = ~0U, packet.ray.flags[i] = 0, packet.ray.time[i] = 0, packet.ray.id[i] = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect16(valid, scene_, &context, &packet);
  for (int i = 0; i < 16; ++i) {
    found[i] = packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? Owner{} : owners_[packet.hit.primID[i]];
    if (distances != nullptr) distances[i] = packet.ray.tfar[i];
  }
}

}  // namespace vicus::test
