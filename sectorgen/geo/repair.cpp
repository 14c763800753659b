#include "sectorgen/geo/repair.hpp"

#include <geos_c.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <memory>

#include "sectorgen/geo/ring_check.hpp"

namespace vicus {

namespace {

// Rounding a repaired polygon may make it cross itself again; each round works on fewer and shorter edges.
constexpr int kRepairRounds = 6;

/// GEOS's handle, one per thread. Its messages are dropped: every fault is looked up by name.
GEOSContextHandle_t geos() {
  struct Context {
    GEOSContextHandle_t handle = GEOS_init_r();
    ~Context() { GEOS_finish_r(handle); }
  };
  thread_local Context context;
  return context.handle;
}

struct DestroyGeometry {
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(geos(), geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, DestroyGeometry>;

GEOSGeometry* linear_ring(const Ring& ring) {
  GEOSCoordSequence* points = GEOSCoordSeq_create_r(geos(), static_cast<unsigned>(ring.size() + 1), 2);
  for (unsigned i = 0; i <= ring.size(); ++i) {
    const PlanPoint p = ring[i % ring.size()];
    GEOSCoordSeq_setXY_r(geos(), points, i, p.x, p.y);
  }
  return GEOSGeom_createLinearRing_r(geos(), points);
}

/// Needs   every ring has >= 3 points.
Geometry geometry_of(const Polygon& polygon) {
  std::vector<GEOSGeometry*> holes;
  for (const Ring& hole : polygon.holes) holes.push_back(linear_ring(hole));
  return Geometry(
      GEOSGeom_createPolygon_r(geos(), linear_ring(polygon.outer), holes.data(), static_cast<unsigned>(holes.size())));
}

Ring ring_from(const GEOSGeometry* line) {
  Ring ring;
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(geos(), line);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(geos(), points, &size);
  for (unsigned i = 0; i < size; ++i) {
    double x = 0, y = 0;
    GEOSCoordSeq_getXY_r(geos(), points, i, &x, &y);
    ring.push_back({static_cast<std::int32_t>(std::llround(x)), static_cast<std::int32_t>(std::llround(y))});
  }
  return without_repeats(ring);
}

/// Rounded polygons, without rings that collapsed; not yet valid.
void append_polygons(const GEOSGeometry* geometry, std::vector<Polygon>& polygons) {
  if (GEOSGeomTypeId_r(geos(), geometry) == GEOS_POLYGON) {
    if (GEOSisEmpty_r(geos(), geometry) == 1) return;
    Polygon polygon{ring_from(GEOSGetExteriorRing_r(geos(), geometry)), {}};
    if (polygon.outer.size() < 3 || area2(polygon.outer) == 0) return;
    for (int i = 0; i < GEOSGetNumInteriorRings_r(geos(), geometry); ++i) {
      Ring hole = ring_from(GEOSGetInteriorRingN_r(geos(), geometry, i));
      if (hole.size() >= 3 && area2(hole) != 0) polygon.holes.push_back(std::move(hole));
    }
    polygons.push_back(std::move(polygon));
    return;
  }
  for (int i = 0; i < GEOSGetNumGeometries_r(geos(), geometry); ++i) {
    const GEOSGeometry* part = GEOSGetGeometryN_r(geos(), geometry, i);
    if (part != geometry && GEOSGeom_getDimensions_r(geos(), part) == 2) append_polygons(part, polygons);
  }
}

RingFault fault_of(const GEOSGeometry* geometry) {
  RingFault fault{IssueCode::ring_self_intersection, "its outline crosses or touches itself", {}};
  char* reason = nullptr;
  GEOSGeometry* where = nullptr;
  if (GEOSisValidDetail_r(geos(), geometry, 0, &reason, &where) == 0 && reason && where) {
    double x = 0, y = 0;
    GEOSGeomGetX_r(geos(), where, &x);
    GEOSGeomGetY_r(geos(), where, &y);
    fault.at = {static_cast<std::int32_t>(std::llround(x)), static_cast<std::int32_t>(std::llround(y))};
    if (std::strcmp(reason, "Hole lies outside shell") == 0)
      fault = {IssueCode::hole_outside, "a hole lies outside of its outline", fault.at};
    if (std::strcmp(reason, "Holes are nested") == 0) fault.what = "one of its holes lies in another";
  }
  if (where) GEOSGeom_destroy_r(geos(), where);
  if (reason) GEOSFree_r(geos(), reason);
  return fault;
}

bool is_geos_valid(const GEOSGeometry* geometry) { return GEOSisValid_r(geos(), geometry) == 1; }

struct DestroyParams {
  void operator()(GEOSMakeValidParams* params) const { GEOSMakeValidParams_destroy_r(geos(), params); }
};

Geometry valid_by_structure(const Geometry& geometry) {
  const std::unique_ptr<GEOSMakeValidParams, DestroyParams> params(GEOSMakeValidParams_create_r(geos()));
  GEOSMakeValidParams_setMethod_r(geos(), params.get(), GEOS_MAKE_VALID_STRUCTURE);
  GEOSMakeValidParams_setKeepCollapsed_r(geos(), params.get(), 0);
  return Geometry(GEOSMakeValidWithParams_r(geos(), geometry.get(), params.get()));
}

/// The repaired outline less the repaired holes. Not the polygon at once: GEOS takes a hole that lies outside of its
/// outline for a polygon of its own.
Geometry valid_geometry(const Polygon& polygon) {
  Geometry valid = valid_by_structure(geometry_of({polygon.outer, {}}));
  for (const Ring& hole : polygon.holes) {
    const Geometry valid_hole = valid_by_structure(geometry_of({hole, {}}));
    if (valid && valid_hole) valid.reset(GEOSDifference_r(geos(), valid.get(), valid_hole.get()));
  }
  return valid;
}

std::vector<Polygon> made_valid(const Polygon& polygon) {
  std::vector<Polygon> valid, pending;
  if (const Geometry first = valid_geometry(polygon)) append_polygons(first.get(), pending);
  for (int round = 0; round < kRepairRounds && !pending.empty(); ++round) {
    std::vector<Polygon> rounded;
    rounded.swap(pending);
    for (Polygon& part : rounded) {
      if (is_valid(part)) {
        valid.push_back(std::move(part));
      } else if (const Geometry again = valid_geometry(part)) {
        append_polygons(again.get(), pending);
      }
    }
  }
  return valid;
}

/// Drops rings that are none. False: the outline itself is none.
bool drop_short_rings(std::vector<Ring>& rings, Repaired& result) {
  for (Ring& ring : rings) ring = without_repeats(ring);
  const auto is_short = [](const Ring& ring) { return ring.size() < 3; };
  for (const Ring& ring : rings)
    if (is_short(ring))
      result.fault = RingFault{IssueCode::ring_too_few_points, "a ring has fewer than three points",
                               ring.empty() ? PlanPoint{} : ring.front()};
  if (rings.empty() || is_short(rings.front())) return false;
  rings.erase(std::remove_if(rings.begin(), rings.end(), is_short), rings.end());
  return true;
}

/// So that equal input gives equal output however GEOS orders its results.
void make_canonical(std::vector<Polygon>& polygons) {
  const auto smallest_first = [](Ring& ring) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  };
  for (Polygon& polygon : polygons) {
    orient_rings(polygon);
    smallest_first(polygon.outer);
    for (Ring& hole : polygon.holes) smallest_first(hole);
    std::sort(polygon.holes.begin(), polygon.holes.end());
  }
  std::sort(polygons.begin(), polygons.end(), [](const Polygon& a, const Polygon& b) { return a.outer < b.outer; });
}

}  // namespace

bool is_valid(const Polygon& polygon) {
  return is_strictly_simple(polygon) || is_geos_valid(geometry_of(polygon).get());
}

std::vector<Polygon> united_polygons(const std::vector<Polygon>& polygons) {
  std::vector<GEOSGeometry*> parts;
  for (const Polygon& polygon : polygons) parts.push_back(geometry_of(polygon).release());
  const Geometry all(
      GEOSGeom_createCollection_r(geos(), GEOS_MULTIPOLYGON, parts.data(), static_cast<unsigned>(parts.size())));
  const Geometry united(GEOSUnaryUnion_r(geos(), all.get()));
  std::vector<Polygon> rounded, valid;
  if (united) append_polygons(united.get(), rounded);
  for (const Polygon& polygon : rounded) {
    const std::vector<Polygon> repaired = is_valid(polygon) ? std::vector<Polygon>{polygon} : made_valid(polygon);
    valid.insert(valid.end(), repaired.begin(), repaired.end());
  }
  make_canonical(valid);
  return valid;
}

Repaired repaired_polygons(std::vector<Ring> rings) {
  Repaired result;
  if (!drop_short_rings(rings, result)) return result;
  Polygon polygon{std::move(rings.front()), {}};
  polygon.holes.assign(std::make_move_iterator(rings.begin() + 1), std::make_move_iterator(rings.end()));
  if (is_strictly_simple(polygon)) {
    orient_rings(polygon);
    result.polygons.push_back(std::move(polygon));
    return result;
  }
  const Geometry geometry = geometry_of(polygon);
  if (is_geos_valid(geometry.get()) && area2(polygon.outer) != 0) {
    orient_rings(polygon);
    result.polygons.push_back(std::move(polygon));
    return result;
  }
  if (!result.fault) result.fault = fault_of(geometry.get());
  result.polygons = made_valid(polygon);
  make_canonical(result.polygons);
  return result;
}

}  // namespace vicus
