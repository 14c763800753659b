#include "tests/support/flight.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "city_db/surface_colour.hpp"
#include "city_db/surroundings.hpp"
#include "city_db/terrain.hpp"
#include "sectorgen/bake/ground_colours.hpp"

namespace vicus::test {
namespace {

constexpr double kHalfAngle = 22.5 * std::numbers::pi / 180;

void normalise(double (&v)[3]) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (double& c : v) c /= length;
}

double nearest_on_triangle(const double (&p)[3], const float* a, const float* b, const float* c) {
  // Ericson, "Real-Time Collision Detection", §5.1.5.
  double ab[3], ac[3], ap[3], bp[3], cp[3];
  for (int i = 0; i < 3; ++i) {
    ab[i] = double(b[i]) - a[i], ac[i] = double(c[i]) - a[i];
    ap[i] = p[i] - a[i], bp[i] = p[i] - b[i], cp[i] = p[i] - c[i];
  }
  const auto dot = [](const double* u, const double* v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; };
  const auto to = [&](double v, double w) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double d = ap[i] - v * ab[i] - w * ac[i];
      sum += d * d;
    }
    return std::sqrt(sum);
  };
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return to(0, 0);
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return to(1, 0);
  if (const double vc = d1 * d4 - d3 * d2; vc <= 0 && d1 >= 0 && d3 <= 0) return to(d1 / (d1 - d3), 0);
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return to(0, 1);
  if (const double vb = d5 * d2 - d1 * d6; vb <= 0 && d2 >= 0 && d6 <= 0) return to(0, d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / (d4 - d3 + d5 - d6);
    return to(1 - w, w);
  }
  const double vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2, sum = va + vb + vc;
  return sum > 0 ? to(vb / sum, vc / sum) : to(0, 0);
}

}  // namespace

PlanRay Camera::ray(double column, double row) const {
  const double scale = std::tan(kHalfAngle) / (height / 2.0);
  const double a = (column - width / 2.0) * scale, b = (height / 2.0 - row) * scale;
  PlanRay r{x, y, z, 0, 0, 0};
  double d[3];
  for (int i = 0; i < 3; ++i) d[i] = forward[i] + a * right[i] + b * up[i];
  normalise(d);
  r.dx = d[0], r.dy = d[1], r.dz = d[2];
  return r;
}

double Camera::pixels_per_radian() const { return height / 2.0 / std::tan(kHalfAngle); }

Camera camera_at(double x, double y, double z, double to_x, double to_y, double to_z, int width, int height) {
  Camera c;
  c.x = x, c.y = y, c.z = z;
  c.width = width, c.height = height;
  c.forward[0] = to_x - x, c.forward[1] = to_y - y, c.forward[2] = to_z - z;
  normalise(c.forward);
  c.right[0] = c.forward[1], c.right[1] = -c.forward[0], c.right[2] = 0;
  normalise(c.right);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    c.up[i] = c.right[j] * c.forward[k] - c.right[k] * c.forward[j];
  }
  return c;
}

Camera camera_around(double x, double y, double up, double distance, double elevation_deg, double azimuth_deg,
                     int width, int height) {
  const double e = elevation_deg * std::numbers::pi / 180, a = azimuth_deg * std::numbers::pi / 180;
  return camera_at(x + distance * std::cos(e) * std::sin(a), y + distance * std::cos(e) * std::cos(a),
                   up + distance * std::sin(e), x, y, up, width, height);
}

Colour lit(const HitLook& look, bool with_ambient) {
  constexpr double kDarkest = 0.45;  // as the shader has it
  const double light = look.is_lit ? 1 : light_on(look.east, look.north, look.up);
  return rounded(mean_of(look.colour) * (light * (with_ambient ? kDarkest + (1 - kDarkest) * look.ambient : 1)));
}

RgbImage picture_of(const View& view, bool with_ambient) {
  RgbImage image(static_cast<std::uint32_t>(view.width), static_cast<std::uint32_t>(view.height));
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    const Seen& s = view.pixels[i];
    image.set(i % image.width, i / image.width, std::isinf(s.t) ? kSky : lit(s.look, with_ambient));
  }
  return image;
}

void write_png(const std::filesystem::path& path, const RgbImage& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = image.width;
  png.height = image.height;
  png.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&png, path.c_str(), 0, image.rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error("cannot write " + path.string());
}

/// What a triangle belongs to: a wall, a roof plane, or ground of a colour.
struct TrueCity::Face {
  std::int32_t house = -1, wall = -1, plane = -1;
  Colour ground;
};

TrueCity::TrueCity(const BakeScene& scene, const PlanBox& box) : scene_(scene) {
  middle_x_ = metres((std::int64_t{box.min.x} + box.max.x) / 2);
  middle_y_ = metres((std::int64_t{box.min.y} + box.max.y) / 2);
  for (const std::uint32_t i : scene.houses_in(box)) add_house(i);
  add_ground(box);
  commit();
}

TrueCity::~TrueCity() {
  rtcReleaseScene(scene3_);
  rtcReleaseDevice(device_);
}

