#include "city_db/roof_blob.hpp"

#include <bit>
#include <cstdlib>

namespace vicus {
namespace {

void append_u32(std::string& out, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<char>((value >> shift) & 0xff));
}

void append_list(std::string& out, const std::vector<std::uint32_t>& list) {
  append_u32(out, static_cast<std::uint32_t>(list.size()));
  for (const std::uint32_t i : list) append_u32(out, i);
}

/// Takes numbers from the front; after the first that is not there, `is_good` is false and all others are 0.
class ByteSource {
 public:
  explicit ByteSource(std::string_view bytes) : bytes_(bytes) {}

  std::uint32_t u32() {
    if (bytes_.size() < 4) return is_good = false, 0;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<std::uint8_t>(bytes_[i])} << (8 * i);
    bytes_.remove_prefix(4);
    return value;
  }
  std::int32_t i32() { return std::bit_cast<std::int32_t>(u32()); }
  /// A count of things of at least `size` bytes each: never more than there are bytes for.
  std::uint32_t count(std::size_t size) {
    const std::uint32_t n = u32();
    if (n > bytes_.size() / size) return is_good = false, 0;
    return n;
  }
  std::vector<std::uint32_t> list(std::size_t below) {
    std::vector<std::uint32_t> out(count(4));
    for (auto& i : out)
      if ((i = u32()) >= below) is_good = false;
    return out;
  }
  bool is_empty() const { return bytes_.empty(); }

  bool is_good = true;

 private:
  std::string_view bytes_;
};

}  // namespace

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
    if (kind > static_cast<std::uint32_t>(FacetKind::gable)) return std::nullopt;
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
