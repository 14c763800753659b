#include "city_db/geometry_blob.hpp"
#include "city_db/boxes.hpp"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>

namespace vicus {
namespace {

// Header: 'G' 'P', version 0, flags, srs_id i32, envelope f64[], then WKB.
constexpr std::uint8_t kLittleEndian = 0x01, kEnvelopeXy = 0x02, kEmpty = 0x10, kExtended = 0x20;
constexpr std::size_t kHeaderBytes = 8;
// Number of f64 in the envelope, by bits 1-3 of the flags; 5 to 7 are invalid.
constexpr std::size_t kEnvelopeDoubles[] = {0, 4, 6, 6, 8};
enum WkbType : std::uint32_t { kWkbPoint = 1, kWkbLine = 2, kWkbPolygon = 3 };
/// A foreign writer may compute metres otherwise than mm / 1000: the last bits of a double, far below 1 um.
constexpr double kOffLatticeMm = 1e-3;

class BlobWriter {
 public:
  BlobWriter(WkbType type, const PlanBox& box) {
    bytes_ = {'G', 'P', 0};
    const bool has_envelope = type != kWkbPoint && !box.is_empty();
    u8(static_cast<std::uint8_t>(kLittleEndian | (has_envelope ? kEnvelopeXy : 0) | (box.is_empty() ? kEmpty : 0)));
    u32(static_cast<std::uint32_t>(kPlanSrsId));
    if (has_envelope)
      for (auto mm : {box.min.x, box.max.x, box.min.y, box.max.y}) f64(metres(mm));
    u8(1);
    u32(type);
  }
  void u32(std::uint32_t v) {
    for (int shift = 0; shift < 32; shift += 8) u8(static_cast<std::uint8_t>(v >> shift));
  }
  void point(PlanPoint p) {
    f64(metres(p.x));
    f64(metres(p.y));
  }
  std::string take() { return std::move(bytes_); }

 private:
  void u8(std::uint8_t v) { bytes_.push_back(static_cast<char>(v)); }
  void f64(double v) {
    const auto bits = std::bit_cast<std::uint64_t>(v);
    u32(static_cast<std::uint32_t>(bits));
    u32(static_cast<std::uint32_t>(bits >> 32));
  }
  std::string bytes_;
};

/// Reads hostile bytes: after the first fault everything reads as 0 and ok() stays false.
class BlobReader {
 public:
  explicit BlobReader(std::string_view blob) : rest_(blob) {
    if (rest_.size() < kHeaderBytes || rest_[0] != 'G' || rest_[1] != 'P' || rest_[2] != 0) {
      fail();
      return;
    }
    const auto flags = static_cast<std::uint8_t>(rest_[3]);
    const std::size_t envelope = (flags >> 1) & 7;
    if ((flags & kExtended) != 0 || envelope >= std::size(kEnvelopeDoubles)) {
      fail();
      return;
    }
    skip(kHeaderBytes + 8 * kEnvelopeDoubles[envelope]);
  }
  /// Byte order and type of the WKB.
  void expect(WkbType type) {
    const auto order = static_cast<std::uint8_t>(rest_.empty() ? '\x7f' : rest_[0]);
    if (order > 1) fail();
    skip(1);
    is_little_ = order == 1;
    if (u32() != type) fail();
  }
  /// A count of things that take at least `item_bytes` each.
  std::size_t count(std::size_t item_bytes) {
    const std::size_t n = u32();
    if (n > rest_.size() / item_bytes) fail();
    return ok_ ? n : 0;
  }
  PlanPoint point() {
    const std::int32_t x = lattice(), y = lattice();
    return {x, y};
  }
  bool ok() const { return ok_; }
  bool is_done() const { return ok_ && rest_.empty(); }
  void fail() {
    ok_ = false;
    rest_ = {};
  }

