#include "sectorgen/geo/attribute_rules.hpp"

#include <gtest/gtest.h>

#include "sectorgen/geo/tag_values.hpp"

namespace vicus::test {
namespace {

std::optional<Theme> tile_street(Tags attributes) {
  attributes.emplace("edge", "0");
  return theme_of_layer_line(tags_from_attributes(std::move(attributes)), LayerUse::streets);
}

TEST(LayerUse, IsReadFromTheWordsOfItsName) {
  EXPECT_EQ(layer_use("buildings"), LayerUse::buildings);
  EXPECT_EQ(layer_use("Buildings_lyon1_3946_clean"), LayerUse::buildings);
  EXPECT_EQ(layer_use("gis_osm_buildings_a_free_1"), LayerUse::buildings);
  EXPECT_EQ(layer_use("BATIMENT"), LayerUse::buildings);
  EXPECT_EQ(layer_use("gebäude"), LayerUse::buildings);
  EXPECT_EQ(layer_use("streets.geojsonl.gz"), LayerUse::streets);
  EXPECT_EQ(layer_use("planet_roads"), LayerUse::streets);
  EXPECT_EQ(layer_use("water"), LayerUse::water);
  EXPECT_EQ(layer_use("plots"), LayerUse::plots);
  EXPECT_EQ(layer_use("tessellation"), LayerUse::ignored);
  EXPECT_EQ(layer_use("railways"), LayerUse::ignored);
  EXPECT_EQ(layer_use("trail_heads"), LayerUse::unknown);
  EXPECT_EQ(layer_use("bureau"), LayerUse::unknown);
}

TEST(TileStreets, BelieveNamesBeforeClass) {
  // As they come: Raubergasse in Graz is "service, driveway, tunnel" because attributes leak between features.
  EXPECT_EQ(
      tile_street({{"class", "service"}, {"service", "driveway"}, {"brunnel", "tunnel"}, {"name", "Raubergasse"}}),
      Theme::street);
  EXPECT_EQ(tile_street({{"class", "path"}, {"subclass", "footway"}, {"name", "Paulustorgasse"}}), Theme::street);
  EXPECT_EQ(tile_street({{"class", "track"}, {"name", "Am Damm"}}), Theme::street);
  EXPECT_EQ(tile_street({{"class", "minor"}}), Theme::street);
  EXPECT_EQ(tile_street({{"class", "pedestrian"}}), Theme::street);
}

TEST(TileStreets, AreNoRailsPlatformsAndUnnamedPaths) {
  for (const char* kind :
       {"rail", "subway", "tram", "platform", "ferry", "disused", "corridor", "elevator", "construction", "proposed"})
    EXPECT_FALSE(tile_street({{"class", kind}, {"name", "Metro 2"}})) << kind;
  for (const char* rail : {"Berliner Stadtbahn", "Südbahn", "Métro 2", "Ligne de Paris-Est à Mulhouse-Ville", "RER A"})
    EXPECT_FALSE(tile_street({{"class", "primary"}, {"name", rail}})) << rail;
  for (const char* road : {"An der Ostbahn", "Bahnstraße", "Reeperbahn", "Stadtautobahn", "Rue Ligner"})
    EXPECT_EQ(tile_street({{"class", "primary"}, {"name", road}}), Theme::street) << road;
  EXPECT_FALSE(tile_street({{"class", "path"}, {"subclass", "footway"}}));
  EXPECT_FALSE(tile_street({{"class", "path"}, {"subclass", "steps"}}));
  EXPECT_FALSE(tile_street({{"class", "service"}}));
  EXPECT_FALSE(tile_street({{"class", "primary"}, {"brunnel", "tunnel"}}));
  EXPECT_FALSE(tile_street({{"class", "primary"}, {"brunnel", "tunnel"}, {"name", "Tunnel des Halles"}}));
}

TEST(TileBuildings, AHeightOf366MeansUntagged) {
  EXPECT_FALSE(has_tag(tags_from_attributes({{"render_height", "3.66"}, {"render_min_height", "0"}}), "height"));
  const Tags tags = tags_from_attributes({{"render_height", "18.3"}, {"render_min_height", "3.66"}});
  EXPECT_EQ(tag(tags, "height"), "18.3");
  EXPECT_EQ(tag(tags, "min_height"), "3.66");
}

TEST(Attributes, AreTranslatedWhateverTheirLanguage) {
  EXPECT_EQ(tag(tags_from_attributes({{"HAUTEUR", "9.2"}, {"NB_ETAGES", "3"}}), "height"), "9.2");
  EXPECT_EQ(tag(tags_from_attributes({{"HAUTEUR", "9.2"}, {"NB_ETAGES", "3"}}), "building:levels"), "3");
  for (const char* name : {"height", "HEIGHT", "hoehe", "measuredHeight"})
    EXPECT_EQ(tag(tags_from_attributes({{name, "7"}}), "height"), "7") << name;
  for (const char* name : {"levels", "storeys", "Floors"})
    EXPECT_EQ(tag(tags_from_attributes({{name, "7"}}), "building:levels"), "7") << name;
  EXPECT_EQ(theme_of_layer_line(tags_from_attributes({}), LayerUse::streets), Theme::street);
  EXPECT_EQ(tag(tags_from_attributes({{"class", "living_street"}}), "highway"), "living_street");
}

TEST(SourceIds, AreOsmIdsWhereTheFileHasThem) {
  EXPECT_EQ(feature_source_id({{"@id", "way/42"}}, "buildings", 3), "way/42");
  EXPECT_EQ(feature_source_id({{"id", "42"}}, "buildings", 3), "buildings#3");
}

}  // namespace
}  // namespace vicus::test
