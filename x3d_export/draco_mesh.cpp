#include "x3d_export/draco_mesh.hpp"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <memory>

#include "city_db/issues.hpp"
#include "x3d_export/face_points.hpp"

namespace vicus {
namespace {

using Vec3 = std::array<float, 3>;
using Attribute = draco::GeometryAttribute;

Vec3 metres_of(const X3dPoint& p) {
  return {static_cast<float>(metres(p.x)), static_cast<float>(metres(p.y)), static_cast<float>(metres(p.z))};
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
    const Vec3 normal = face_normal(corners, count);
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

  DracoMesh coded(const LatticeBox& lattice, std::uint32_t step_mm) {
    const std::unique_ptr<draco::Mesh> mesh = builder_.Finalize();
    if (!mesh) throw CityError("a mesh could not be made for Draco: out of memory");
    constexpr int kNormalBits = 8, kPlaceBits = 16, kSpeed = 3;
    draco::Encoder encoder;
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    encoder.SetSpeedOptions(kSpeed, kSpeed);
    encoder.SetTrackEncodedProperties(true);
    const auto extent = static_cast<unsigned>(
        std::max({lattice.max.x - lattice.min.x, lattice.max.y - lattice.min.y, lattice.max.z - lattice.min.z, 1}));
    const int bits = std::bit_width((extent + step_mm - 1) / step_mm);
    const Vec3 origin = metres_of(lattice.min);
    const auto range = static_cast<float>(((1u << bits) - 1u) * step_mm / kMmPerMetre);
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

DracoMesh draco_mesh(std::span<const Face> faces, const LatticeBox& lattice, std::uint32_t step_mm) {
  assert(!faces.empty() && step_mm > 0);
  int triangles = 0;
  for (const Face& face : faces) triangles += face.count - 2;
  Builder builder(triangles, Attribute::COLOR, 4, draco::DT_UINT8);
  for (const Face& face : faces) {
    using Rgba = std::array<std::uint8_t, 4>;
    const Rgba rgba = linear_rgba(face.colour);
    builder.add(face.corners, face.count, std::array<Rgba, 4>{rgba, rgba, rgba, rgba});
  }
  return builder.coded(lattice, step_mm);
}

DracoMesh draco_mesh(std::span<const TexturedFace> faces, const LatticeBox& lattice, std::uint32_t step_mm) {
  assert(!faces.empty() && step_mm > 0);
  Builder builder(static_cast<int>(2 * faces.size()), Attribute::TEX_COORD, 2, draco::DT_FLOAT32);
  for (const TexturedFace& face : faces) builder.add(face.corners, 4, gltf_places(face));
  return builder.coded(lattice, step_mm);
}

}  // namespace vicus
