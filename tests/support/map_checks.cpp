#include "tests/support/map_checks.hpp"

#include <geos_c.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace vicus::test {

namespace {

GEOSContextHandle_t geos() {
  static GEOSContextHandle_t handle = GEOS_init_r();
  return handle;
}

struct Destroy {
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(geos(), geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

// Geometries are in whole millimetres: in metres a point on a line would be rounded off it.
constexpr double kSquareMm = 1e-6;

GEOSGeometry* ring_geometry(const Ring& ring) {
  GEOSCoordSequence* points = GEOSCoordSeq_create_r(geos(), static_cast<unsigned>(ring.size() + 1), 2);
  for (unsigned i = 0; i <= ring.size(); ++i)
    GEOSCoordSeq_setXY_r(geos(), points, i, ring[i % ring.size()].x, ring[i % ring.size()].y);
  return GEOSGeom_createLinearRing_r(geos(), points);
}

/// Null for rings that GEOS does not take as rings.
Geometry geometry_of(const Polygon& polygon) {
  GEOSGeometry* outer = ring_geometry(polygon.outer);
  std::vector<GEOSGeometry*> holes;
  for (const Ring& hole : polygon.holes) holes.push_back(ring_geometry(hole));
  if (!outer || std::count(holes.begin(), holes.end(), nullptr) > 0) return nullptr;
  return Geometry(GEOSGeom_createPolygon_r(geos(), outer, holes.data(), static_cast<unsigned>(holes.size())));
}

double signed_area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanPoint a = ring[i], b = ring[(i + 1) % ring.size()], o = ring[0];
    sum += metres(std::int64_t{a.x} - o.x) * metres(std::int64_t{b.y} - o.y) -
           metres(std::int64_t{b.x} - o.x) * metres(std::int64_t{a.y} - o.y);
  }
  return sum / 2;
}

std::string broken_footprint(const Footprint& footprint) {
  if (!is_valid_by_geos(footprint.area)) return "invalid outline";
  if (!(footprint.base_m >= 0)) return "base below the ground";
  if (!(footprint.height_m > footprint.base_m)) return "top not above the base";
  if (!(footprint.eave_m >= footprint.base_m && footprint.eave_m <= footprint.height_m)) return "eave not in between";
  if (footprint.source_id.empty()) return "no source id";
  return "";
}

bool has_repeats(const std::vector<PlanPoint>& line) {
  return std::adjacent_find(line.begin(), line.end()) != line.end();
}

}  // namespace

bool is_valid_by_geos(const Polygon& polygon) {
  if (polygon.outer.size() < 3 || signed_area(polygon.outer) <= 0) return false;
  for (const Ring& hole : polygon.holes)
    if (hole.size() < 3 || signed_area(hole) >= 0) return false;
  const Geometry geometry = geometry_of(polygon);
  return geometry && GEOSisValid_r(geos(), geometry.get()) == 1;
}

double area_by_geos_m2(const Polygon& polygon) {
  const Geometry geometry = geometry_of(polygon);
  double area = -1;
  return geometry && GEOSArea_r(geos(), geometry.get(), &area) == 1 ? area * kSquareMm : -1;
}

double shared_area_by_geos_m2(const Polygon& a, const Polygon& b) {
  const Geometry first = geometry_of(a), second = geometry_of(b);
  const Geometry shared(GEOSIntersection_r(geos(), first.get(), second.get()));
  double area = -1;
  return shared && GEOSArea_r(geos(), shared.get(), &area) == 1 ? area * kSquareMm : -1;
}

std::string broken_promise(const SourceMap& map) {
  for (const Footprint& footprint : map.footprints)
    if (const std::string broken = broken_footprint(footprint); !broken.empty())
      return footprint.source_id + ": " + broken;
  for (const Area& area : map.areas)
    if (!is_valid_by_geos(area.area)) return area.source_id + ": invalid area";
  for (const Axis& axis : map.axes) {
    if (axis.line.size() < 2 || has_repeats(axis.line)) return axis.source_id + ": axis with repeated points";
    if (!(axis.width_m > 0) || axis.kind.empty()) return axis.source_id + ": axis without width or kind";
  }
  for (const Barrier& barrier : map.barriers)
    if (barrier.line.size() < 2 || has_repeats(barrier.line))
      return barrier.source_id + ": barrier with repeated points";
  for (const PointObject& object : map.objects)
    if (object.kind.empty()) return object.source_id + ": object without kind";
  return map.licences.empty() ? "no licence" : "";
}

std::size_t Loaded::count(IssueCode code) const {
  return static_cast<std::size_t>(
      std::count_if(issues.begin(), issues.end(), [&](const Issue& issue) { return issue.code == code; }));
}

Loaded load(const LoadOptions& options) {
  Loaded loaded;
  loaded.map = load_source_map(options, loaded.issues);
  return loaded;
}

Loaded load(const std::vector<std::filesystem::path>& inputs) {
  LoadOptions options;
  options.inputs = inputs;
  return load(options);
}

std::optional<std::filesystem::path> real_data() {
  const char* named = std::getenv("VICUS_DATA");
  const std::filesystem::path path =
      named ? std::filesystem::path(named) : std::filesystem::path(VICUS_TESTS) / "../../shared/data";
  if (!std::filesystem::is_directory(path)) return std::nullopt;
  return path;
}

}  // namespace vicus::test