std::uint32_t TrueCity::add_point(double x, double y, double z) {
  for (const double v : {x - middle_x_, y - middle_y_, z}) points_.push_back(static_cast<float>(v));
  return static_cast<std::uint32_t>(points_.size() / 3 - 1);
}

void TrueCity::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t face) {
  triangles_.push_back({a, b, c});
  face_of_.push_back(face);
}

void TrueCity::add_house(std::uint32_t index) {
  const BakeHouse& house = scene_.houses()[index];
  std::vector<std::uint32_t> plane_face;
  for (std::size_t p = 0; p < house.planes.size(); ++p) {
    plane_face.push_back(static_cast<std::uint32_t>(faces_.size()));
    faces_.push_back({static_cast<std::int32_t>(index), -1, static_cast<std::int32_t>(p), {}});
  }
  std::vector<double> top(house.walls.size() * 2, -1e9);
  for (const BakeTriangle& t : house.roof) {
    std::uint32_t at[3];
    for (int k = 0; k < 3; ++k) {
      const double up = house.planes[t.plane].at(t.x[k], t.y[k]);
      at[k] = add_point(t.x[k], t.y[k], up);
      for (std::size_t w = 0; w < house.walls.size(); ++w) {
        const BakeWall& wall = house.walls[w];
        if (t.x[k] == wall.ax && t.y[k] == wall.ay) top[2 * w] = std::max(top[2 * w], up);
        if (t.x[k] == wall.bx && t.y[k] == wall.by) top[2 * w + 1] = std::max(top[2 * w + 1], up);
      }
    }
    add_triangle(at[0], at[1], at[2], plane_face[t.plane]);
  }
  for (std::size_t w = 0; w < house.walls.size(); ++w) {
    const BakeWall& wall = house.walls[w];
    const auto face = static_cast<std::uint32_t>(faces_.size());
    faces_.push_back({static_cast<std::int32_t>(index), static_cast<std::int32_t>(w), -1, {}});
    const double low = std::min(height_m(scene_.terrain(), {lattice_mm(wall.ax), lattice_mm(wall.ay)}),
                                height_m(scene_.terrain(), {lattice_mm(wall.bx), lattice_mm(wall.by)})) -
                       0.05;
    const double ha = top[2 * w] > -1e8 ? top[2 * w] : house.top_m,
                 hb = top[2 * w + 1] > -1e8 ? top[2 * w + 1] : house.top_m;
    const auto p = add_point(wall.ax, wall.ay, low), q = add_point(wall.bx, wall.by, low),
               r = add_point(wall.bx, wall.by, hb), s = add_point(wall.ax, wall.ay, ha);
    add_triangle(p, q, r, face);
    add_triangle(p, r, s, face);
    // A gable: where the roof stands higher between the corners.
    for (const BakeTriangle& t : house.roof)
      for (int k = 0; k < 3; ++k) {
        const double dx = wall.bx - wall.ax, dy = wall.by - wall.ay, length2 = dx * dx + dy * dy;
        const double along = ((t.x[k] - wall.ax) * dx + (t.y[k] - wall.ay) * dy) / length2;
        const double off = ((t.x[k] - wall.ax) * dy - (t.y[k] - wall.ay) * dx) / std::sqrt(length2);
        if (along < 1e-6 || along > 1 - 1e-6 || std::abs(off) > 0.005) continue;
        add_triangle(s, r, add_point(t.x[k], t.y[k], house.planes[t.plane].at(t.x[k], t.y[k])), face);
      }
  }
}

void TrueCity::add_ground(const PlanBox& box) {
  const auto square = [&](double west, double south, double east, double north, std::uint32_t face) {
    const auto up = [&](double x, double y) { return height_m(scene_.terrain(), {lattice_mm(x), lattice_mm(y)}); };
    const auto a = add_point(west, south, up(west, south)), b = add_point(east, south, up(east, south)),
               c = add_point(east, north, up(east, north)), d = add_point(west, north, up(west, north));
    add_triangle(a, b, c, face);
    add_triangle(a, c, d, face);
  };
  const auto bare = static_cast<std::uint32_t>(faces_.size());
  faces_.push_back({-1, -1, -1, kBeyondCity});
  const double below = scene_.terrain().height_mm.empty() ? 0.002 : 0;
  if (below > 0) {
    const auto a = add_point(metres(box.min.x), metres(box.min.y), -below),
               b = add_point(metres(box.max.x), metres(box.min.y), -below),
               c = add_point(metres(box.max.x), metres(box.max.y), -below),
               d = add_point(metres(box.min.x), metres(box.max.y), -below);
    add_triangle(a, b, c, bare);
    add_triangle(a, c, d, bare);
    for (const std::uint32_t i : scene_.ground_in(box)) {
      const BakeGround& g = scene_.ground()[i];
      const auto face = static_cast<std::uint32_t>(faces_.size());
      faces_.push_back({-1, -1, -1, surface_colour(g.kind)});
      const auto add = [&](PlanPoint p) { return add_point(metres(p.x), metres(p.y), 0); };
      add_triangle(add(g.at[0]), add(g.at[1]), add(g.at[2]), face);
    }
    return;
  }
  const double step = metres(scene_.terrain().step_mm);
  for (double y = metres(box.min.y); y < metres(box.max.y); y += step)
    for (double x = metres(box.min.x); x < metres(box.max.x); x += step) square(x, y, x + step, y + step, bare);
}

