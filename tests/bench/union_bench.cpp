// CPU time of the stages up to the sectors against GEOS's unary union of the same footprints, in one run.
// usage: union_bench INPUT...      (docs/figures.md)
#include <geos_c.h>

#include <cstdio>

#include "sectorgen/build_city.hpp"

namespace {

/// The footprints' union, as a tool built on GEOS would make its walkable ground; returns the union's area in m2.
double union_area_m2(const vicus::SourceMap& map) {
  const auto handle = GEOS_init_r();
  std::vector<GEOSGeometry*> polygons;
  const auto ring = [&](const vicus::Ring& points) {
    auto* s = GEOSCoordSeq_create_r(handle, static_cast<unsigned>(points.size() + 1), 2);
    for (unsigned i = 0; i <= points.size(); ++i)
      GEOSCoordSeq_setXY_r(handle, s, i, points[i % points.size()].x, points[i % points.size()].y);
    return GEOSGeom_createLinearRing_r(handle, s);
  };
  for (const auto& f : map.footprints) {
    std::vector<GEOSGeometry*> holes;
    for (const auto& hole : f.area.holes) holes.push_back(ring(hole));
    polygons.push_back(
        GEOSGeom_createPolygon_r(handle, ring(f.area.outer), holes.data(), static_cast<unsigned>(holes.size())));
  }
  auto* all =
      GEOSGeom_createCollection_r(handle, GEOS_MULTIPOLYGON, polygons.data(), static_cast<unsigned>(polygons.size()));
  auto* whole = GEOSUnaryUnion_r(handle, all);
  double area = 0;
  if (whole != nullptr) GEOSArea_r(handle, whole, &area);
  GEOSGeom_destroy_r(handle, whole);
  GEOSGeom_destroy_r(handle, all);
  GEOS_finish_r(handle);
  return area / 1e6;
}

}  // namespace

int main(int argc, char** argv) {
  vicus::LoadOptions load;
  for (int i = 1; i < argc; ++i) load.inputs.emplace_back(argv[i]);
  std::vector<vicus::Issue> issues;
  double before = vicus::cpu_seconds();
  vicus::SourceMap map = vicus::load_source_map(load, issues);
  const double read = vicus::cpu_seconds() - before;
  const std::size_t footprints = map.footprints.size();
  before = vicus::cpu_seconds();
  const double area = union_area_m2(map);
  const double peer = vicus::cpu_seconds() - before;
  vicus::BuildReport report;
  const vicus::City city = vicus::build_city(std::move(map), {}, std::move(issues), report);
  double normalise = 0, sectors = 0;
  for (const auto& s : report.stages) {
    if (s.stage == "normalise") normalise = s.cpu_s;
    if (s.stage == "sectors") sectors = s.cpu_s;
  }
  std::printf("footprints %zu, union %.0f m2 by GEOS in %.2f CPU s\n", footprints, area, peer);
  std::printf("read %.2f s, normalise %.2f s, sectors %.2f s -> %zu sectors; peak %.0f MB\n", read, normalise, sectors,
              city.sectors.size(), vicus::peak_resident_mb());
  std::printf("up to the sectors / union: %.2f (with reading %.2f); sector stage / union: %.2f\n",
              (normalise + sectors) / peer, (read + normalise + sectors) / peer, sectors / peer);
}
