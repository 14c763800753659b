#include "sectorgen/sectors/overlay.hpp"

#include <geos_c.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "city_db/boxes.hpp"
#include "sectorgen/geom/polygon.hpp"

namespace vicus {
namespace {

/// No two boxes meet: nothing to unite.
bool are_apart(const std::vector<Polygon>& polygons) {
  constexpr std::size_t kFew = 16;
  if (polygons.size() > kFew) return false;
  std::vector<PlanBox> boxes;
  for (const Polygon& p : polygons) {
    const PlanBox box = box_of(p);
    if (std::any_of(boxes.begin(), boxes.end(), [&](const PlanBox& other) { return meet(other, box); })) return false;
    boxes.push_back(box);
  }
  return true;
}

/// One GEOS context per call tree; messages are dropped: an empty result says enough.
struct Geos {
  GEOSContextHandle_t handle = GEOS_init_r();
  Geos() = default;
  Geos(const Geos&) = delete;
  ~Geos() { GEOS_finish_r(handle); }

  struct Deleter {
    GEOSContextHandle_t handle;
    void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(handle, g); }
  };
  using Ptr = std::unique_ptr<GEOSGeometry, Deleter>;
  Ptr own(GEOSGeometry* g) const { return Ptr(g, Deleter{handle}); }

  GEOSCoordSequence* sequence(const Line& line, bool close) const {
    const std::size_t n = line.size() + (close ? 1 : 0);
    auto* s = GEOSCoordSeq_create_r(handle, static_cast<unsigned>(n), 2);
    for (std::size_t i = 0; i < n; ++i) {
      const PlanPoint p = line[i % line.size()];
      GEOSCoordSeq_setXY_r(handle, s, static_cast<unsigned>(i), p.x, p.y);
    }
    return s;
  }
  Ptr line(const Line& points) const { return own(GEOSGeom_createLineString_r(handle, sequence(points, false))); }
  Ptr polygon(const Polygon& p) const {
    std::vector<GEOSGeometry*> holes;
    for (const auto& hole : p.holes) holes.push_back(GEOSGeom_createLinearRing_r(handle, sequence(hole, true)));
    auto* shell = GEOSGeom_createLinearRing_r(handle, sequence(p.outer, true));
    return own(GEOSGeom_createPolygon_r(handle, shell, holes.data(), static_cast<unsigned>(holes.size())));
  }
  Ptr collection(std::vector<Ptr> parts, int type) const {
    std::vector<GEOSGeometry*> raw;
    for (auto& p : parts) raw.push_back(p.release());
    return own(GEOSGeom_createCollection_r(handle, type, raw.data(), static_cast<unsigned>(raw.size())));
  }

