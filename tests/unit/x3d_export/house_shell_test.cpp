#include "x3d_export/house_shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/sample_city.hpp"

namespace vicus {
namespace {

using Edge = std::pair<std::uint64_t, std::uint64_t>;
using Rings = std::vector<std::vector<std::uint64_t>>;

/// Directed edges without their opposite, counted.
std::size_t open_edges(const std::vector<Rings>& faces) {
  std::map<Edge, int> count;
  for (const auto& face : faces)
    for (const auto& ring : face)
      for (std::size_t i = 0; i < ring.size(); ++i) ++count[{ring[i], ring[(i + 1) % ring.size()]}];
  std::size_t open = 0;
  for (const auto& [edge, n] : count) {
    const auto opposite = count.find({edge.second, edge.first});
    open += opposite == count.end() || opposite->second != n;
  }
  return open;
}

PlanPoint at(double east, double north) { return {lattice_mm(east), lattice_mm(north)}; }

/// 20 m square round a court of 6 m, with a flat roof.
Building house_with_court() {
  Building house;
  house.id = "court";
  house.footprint = {{at(0, 0), at(20, 0), at(20, 20), at(0, 20)}, {{at(7, 7), at(7, 13), at(13, 13), at(13, 7)}}};
  house.height_m = house.eave_m = 9.5;
  RoofFacet top;
  top.rings = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  for (const Ring& ring : {house.footprint.outer, house.footprint.holes[0]})
    for (const PlanPoint p : ring) house.roof.points.push_back({p, 95'000});
  top.triangles = {0, 1, 4, 1, 7, 4, 1, 2, 7, 2, 6, 7, 2, 3, 6, 3, 5, 6, 3, 0, 5, 0, 4, 5};
  house.roof.facets = {top};
  return house;
}

City court_city() {
  City city = test::sample_city();
  city.buildings.push_back(house_with_court());
  return city;
}

std::vector<Rings> faces_of(const HouseShell& shell) {
  std::vector<Rings> faces;
  for (const auto& face : shell.faces) {
    Rings rings;
    for (const auto& ring : face.rings) rings.emplace_back(ring.begin(), ring.end());
    faces.push_back(std::move(rings));
  }
  return faces;
}

TEST(HouseShell, IsClosed) {
  for (const Building& house : court_city().buildings)
    EXPECT_EQ(open_edges(faces_of(house_shell(house))), 0u) << house.id;
}

TEST(HouseShell, IsOpenWhereTheRoofLacksAFacet) {
  Building house = house_with_court();
  house.roof.facets.clear();
  EXPECT_EQ(open_edges(faces_of(house_shell(house))), 8u);
}

/// Enclosed volume by the divergence theorem over the faces of an OBJ file, house by house: outside is outside.
TEST(ObjText, HasAClosedSolidOfTheRightVolumeForEachHouse) {
  const City city = court_city();
  std::istringstream text(obj_text(city));
  std::vector<std::array<double, 3>> points;
  std::map<std::string, std::vector<Rings>> faces;
  std::map<std::string, double> volume;
  std::string name;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "o") words >> name;
    if (word == "v") {
      auto& p = points.emplace_back();
      words >> p[0] >> p[1] >> p[2];
    }
    if (word != "f") continue;
    std::vector<std::uint64_t> ring;
    for (std::uint64_t i = 0; words >> i;) ring.push_back(i);
    faces[name].push_back({ring});
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const auto &a = points.at(ring[0] - 1), &b = points.at(ring[i] - 1), &c = points.at(ring[i + 1] - 1);
      volume[name] += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0])) /
                      6;
    }
  }
  ASSERT_EQ(faces.size(), city.buildings.size());
  for (const auto& [id, list] : faces) {
    EXPECT_EQ(open_edges(list), 0u) << id;
    EXPECT_GT(volume[id], 0) << id << " is inside out";
  }
  EXPECT_NEAR(volume["court"], (400 - 36) * 9.5, 1e-6);
}

TEST(Solids, StandAtTheirGroundWithWallsDownToTheirFoot) {
  City city;
  city.buildings = {house_with_court()};
  city.buildings[0].ground_m = 30;
  city.buildings[0].foot_m = 1.5;
  EXPECT_EQ(open_edges(faces_of(house_shell(city.buildings[0]))), 0u);
  double least = 1e9, most = 0;
  std::istringstream text(obj_text(city));
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string word;
    double x = 0, y = 0, z = 0;
    if (words >> word >> x >> y >> z; word == "v") least = std::min(least, z), most = std::max(most, z);
  }
  EXPECT_NEAR(least, 28.5, 1e-9);
  EXPECT_NEAR(most, 39.5, 1e-9);
  const auto json = nlohmann::json::parse(cityjson_text(city));
  const double step = json["transform"]["scale"][2].get<double>();
  EXPECT_NEAR(json["vertices"].front()[2].get<double>() * step, 28.5, 1e-9);
  EXPECT_NEAR(json["vertices"].back()[2].get<double>() * step, 39.5, 1e-9);
}

TEST(CityJson, HasAClosedSolidWithSurfacesForEachHouse) {
  const City city = court_city();
  const auto json = nlohmann::json::parse(cityjson_text(city));
  EXPECT_EQ(json["version"], "2.0");
  const std::size_t vertices = json["vertices"].size();
  ASSERT_EQ(json["CityObjects"].size(), city.buildings.size());
  for (const auto& [id, object] : json["CityObjects"].items()) {
    EXPECT_EQ(object["type"], "Building");
    const auto& solid = object["geometry"][0];
    EXPECT_EQ(solid["type"], "Solid");
    std::vector<Rings> faces;
    for (const auto& face : solid["boundaries"][0]) faces.push_back(face.get<Rings>());
    EXPECT_EQ(open_edges(faces), 0u) << id;
    for (const auto& face : faces)
      for (const auto& ring : face)
        for (const std::uint64_t i : ring) EXPECT_LT(i, vertices);
    ASSERT_EQ(solid["semantics"]["values"][0].size(), faces.size());
    for (const auto& value : solid["semantics"]["values"][0]) EXPECT_LT(value.get<int>(), 3);
  }
  const auto& p = json["vertices"].back();
  EXPECT_NEAR(p[2].get<double>() * json["transform"]["scale"][2].get<double>(), 9.5, 1e-9);
}

}  // namespace
}  // namespace vicus
