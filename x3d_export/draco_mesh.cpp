#include "x3d_export/draco_mesh.hpp"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <memory>

#include "city_db/issues.hpp"

namespace vicus {
namespace {

using Vec3 = std::array<float, 3>;
using Attribute = draco::GeometryAttribute;

Vec3 metres_of(const X3dPoint& p) {
  return {static_cast<float>(metres(p.x)), static_cast<float>(metres(p.y)), static_cast<float>(metres(p.z))};
}

Vec3 normal_of(const X3dPoint& a, const X3dPoint& b, const X3dPoint& c) {
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx, length = std::hypot(x, y, z);
  if (length == 0) return {0, 1, 0};
  return {static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)};
}

/// glTF's colours of vertices are linear.
std::uint8_t linear(std::uint8_t channel) {
  return static_cast<std::uint8_t>(std::lround(255 * linear_of_srgb(channel / 255.0)));
}

/// A fan of triangles over faces of 3 or 4 corners; `extra` gives each corner's colour or place.
class Builder {
 public:
  Builder(int triangles, Attribute::Type extra, int components, draco::DataType type) {
    builder_.Start(triangles);
    position_ = builder_.AddAttribute(Attribute::POSITION, 3, draco::DT_FLOAT32);
    normal_ = builder_.AddAttribute(Attribute::NORMAL, 3, draco::DT_FLOAT32);
    extra_ = builder_.AddAttribute(extra, static_cast<std::int8_t>(components), type);
  }

  template <class Extra>
  void add(const std::array<X3dPoint, 4>& corners, int count, const std::array<Extra, 4>& extras) {
    // A quad's first three corners may lie on one line; some three do not.
    Vec3 normal = normal_of(corners[0], corners[1], corners[2]);
    if (count == 4 && corners[0] == corners[1]) normal = normal_of(corners[0], corners[2], corners[3]);
    for (std::size_t k = 2; k < static_cast<std::size_t>(count); ++k) {
      const draco::FaceIndex face(faces_++);
      const std::array<std::size_t, 3> at{0, k - 1, k};
      std::array<Vec3, 3> points;
      for (std::size_t i = 0; i < 3; ++i) {
        box_.add(corners[at[i]]);
        points[i] = metres_of(corners[at[i]]);
      }
      builder_.SetAttributeValuesForFace(position_, face, &points[0], &points[1], &points[2]);
      builder_.SetAttributeValuesForFace(normal_, face, &normal, &normal, &normal);
      builder_.SetAttributeValuesForFace(extra_, face, &extras[at[0]], &extras[at[1]], &extras[at[2]]);
    }
  }

  DracoMesh coded(const LatticeBox& lattice) {
    const std::unique_ptr<draco::Mesh> mesh = builder_.Finalize();
    if (!mesh) throw CityError("a mesh could not be made for Draco: out of memory");
    constexpr int kNormalBits = 8, kPlaceBits = 16, kSpeed = 3;
    draco::Encoder encoder;
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    encoder.SetSpeedOptions(kSpeed, kSpeed);
    encoder.SetTrackEncodedProperties(true);
    const auto extent = static_cast<unsigned>(
        std::max({lattice.max.x - lattice.min.x, lattice.max.y - lattice.min.y, lattice.max.z - lattice.min.z, 1}));
    const int bits = std::bit_width(extent);
    const Vec3 origin = metres_of(lattice.min);
    const auto range = static_cast<float>(((1u << bits) - 1u) / kMmPerMetre);  // one step, one millimetre
    encoder.SetAttributeExplicitQuantization(Attribute::POSITION, bits, 3, origin.data(), range);
    encoder.SetAttributeQuantization(Attribute::NORMAL, kNormalBits);
    encoder.SetAttributeQuantization(Attribute::TEX_COORD, kPlaceBits);
    draco::EncoderBuffer buffer;
    if (const draco::Status status = encoder.EncodeMeshToBuffer(*mesh, &buffer); !status.ok())
      throw CityError("Draco cannot code a mesh: " + status.error_msg_string());
    return {{buffer.data(), buffer.size()},
            static_cast<std::uint32_t>(encoder.num_encoded_points()),
            static_cast<std::uint32_t>(encoder.num_encoded_faces()),
            mesh->attribute(position_)->unique_id(),
            mesh->attribute(normal_)->unique_id(),
            mesh->attribute(extra_)->unique_id(),
            box_};
  }

 private:
  draco::TriangleSoupMeshBuilder builder_;
  int position_ = 0, normal_ = 0, extra_ = 0;
  std::uint32_t faces_ = 0;
  LatticeBox box_{{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
};

}  // namespace

void LatticeBox::add(const X3dPoint& p) {
  min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
  max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
}

DracoMesh draco_mesh(std::span<const Face> faces, const LatticeBox& lattice) {
  assert(!faces.empty());
  int triangles = 0;
  for (const Face& face : faces) triangles += face.count - 2;
  Builder builder(triangles, Attribute::COLOR, 4, draco::DT_UINT8);
  for (const Face& face : faces) {
    using Rgba = std::array<std::uint8_t, 4>;
    const Rgba rgba{linear(face.colour.r), linear(face.colour.g), linear(face.colour.b), 255};
    builder.add(face.corners, face.count, std::array<Rgba, 4>{rgba, rgba, rgba, rgba});
  }
  return builder.coded(lattice);
}

DracoMesh draco_mesh(std::span<const TexturedFace> faces, const LatticeBox& lattice) {
  assert(!faces.empty());
  Builder builder(static_cast<int>(2 * faces.size()), Attribute::TEX_COORD, 2, draco::DT_FLOAT32);
  for (const TexturedFace& face : faces) {
    std::array<std::array<float, 2>, 4> places;
    for (std::size_t k = 0; k < 4; ++k)
      places[k] = {static_cast<float>(face.uv[k][0]), static_cast<float>(1 - face.uv[k][1])};
    builder.add(face.corners, 4, places);
  }
  return builder.coded(lattice);
}

}  // namespace vicus
