#include "x3d_export/tileset.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/TransverseMercatorExact.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/sample_city.hpp"
#include "x3d_export/earth_frame.hpp"

namespace vicus {
namespace {

using nlohmann::json;
using Vec = std::array<double, 3>;

TEST(EarthFromPlan, TakesPlacesWhereAnExactProjectionHasThem) {
  using namespace GeographicLib;
  const TransverseMercatorExact exact(Constants::WGS84_a(), Constants::WGS84_f(), 1.0);
  for (const LatLon origin : {LatLon{48.88, 2.35}, LatLon{-33.9, 151.2}, LatLon{0.001, -179.9999}, LatLon{84.9, 30}})
    for (const PlanPoint at : {PlanPoint{0, 0}, PlanPoint{4'000'000, -7'000'000}, PlanPoint{-9'000'000, 200}}) {
      const Placement placement = earth_from_plan(origin, at, 30);
      double x0 = 0, y0 = 0;
      exact.Forward(origin.lon_deg, origin.lat_deg, origin.lon_deg, x0, y0);
      for (const Vec local : {Vec{0, 0, 0}, Vec{100, 0, 0}, Vec{0, 100, 0}, Vec{-70, 60, 0}, Vec{0, 0, 25}}) {
        double lat = 0, lon = 0, x = 0, y = 0, z = 0;
        exact.Reverse(origin.lon_deg, x0 + metres(at.x) + local[0], y0 + metres(at.y) + local[1], lat, lon);
        Geocentric::WGS84().Forward(lat, lon, 30 + local[2], x, y, z);
        const Vec placed = placement(local);
        // The Earth falls away by 0.8 mm in 100 m.
        EXPECT_NEAR(std::hypot(placed[0] - x, placed[1] - y, placed[2] - z), 0, 1.1e-3) << origin.lat_deg;
      }
    }
}

TEST(Relative, UndoesAPlacement) {
  const Placement a = earth_from_plan({48.88, 2.35}, {123'456, -98'765}, 0),
                  b = earth_from_plan({48.88, 2.35}, {0, 0}, 0);
  const Vec p{12, -7, 3}, through = b(relative(a, b)(p)), direct = a(p);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(through[i], direct[i], 1e-6);
}

Placement placement_of(const json& matrix) {
  Placement out;
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t i = 0; i < 3; ++i) out.columns[c][i] = matrix[4 * c + i];
  return out;
}

Placement composed(const Placement& outer, const Placement& inner) {
  Placement out;
  const Vec zero = outer(inner({0, 0, 0}));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec unit{};
    unit[axis] = 1;
    const Vec p = outer(inner(unit));
    for (std::size_t i = 0; i < 3; ++i) out.columns[axis][i] = p[i] - zero[i];
  }
  out.columns[3] = zero;
  return out;
}

class Walk {
 public:
  void tile(const json& tile, const Placement& parent, const json* outer, double outer_error) {
    const Placement frame = tile.contains("transform") ? composed(parent, placement_of(tile["transform"])) : parent;
    EXPECT_LE(tile["geometricError"].get<double>(), outer_error);
    if (outer) expect_inside(tile["boundingVolume"]["box"], frame, (*outer)["boundingVolume"]["box"], parent);
    if (tile.contains("content")) contents.insert(tile["content"]["uri"].get<std::string>());
    if (!tile.contains("children")) {
      EXPECT_EQ(tile["geometricError"], 0);
      return;
    }
    for (const json& child : tile["children"]) this->tile(child, frame, &tile, tile["geometricError"]);
  }
  std::set<std::string> contents;

 private:
  static void expect_inside(const json& box, const Placement& frame, const json& outer, const Placement& outer_frame) {
    const Placement to_outer = relative(frame, outer_frame);
    for (int corner = 0; corner < 8; ++corner) {
      Vec p{};
      for (std::size_t i = 0; i < 3; ++i)
        p[i] = box[i].get<double>() + ((corner >> i) & 1 ? 1 : -1) * box[3 + 4 * i].get<double>();
      const Vec q = to_outer(p);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LE(std::abs(q[i] - outer[i].get<double>()), outer[3 + 4 * i].get<double>() + 1e-6);
    }
  }
};

TEST(TilesetJson, HoldsEachSectorTwiceInBoxesWithinBoxesAndErrorsThatFall) {
  const City city = test::sample_city_with_facades();
  const json tileset = json::parse(tileset_json(CityIndex(city)));
  EXPECT_EQ(tileset["asset"]["version"], "1.1");
  Walk walk;
  Placement unit;
  for (std::size_t i = 0; i < 3; ++i) unit.columns[i][i] = 1;
  walk.tile(tileset["root"], unit, nullptr, tileset["geometricError"]);
  std::set<std::string> expected;
  for (const Sector& sector : city.sectors)
    for (const char* suffix : {".glb", ".far.glb"}) expected.insert("sectors/" + sector.id + suffix);
  EXPECT_EQ(walk.contents, expected);
}

}  // namespace
}  // namespace vicus
