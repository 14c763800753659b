#include "tests/support/sample_interior.hpp"

#include <algorithm>

#include "tests/support/sample_city.hpp"
#include "tests/support/triangulate.hpp"

namespace vicus::test {
namespace {

PlanPoint at(double east, double north) { return {lattice_mm(east), lattice_mm(north)}; }

Interior room(const char* id, const char* source_id, const char* name, PlanPoint origin, Ring ring) {
  Interior interior;
  interior.sector.id = id;
  interior.sector.kind = SectorKind::interior;
  interior.sector.name = name;
  interior.sector.origin = origin;
  interior.sector.ground.outer = std::move(ring);
  interior.sector.ground_triangles = triangulate(interior.sector.ground);
  interior.sector.bytes = 1234;
  interior.building_id = "b-8";
  interior.source_id = source_id;
  interior.floor_m = 0.125;
  interior.height_m = 2.75;
  return interior;
}

void add_door(City& city, const char* id, const char* from, const char* to, PlanPoint a, PlanPoint b, double recess_m) {
  const std::string twin = std::string(id) + "-in";
  city.doors.push_back({id, twin, from, to, "b-8", a, b, 0.125, 2.1, recess_m});
  city.doors.push_back({twin, id, to, from, "b-8", b, a, 0.125, 2.1, -recess_m});
}

}  // namespace

City sample_city_with_interior() {
  City city = sample_city_with_facades();
  city.interiors.push_back(room("hall", "way/70", "Diele", at(10, -8.5),
                                {at(6, -12), at(14, -12), at(14, -9), at(14.1, -9), at(14.1, -8), at(14, -8),
                                 at(14, -5.3), at(11, -5.3), at(11, -5), at(10, -5), at(10, -5.3), at(6, -5.3)}));
  city.interiors.push_back(room("kitchen", "way/71", "", at(17, -8.5),
                                {at(14.2, -12), at(20, -12), at(20, -5.3), at(14.2, -5.3), at(14.2, -8), at(14.1, -8),
                                 at(14.1, -9), at(14.2, -9)}));
  add_door(city, "hall-d1", "s-main-e", "hall", at(10, -5), at(11, -5), 0.145);
  add_door(city, "kitchen-d1", "hall", "kitchen", at(14.1, -9), at(14.1, -8), 0);
  // The facade of b-8 along s-main-e in two stretches, beside the door.
  const auto whole = std::find_if(city.facades.begin(), city.facades.end(),
                                  [](const Facade& f) { return f.building_id == "b-8" && f.sector_id == "s-main-e"; });
  Facade left = *whole, right = *whole;
  left.b = at(10, -5);
  left.repeats = 1;
  left.door_bay = right.door_bay = -1;
  right.a = at(11, -5);
  *whole = left;
  city.facades.insert(whole + 1, right);
  return city;
}

}  // namespace vicus::test
