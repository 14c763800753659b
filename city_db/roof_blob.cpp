#include "city_db/roof_blob.hpp"

#include <bit>
#include <cstdlib>

#include "city_db/byte_source.hpp"

namespace vicus {
std::string encode_roof(const Roof& roof) {
  std::string out;
  append_u32(out, static_cast<std::uint32_t>(roof.points.size()));
  for (const auto& p : roof.points)
    for (const std::int32_t v : {p.at.x, p.at.y, p.up}) append_u32(out, std::bit_cast<std::uint32_t>(v));
  append_u32(out, static_cast<std::uint32_t>(roof.facets.size()));
  for (const auto& facet : roof.facets) {
    append_u32(out, static_cast<std::uint32_t>(facet.kind));
    append_u32(out, static_cast<std::uint32_t>(facet.rings.size()));
    for (const auto& ring : facet.rings) append_list(out, ring);
    append_list(out, facet.triangles);
  }
  return out;
}

std::optional<Roof> decode_roof(std::string_view bytes) {
  ByteSource source(bytes);
  Roof roof;
  roof.points.resize(source.count(12));
  for (auto& p : roof.points) {
    p = {{source.i32(), source.i32()}, source.i32()};
    for (const std::int64_t v : {p.at.x, p.at.y, p.up})
      if (std::abs(v) >= kPlanLimit) source.is_good = false;
  }
  roof.facets.resize(source.count(12));
  for (auto& facet : roof.facets) {
    const std::uint32_t kind = source.u32();
    if (kind > static_cast<std::uint32_t>(FacetKind::step)) return std::nullopt;
    facet.kind = static_cast<FacetKind>(kind);
    facet.rings.resize(source.count(4));
    for (auto& ring : facet.rings) {
      ring = source.list(roof.points.size());
      if (ring.size() < 3) return std::nullopt;
    }
    facet.triangles = source.list(roof.points.size());
    if (!source.is_good || facet.rings.empty() || facet.triangles.size() % 3 != 0) return std::nullopt;
  }
  if (!source.is_good || !source.is_empty()) return std::nullopt;
  return roof;
}

}  // namespace vicus