  Ring ring(const GEOSGeometry* g) const {
    const auto* s = GEOSGeom_getCoordSeq_r(handle, g);
    unsigned n = 0;
    GEOSCoordSeq_getSize_r(handle, s, &n);
    Ring out;
    for (unsigned i = 0; i + 1 < n; ++i) {
      double x = 0, y = 0;
      GEOSCoordSeq_getXY_r(handle, s, i, &x, &y);
      const PlanPoint p{static_cast<std::int32_t>(std::llround(x)), static_cast<std::int32_t>(std::llround(y))};
      if (out.empty() || out.back() != p) out.push_back(p);
    }
    while (out.size() > 1 && out.front() == out.back()) out.pop_back();
    return out;
  }
  void collect(const GEOSGeometry* g, std::vector<Polygon>& out) const {
    if (g == nullptr) return;
    const int type = GEOSGeomTypeId_r(handle, g);
    if (type != GEOS_POLYGON) {
      if (type < GEOS_MULTIPOINT) return;
      for (int i = 0; i < GEOSGetNumGeometries_r(handle, g); ++i) collect(GEOSGetGeometryN_r(handle, g, i), out);
      return;
    }
    if (GEOSisEmpty_r(handle, g) == 1) return;
    // Rounding may pinch a ring: take it apart into simple ones, orientation first.
    std::vector<Ring> rings;
    const auto add = [&](Ring r, bool outer) {
      if (r.size() < 3) return;
      if ((area2(r) > 0) != outer) std::reverse(r.begin(), r.end());
      for (auto& simple : simple_rings(r))
        if ((area2(simple) > 0) == outer) rings.push_back(std::move(simple));
    };
    add(ring(GEOSGetExteriorRing_r(handle, g)), true);
    for (int i = 0; i < GEOSGetNumInteriorRings_r(handle, g); ++i)
      add(ring(GEOSGetInteriorRingN_r(handle, g, i)), false);
    for (auto& p : assemble(std::move(rings))) out.push_back(std::move(p));
  }
  std::vector<Polygon> polygons(const Ptr& g) const {
    std::vector<Polygon> out;
    collect(g.get(), out);
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.outer < b.outer; });
    return out;
  }
  Ptr multi(const std::vector<Polygon>& all) const {
    std::vector<Ptr> parts;
    for (const auto& p : all) parts.push_back(polygon(p));
    if (parts.size() == 1) return std::move(parts.front());
    if (are_apart(all)) return collection(std::move(parts), GEOS_MULTIPOLYGON);
    return united(std::move(parts));
  }
  Ptr united(std::vector<Ptr> parts) const {
    const Ptr many = collection(std::move(parts), GEOS_GEOMETRYCOLLECTION);
    return own(GEOSUnaryUnion_r(handle, many.get()));
  }
  /// `operation` of both; where rounding left a polygon that GEOS refuses, of what a union makes of it.
  std::vector<Polygon> overlay(GEOSGeometry* (*operation)(GEOSContextHandle_t, const GEOSGeometry*,
                                                          const GEOSGeometry*),
                               const Ptr& a, const Ptr& b) const {
    Ptr result = own(operation(handle, a.get(), b.get()));
    if (!result) {
      const Ptr clean_a = own(GEOSUnaryUnion_r(handle, a.get())), clean_b = own(GEOSUnaryUnion_r(handle, b.get()));
      if (clean_a && clean_b) result = own(operation(handle, clean_a.get(), clean_b.get()));
    }
    return polygons(result);
  }
};

constexpr int kQuadrantSegments = 3;
constexpr double kMitreLimit = 2;  // times the radius

Geos::Ptr outline_of(const Geos& geos, const Geos::Ptr& line, double radius_m, Cap cap) {
  const int style = cap == Cap::round ? GEOSBUF_CAP_ROUND : cap == Cap::flat ? GEOSBUF_CAP_FLAT : GEOSBUF_CAP_SQUARE;
  return geos.own(GEOSBufferWithStyle_r(geos.handle, line.get(), radius_m * kMmPerMetre, kQuadrantSegments, style,
                                        GEOSBUF_JOIN_MITRE, kMitreLimit));
}

}  // namespace

std::vector<Polygon> stroke_outlines(const std::vector<Stroke>& strokes, Cap cap) {
  if (strokes.empty()) return {};
  const Geos geos;
  std::vector<Geos::Ptr> parts;
  for (const Stroke& stroke : strokes)
    if (Geos::Ptr outline = outline_of(geos, geos.line(stroke.line), stroke.radius_m, cap))
      parts.push_back(std::move(outline));
  return geos.polygons(geos.united(std::move(parts)));
}

std::vector<Polygon> keep_off(const std::vector<Polygon>& area, const std::vector<Stroke>& strokes, Cap cap) {
  if (area.empty() || strokes.empty()) return area;
  const Geos geos;
  const Geos::Ptr whole = geos.multi(area);
  if (!whole) return area;
  const std::unique_ptr<const GEOSPreparedGeometry, std::function<void(const GEOSPreparedGeometry*)>> near(
      GEOSPrepare_r(geos.handle, whole.get()),
      [&](const GEOSPreparedGeometry* g) { GEOSPreparedGeom_destroy_r(geos.handle, g); });
  std::vector<Geos::Ptr> parts;
  for (const Stroke& stroke : strokes) {
    const Geos::Ptr line = geos.line(stroke.line);
    const double reach = kMitreLimit * stroke.radius_m * kMmPerMetre;
    if (near && GEOSPreparedDistanceWithin_r(geos.handle, near.get(), line.get(), reach) == 0) continue;
    if (Geos::Ptr outline = outline_of(geos, line, stroke.radius_m, cap)) parts.push_back(std::move(outline));
  }
  if (parts.empty()) return area;
  const Geos::Ptr cut = geos.united(std::move(parts));
  return cut ? geos.overlay(GEOSDifference_r, whole, cut) : area;
}