void TrueCity::commit() {
  device_ = rtcNewDevice("threads=1");
  scene3_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene3_, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                             3 * sizeof(float), points_.size() / 3));
  std::copy(points_.begin(), points_.end(), points);
  auto* triangles = static_cast<std::array<std::uint32_t, 3>*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles_.size()));
  std::copy(triangles_.begin(), triangles_.end(), triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene3_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene3_);
  if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree cannot hold the city");
}

Seen TrueCity::see(const PlanRay& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit hit{};
  hit.ray.org_x = static_cast<float>(ray.x - middle_x_);
  hit.ray.org_y = static_cast<float>(ray.y - middle_y_);
  hit.ray.org_z = static_cast<float>(ray.z);
  hit.ray.dir_x = static_cast<float>(ray.dx);
  hit.ray.dir_y = static_cast<float>(ray.dy);
  hit.ray.dir_z = static_cast<float>(ray.dz);
  hit.ray.tfar = std::numeric_limits<float>::infinity();
  hit.ray.mask = ~0u;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene3_, &context, &hit);
  Seen out;
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return out;
  out.t = double{hit.ray.tfar};
  const Face& face = faces_[face_of_[hit.hit.primID]];
  if (face.house < 0) {
    out.look.colour = face.ground;
    return out;
  }
  const BakeHouse& house = scene_.houses()[static_cast<std::size_t>(face.house)];
  if (face.plane >= 0) {
    const UpPlane& plane = house.planes[static_cast<std::size_t>(face.plane)];
    const double length = std::sqrt(plane.east * plane.east + plane.north * plane.north + 1);
    out.look = {house.roof_colour, -plane.east / length, -plane.north / length, 1 / length, 1, false};
    return out;
  }
  const BakeWall& wall = house.walls[static_cast<std::size_t>(face.wall)];
  const double dx = wall.bx - wall.ax, dy = wall.by - wall.ay, length = std::hypot(dx, dy);
  const double x = ray.x + out.t * ray.dx, y = ray.y + out.t * ray.dy, z = ray.z + out.t * ray.dz;
  out.look = {house.wall_colour, dy / length, -dx / length, 0, 1, false};
  if (wall.facade >= 0) {
    const BakeFacade& f = house.facades[static_cast<std::size_t>(wall.facade)];
    const double along = std::clamp(((x - wall.ax) * dx + (y - wall.ay) * dy) / (length * length), 0.0, 1.0);
    const double u = (wall.from_m + along * (wall.to_m - wall.from_m)) * f.repeats / f.length_m;
    if (f.picture && z >= f.bottom_m && z <= f.top_m)
      out.look.colour = rounded(f.picture->at(u, (z - f.bottom_m) / (f.top_m - f.bottom_m)));
  }
  return out;
}

View TrueCity::view(const Camera& camera) const {
  View out{camera.width, camera.height, {}};
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column)
      out.pixels.push_back(see(camera.ray(column + 0.5, row + 0.5)));
  return out;
}

double TrueCity::distance(double x, double y, double z, double reach) const {
  struct Query {
    const TrueCity* city;
    double at[3];
    double best;
  } query{this, {x - middle_x_, y - middle_y_, z}, reach};
  RTCPointQuery point;
  point.x = static_cast<float>(query.at[0]);
  point.y = static_cast<float>(query.at[1]);
  point.z = static_cast<float>(query.at[2]);
  point.radius = static_cast<float>(reach);
  point.time = 0;
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(
      scene3_, &point, &context,
      [](RTCPointQueryFunctionArguments* args) {
        auto* q = static_cast<Query*>(args->userPtr);
        const auto& t = q->city->triangles_[args->primID];
        const auto& p = q->city->points_;
        const double d = nearest_on_triangle(q->at, &p[3 * t[0]], &p[3 * t[1]], &p[3 * t[2]]);
        if (d >= q->best) return false;
        q->best = d;
        args->query->radius = static_cast<float>(d);
        return true;
      },
      &query);
  return query.best;
}

DrawnTile::DrawnTile(BlockMap baked)
    : map(std::make_unique<BlockMap>(std::move(baked))), caster(*map), colours(*map, tile_pictures(*map).value()) {}

View view_of(const std::vector<std::unique_ptr<DrawnTile>>& tiles, const Camera& camera) {
  View out{camera.width, camera.height, {}};
  out.pixels.resize(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      const PlanRay ray = camera.ray(column + 0.5, row + 0.5);
      Seen& seen = out.pixels[static_cast<std::size_t>(row * camera.width + column)];
      CastHit best;
      const DrawnTile* from = nullptr;
      for (const auto& tile : tiles)
        if (const CastHit hit = tile->caster.cast(ray, best.t); hit && hit.t < best.t) best = hit, from = tile.get();
      if (!from) continue;
      seen.t = best.t;
      seen.look = from->colours.look(ray, best);
    }
  return out;
}

}  // namespace vicus::test