 private:
  void skip(std::size_t n) { n > rest_.size() ? fail() : rest_.remove_prefix(n); }
  std::uint64_t bits(std::size_t n) {
    std::uint64_t v = 0;
    if (n > rest_.size()) fail();
    if (!ok_) return 0;
    for (std::size_t i = 0; i < n; ++i)
      v |= std::uint64_t{static_cast<std::uint8_t>(rest_[is_little_ ? i : n - 1 - i])} << (8 * i);
    skip(n);
    return v;
  }
  std::uint32_t u32() { return static_cast<std::uint32_t>(bits(4)); }
  std::int32_t lattice() {
    const double mm = std::bit_cast<double>(bits(8)) * kMmPerMetre;
    if (!(std::abs(mm) < kPlanLimit)) {  // NaN as well
      fail();
      return 0;
    }
    const double rounded = std::round(mm);
    if (std::abs(mm - rounded) > kOffLatticeMm) fail();
    return static_cast<std::int32_t>(rounded);
  }

  std::string_view rest_;
  bool ok_ = true, is_little_ = true;
};

void write_ring(BlobWriter& out, const Ring& ring) {
  assert(ring.size() >= 3);
  out.u32(static_cast<std::uint32_t>(ring.size() + 1));
  for (PlanPoint p : ring) out.point(p);
  out.point(ring.front());
}

constexpr std::size_t kPointBytes = 16;

Ring read_ring(BlobReader& in) {
  const std::size_t n = in.count(kPointBytes);
  if (n < 4) in.fail();
  Ring ring;
  if (!in.ok()) return ring;
  ring.reserve(n);
  for (std::size_t i = 0; i < n; ++i) ring.push_back(in.point());
  if (ring.front() != ring.back()) in.fail();
  ring.pop_back();
  return ring;
}

}  // namespace

std::string encode_point(PlanPoint point) {
  BlobWriter out(kWkbPoint, box_of({point}));
  out.point(point);
  return out.take();
}

std::string encode_line(const std::vector<PlanPoint>& line) {
  assert(line.size() != 1);
  BlobWriter out(kWkbLine, box_of(line));
  out.u32(static_cast<std::uint32_t>(line.size()));
  for (PlanPoint p : line) out.point(p);
  return out.take();
}

std::string encode_polygon(const Polygon& polygon) {
  BlobWriter out(kWkbPolygon, box_of(polygon.outer));
  if (polygon.outer.empty()) {
    assert(polygon.holes.empty());
    out.u32(0);
    return out.take();
  }
  out.u32(static_cast<std::uint32_t>(1 + polygon.holes.size()));
  write_ring(out, polygon.outer);
  for (const Ring& hole : polygon.holes) write_ring(out, hole);
  return out.take();
}

std::optional<PlanPoint> decode_point(std::string_view blob) {
  BlobReader in(blob);
  in.expect(kWkbPoint);
  const PlanPoint point = in.point();
  if (!in.is_done()) return std::nullopt;
  return point;
}

std::optional<std::vector<PlanPoint>> decode_line(std::string_view blob) {
  BlobReader in(blob);
  in.expect(kWkbLine);
  const std::size_t n = in.count(kPointBytes);
  if (n == 1) in.fail();
  std::vector<PlanPoint> line;
  if (in.ok()) line.reserve(n);
  for (std::size_t i = 0; i < n && in.ok(); ++i) line.push_back(in.point());
  if (!in.is_done()) return std::nullopt;
  return line;
}

std::optional<Polygon> decode_polygon(std::string_view blob) {
  BlobReader in(blob);
  in.expect(kWkbPolygon);
  const std::size_t n = in.count(sizeof(std::uint32_t) + 4 * kPointBytes);
  Polygon polygon;
  if (n > 0) polygon.outer = read_ring(in);
  for (std::size_t i = 1; i < n && in.ok(); ++i) polygon.holes.push_back(read_ring(in));
  if (!in.is_done()) return std::nullopt;
  return polygon;
}

}  // namespace vicus
