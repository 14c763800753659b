#include "sectorgen/geo/map_name.hpp"

#include <gtest/gtest.h>

namespace vicus {
namespace {

RawFeature feature(Theme theme, Tags tags) {
  RawFeature f;
  f.theme = theme;
  f.tags = std::move(tags);
  return f;
}
RawFeature place(const char* kind, const char* name) {
  return feature(Theme::object, {{"place", kind}, {"name", name}});
}

TEST(NameInMap, IsTheBoundarysBeforeThatOfAnyPlace) {
  RawMap map;
  map.features = {place("city", "Graz"), feature(Theme::boundary, {{"name", "Innere Stadt"}})};
  EXPECT_EQ(name_in_map(map), "Innere Stadt");
  map.features.push_back(feature(Theme::boundary, {{"name", "Lend"}}));
  EXPECT_EQ(name_in_map(map), "Graz") << "two boundaries: neither names the map";
}

TEST(NameInMap, IsThatOfTheLargestPlaceWhereItIsTheOnlyOne) {
  RawMap map;
  EXPECT_EQ(name_in_map(map), "");
  map.features = {place("quarter", "Bubeneč"), place("quarter", "Dejvice")};
  EXPECT_EQ(name_in_map(map), "");
  map.features.push_back(place("suburb", "Praha 6"));
  EXPECT_EQ(name_in_map(map), "Praha 6");
}

TEST(NameInMap, IsNoShopsAndNoUnnamedPlaces) {
  RawMap map;
  map.features = {feature(Theme::object, {{"shop", "bakery"}, {"name", "Brot"}}), feature(Theme::boundary, {}),
                  feature(Theme::object, {{"place", "town"}}),
                  feature(Theme::square, {{"place", "town"}, {"name", "Platz"}})};
  EXPECT_EQ(name_in_map(map), "");
}

TEST(NameFromFile, IsReadable) {
  EXPECT_EQ(name_from_file("maps/paris-rochechouart.osm.pbf"), "Paris Rochechouart");
  EXPECT_EQ(name_from_file("old_town.osm"), "Old Town");
  EXPECT_EQ(name_from_file("köln altstadt.gpkg"), "Köln Altstadt");
  EXPECT_EQ(name_from_file("GRAZ"), "GRAZ");
  EXPECT_EQ(name_from_file(".hidden.osm"), ".hidden");
  EXPECT_EQ(name_from_file("/maps/berlin-mitte/buildings.geojsonl.gz"), "Berlin Mitte");
  EXPECT_EQ(name_from_file("/maps/graz/Buildings.shp"), "Graz");
  EXPECT_EQ(name_from_file("/buildings.shp"), "Buildings");
  EXPECT_EQ(name_from_file("buildings.shp"), "Buildings");
}

}  // namespace
}  // namespace vicus
