#include "x3d_export/meshopt_mesh.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <vector>

#include "x3d_export/face_points.hpp"

namespace vicus {
namespace {

/// One corner of a triangle, as its streams have it.
template <class Extra>
struct Corner {
  std::array<std::uint16_t, 4> position{};
  std::array<std::int8_t, 4> normal{};
  Extra extra{};
};

template <class Value>
std::string coded_stream(const std::vector<Value>& values) {
  std::string out(meshopt_encodeVertexBufferBound(values.size(), sizeof(Value)), '\0');
  out.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(), values.data(),
                                        values.size(), sizeof(Value)));
  return out;
}

template <class Extra>
class Builder {
 public:
  Builder(const LatticeBox& lattice, std::uint32_t step_mm) : lattice_(lattice), step_mm_(step_mm) {}

  void add(const std::array<X3dPoint, 4>& corners, int count, const std::array<Extra, 4>& extras) {
    const auto normal = face_normal(corners, count);
    Corner<Extra> corner;
    for (std::size_t i = 0; i < 3; ++i) corner.normal[i] = static_cast<std::int8_t>(std::lround(127 * normal[i]));
    for (std::size_t k = 2; k < static_cast<std::size_t>(count); ++k)
      for (const std::size_t at : {std::size_t{0}, k - 1, k}) {
        corner.position = {steps(corners[at].x, lattice_.min.x), steps(corners[at].y, lattice_.min.y),
                           steps(corners[at].z, lattice_.min.z), 0};
        corner.extra = extras[at];
        corners_.push_back(corner);
      }
  }

  MeshoptMesh coded() const {
    static_assert(sizeof(Corner<Extra>) == 12 + sizeof(Extra),
                  "no bytes between the fields: equal corners are found by bytes");
    const std::size_t count = corners_.size();
    std::vector<unsigned> remap(count), indices(count);
    const std::size_t points =
        meshopt_generateVertexRemap(remap.data(), nullptr, count, corners_.data(), count, sizeof(Corner<Extra>));
    meshopt_remapIndexBuffer(indices.data(), nullptr, count, remap.data());
    std::vector<Corner<Extra>> unique(points);
    meshopt_remapVertexBuffer(unique.data(), corners_.data(), count, sizeof(Corner<Extra>), remap.data());
    meshopt_optimizeVertexCacheStrip(indices.data(), indices.data(), count, points);
    std::vector<Corner<Extra>> ordered(points);
    meshopt_optimizeVertexFetch(ordered.data(), indices.data(), count, unique.data(), points, sizeof(Corner<Extra>));
    MeshoptMesh out;
    out.points = static_cast<std::uint32_t>(points);
    out.triangles = static_cast<std::uint32_t>(count / 3);
    out.extra_stride = sizeof(Extra);
    std::vector<std::array<std::uint16_t, 4>> positions;
    std::vector<std::array<std::int8_t, 4>> normals;
    std::vector<Extra> extras;
    out.least = {65535, 65535, 65535};
    for (const Corner<Extra>& c : ordered) {
      positions.push_back(c.position);
      normals.push_back(c.normal);
      extras.push_back(c.extra);
      for (std::size_t i = 0; i < 3; ++i) {
        out.least[i] = std::min(out.least[i], c.position[i]);
        out.most[i] = std::max(out.most[i], c.position[i]);
      }
    }
    out.positions = coded_stream(positions);
    out.normals = coded_stream(normals);
    out.extras = coded_stream(extras);
    out.indices.resize(meshopt_encodeIndexBufferBound(count, points));
    out.indices.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(out.indices.data()),
                                                 out.indices.size(), indices.data(), count));
    return out;
  }

 private:
  std::uint16_t steps(std::int32_t mm, std::int32_t least_mm) const {
    assert(mm >= least_mm);
    return static_cast<std::uint16_t>((std::int64_t{mm} - least_mm + step_mm_ / 2) / step_mm_);
  }

  LatticeBox lattice_;
  std::uint32_t step_mm_;
  std::vector<Corner<Extra>> corners_;
};

}  // namespace

std::uint32_t meshopt_step_mm(const LatticeBox& lattice, std::uint32_t wanted_mm) {
  constexpr std::int64_t kMostSteps = 65535;
  const std::int64_t extent =
      std::max({std::int64_t{lattice.max.x} - lattice.min.x, std::int64_t{lattice.max.y} - lattice.min.y,
                std::int64_t{lattice.max.z} - lattice.min.z});
  return static_cast<std::uint32_t>(std::max<std::int64_t>(std::max(1u, wanted_mm), extent / kMostSteps + 1));
}

MeshoptMesh meshopt_mesh(std::span<const Face> faces, const LatticeBox& lattice, std::uint32_t step_mm) {
  assert(!faces.empty());
  using Rgba = std::array<std::uint8_t, 4>;
  Builder<Rgba> builder(lattice, step_mm);
  for (const Face& face : faces) {
    const Rgba rgba = linear_rgba(face.colour);
    builder.add(face.corners, face.count, {rgba, rgba, rgba, rgba});
  }
  return builder.coded();
}

MeshoptMesh meshopt_mesh(std::span<const TexturedFace> faces, const LatticeBox& lattice, std::uint32_t step_mm) {
  assert(!faces.empty());
  Builder<std::array<float, 2>> builder(lattice, step_mm);
  for (const TexturedFace& face : faces) builder.add(face.corners, 4, gltf_places(face));
  return builder.coded();
}

}  // namespace vicus