std::vector<Polygon> close_gaps(const std::vector<Polygon>& polygons, double distance_m) {
  if (polygons.empty()) return {};
  const Geos geos;
  const Geos::Ptr all = geos.multi(polygons);
  const double d = distance_m * kMmPerMetre;
  const auto buffer = [&](const Geos::Ptr& g, double by) {
    return geos.own(
        GEOSBufferWithStyle_r(geos.handle, g.get(), by, kQuadrantSegments, GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, 2.0));
  };
  if (!all) return polygons;
  const Geos::Ptr grown = buffer(all, d);
  if (!grown) return polygons;
  const Geos::Ptr back = buffer(grown, -d);
  return back ? geos.polygons(back) : polygons;
}

std::vector<Polygon> offset(const std::vector<Polygon>& polygons, double distance_m, bool is_rounded) {
  if (polygons.empty()) return {};
  const Geos geos;
  const Geos::Ptr all = geos.multi(polygons);
  if (!all) return {};
  constexpr int kStepsOf45 = 2;
  return geos.polygons(
      geos.own(GEOSBufferWithStyle_r(geos.handle, all.get(), distance_m * kMmPerMetre, kStepsOf45, GEOSBUF_CAP_FLAT,
                                     is_rounded ? GEOSBUF_JOIN_ROUND : GEOSBUF_JOIN_MITRE, 2.0)));
}

std::vector<Polygon> unite(const std::vector<Polygon>& polygons) {
  if (polygons.empty()) return {};
  const Geos geos;
  return geos.polygons(geos.multi(polygons));
}

std::vector<Polygon> subtract(const std::vector<Polygon>& from, const std::vector<Polygon>& what) {
  if (from.empty() || what.empty()) return from;
  const Geos geos;
  const Geos::Ptr a = geos.multi(from), b = geos.multi(what);
  if (!a || !b) return from;
  return geos.overlay(GEOSDifference_r, a, b);
}

std::vector<Polygon> intersect(const std::vector<Polygon>& a, const std::vector<Polygon>& b) {
  if (a.empty() || b.empty()) return {};
  const Geos geos;
  const Geos::Ptr left = geos.multi(a), right = geos.multi(b);
  if (!left || !right) return {};
  return geos.overlay(GEOSIntersection_r, left, right);
}

std::vector<Polygon> subtract(const Polygon& from, const std::vector<Polygon>& what) {
  const Geos geos;
  const Geos::Ptr a = geos.polygon(from), b = geos.multi(what);
  if (!a || !b) return {from};
  return geos.overlay(GEOSDifference_r, a, b);
}

std::vector<Polygon> intersect(const Polygon& a, const std::vector<Polygon>& b) {
  const Geos geos;
  const Geos::Ptr left = geos.polygon(a), right = geos.multi(b);
  if (!left || !right) return {};
  return geos.overlay(GEOSIntersection_r, left, right);
}

Line simplify(const Line& line, double tolerance_m) {
  if (line.size() < 3) return line;
  std::vector<char> keep(line.size(), 0);
  keep.front() = keep.back() = 1;
  const double limit = tolerance_m * kMmPerMetre;
  std::vector<std::pair<std::size_t, std::size_t>> stack{{0, line.size() - 1}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    double far = 0;
    std::size_t at = i;
    const double length = std::sqrt(static_cast<double>(distance2(line[i], line[j])));
    for (std::size_t k = i + 1; k < j; ++k) {
      const double d = length > 0 ? std::abs(static_cast<double>(orient(line[i], line[j], line[k]))) / length
                                  : std::sqrt(static_cast<double>(distance2(line[i], line[k])));
      if (d > far) far = d, at = k;
    }
    if (far <= limit) continue;
    keep[at] = 1;
    stack.push_back({i, at});
    stack.push_back({at, j});
  }
  Line out;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (keep[i]) out.push_back(line[i]);
  return out;
}

}  // namespace vicus
