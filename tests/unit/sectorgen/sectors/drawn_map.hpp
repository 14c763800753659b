#pragma once
#include <gtest/gtest.h>

#include "city_db/rules.hpp"
#include "sectorgen/build_city.hpp"

/// Small maps drawn by hand in metres, and the cities built from them.
namespace vicus::test {

inline PlanPoint at(double east, double north) { return {lattice_mm(east), lattice_mm(north)}; }

inline Polygon box(double west, double south, double east, double north) {
  return {{at(west, south), at(east, south), at(east, north), at(west, north)}, {}};
}

inline Footprint house(const std::string& id, Polygon area) {
  Footprint f;
  f.source_id = id;
  f.area = std::move(area);
  f.height_m = f.eave_m = 12;
  return f;
}

inline Axis street(const std::string& name, std::vector<PlanPoint> line, double width = 10) {
  Axis a;
  a.source_id = name;
  a.name = name;
  a.kind = "residential";
  a.width_m = width;
  a.line = std::move(line);
  return a;
}

/// One street of 200 m between two rows, west to east, houses 10 m deep, the street 12 m wide.
inline SourceMap one_street() {
  SourceMap map;
  for (int i = 0; i < 20; ++i) {
    map.footprints.push_back(house("south" + std::to_string(i), box(10 * i, -16, 10 * i + 10, -6)));
    map.footprints.push_back(house("north" + std::to_string(i), box(10 * i, 6, 10 * i + 10, 16)));
  }
  map.axes.push_back(street("Long Street", {at(-60, 0), at(260, 0)}));
  return map;
}

/// Builds the city and expects every rule of DESIGN §3 to hold.
inline City built(SourceMap map, std::vector<Issue> issues = {}) {
  BuildReport report;
  BuildOptions options;
  options.with_textures = false;
  City city = build_city(std::move(map), options, std::move(issues), report);
  const RuleReport rules = check_rules(city);
  EXPECT_TRUE(rules.all_hold());
  for (const auto& v : rules.violations) ADD_FAILURE() << name_of(v.rule) << ": " << v.message;
  return city;
}

}  // namespace vicus::test
