#include "city_db/mesh_blob.hpp"

#include <cmath>
#include <cstdlib>

#include "city_db/byte_source.hpp"

namespace vicus {
namespace {

constexpr double kTicksPerSecond = 1000;

void append_i32(std::string& out, std::int32_t value) { append_u32(out, std::bit_cast<std::uint32_t>(value)); }

bool is_on_lattice(const GroundPoint& p) {
  for (const std::int64_t v : {p.at.x, p.at.y, p.up_mm})
    if (std::abs(v) >= kPlanLimit) return false;
  return true;
}

}  // namespace

std::string encode_mesh(const std::vector<GroundPoint>& points, const Triangles& triangles,
                        const std::vector<Colour>& colours) {
  std::string out;
  append_u32(out, static_cast<std::uint32_t>(points.size()));
  for (const auto& p : points)
    for (const std::int32_t v : {p.at.x, p.at.y, p.up_mm}) append_i32(out, v);
  append_list(out, triangles);
  append_u32(out, static_cast<std::uint32_t>(colours.size()));
  for (const auto& c : colours)
    append_u32(out, std::uint32_t{c.r} | std::uint32_t{c.g} << 8 | std::uint32_t{c.b} << 16);
  return out;
}

std::optional<Mesh3> decode_mesh(std::string_view bytes) {
  ByteSource source(bytes);
  Mesh3 mesh;
  mesh.points.resize(source.count(12));
  for (auto& p : mesh.points) {
    p = {{source.i32(), source.i32()}, source.i32()};
    if (!is_on_lattice(p)) return std::nullopt;
  }
  mesh.triangles = source.list(mesh.points.size());
  mesh.colours.resize(source.count(4));
  for (auto& c : mesh.colours) {
    const std::uint32_t v = source.u32();
    if (v >> 24 != 0) return std::nullopt;
    c = {static_cast<std::uint8_t>(v & 0xff), static_cast<std::uint8_t>(v >> 8 & 0xff),
         static_cast<std::uint8_t>(v >> 16)};
  }
  if (!source.is_good || !source.is_empty() || mesh.triangles.size() % 3 != 0) return std::nullopt;
  if (!mesh.colours.empty() && 3 * mesh.colours.size() != mesh.triangles.size()) return std::nullopt;
  return mesh;
}

std::string encode_ride(const std::vector<RidePoint>& points) {
  std::string out;
  append_u32(out, static_cast<std::uint32_t>(points.size()));
  for (const auto& p : points)
    for (const std::int32_t v :
         {p.at.x, p.at.y, lattice_mm(p.ground_m), static_cast<std::int32_t>(std::lround(p.time_s * kTicksPerSecond))})
      append_i32(out, v);
  return out;
}

std::optional<std::vector<RidePoint>> decode_ride(std::string_view bytes) {
  ByteSource source(bytes);
  std::vector<RidePoint> points(source.count(16));
  double before_s = 0;
  for (auto& p : points) {
    GroundPoint g{{source.i32(), source.i32()}, source.i32()};
    p = {g.at, metres(g.up_mm), source.i32() / kTicksPerSecond};
    if (!is_on_lattice(g) || p.time_s < before_s) return std::nullopt;
    before_s = p.time_s;
  }
  if (!source.is_good || !source.is_empty() || points.size() < 2) return std::nullopt;
  return points;
}

}  // namespace vicus
