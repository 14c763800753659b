#include "sectorgen/bake/render/ray_scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "city_db/issues.hpp"

namespace vicus {
namespace {

struct Triple {
  unsigned a, b, c;
};

/// Behind a face seen from inside the ray goes on at the next larger number but for this share.
constexpr float kStep = 1e-6f;

}  // namespace

struct RayScene::Impl {
  explicit Impl(RenderMesh given) : mesh(std::move(given)) {
    device = rtcNewDevice("threads=1");
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    if (!mesh.triangles.empty()) add_triangles();
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) {
      release();
      throw CityError("the city cannot be made ready for rays: out of memory");
    }
  }
  ~Impl() { release(); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void release() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  void add_triangles() {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.points.size()));
    auto* indices = static_cast<Triple*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 sizeof(Triple), mesh.triangles.size()));
    if (points != nullptr && indices != nullptr) {
      for (const auto& p : mesh.points) points = std::copy(p.begin(), p.end(), points);
      for (const auto& t : mesh.triangles) *indices++ = {t.corners[0], t.corners[1], t.corners[2]};
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene, geometry);
    }
    rtcReleaseGeometry(geometry);
  }

  bool shows(std::uint32_t triangle, const Vec3& way) const {
    const RenderTriangle& t = mesh.triangles[triangle];
    if (t.is_two_sided) return true;
    const auto corner = [&](std::size_t k) {
      const auto& p = mesh.points[t.corners[k]];
      return Vec3{p[0], p[1], p[2]};
    };
    const Vec3 a = corner(0);
    return dot(cross(corner(1) - a, corner(2) - a), way) < 0;
  }

  RenderMesh mesh;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
};

RayScene::RayScene(RenderMesh mesh) : impl_(std::make_unique<Impl>(std::move(mesh))) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

const RenderMesh& RayScene::mesh() const { return impl_->mesh; }

std::optional<RayScene::Hit> RayScene::first_hit(const Vec3& from, const Vec3& way, double least) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  const Vec3 start = from - impl_->mesh.origin;
  float near = static_cast<float>(least);
  for (;;) {
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(start[0]);
    ray.ray.org_y = static_cast<float>(start[1]);
    ray.ray.org_z = static_cast<float>(start[2]);
    ray.ray.dir_x = static_cast<float>(way[0]);
    ray.ray.dir_y = static_cast<float>(way[1]);
    ray.ray.dir_z = static_cast<float>(way[2]);
    ray.ray.tnear = near;
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(impl_->scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    if (impl_->shows(ray.hit.primID, way))
      return Hit{double{ray.ray.tfar}, ray.hit.primID, double{ray.hit.u}, double{ray.hit.v}};
    near = std::max(std::nextafter(ray.ray.tfar, std::numeric_limits<float>::infinity()), ray.ray.tfar * (1 + kStep));
  }
}

}  // namespace vicus
