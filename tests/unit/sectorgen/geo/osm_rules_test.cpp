#include "sectorgen/geo/osm_rules.hpp"

#include <gtest/gtest.h>

namespace vicus::test {
namespace {

std::string text_of(const Tags& tags) {
  std::string text;
  for (const auto& [key, value] : tags) text += key + "=" + value + " ";
  return text;
}

TEST(Axes, AreStreetsAndNamedPaths) {
  for (const Tags& tags : {
           Tags{{"highway", "residential"}},
           Tags{{"highway", "primary_link"}},
           Tags{{"highway", "pedestrian"}},
           Tags{{"highway", "busway"}},
           Tags{{"highway", "steps"}},
           Tags{{"highway", "service"}, {"name", "Mews"}},
           Tags{{"highway", "service"}, {"service", "alley"}},
           Tags{{"highway", "footway"}, {"name", "Passage du Caire"}},
           Tags{{"highway", "path"}, {"name", "Treidelpfad"}},
           Tags{{"highway", "footway"}, {"tunnel", "building_passage"}},
           Tags{{"highway", "service"}, {"tunnel", "building_passage"}, {"layer", "-1"}},
           Tags{{"highway", "footway"}, {"covered", "arcade"}},
           Tags{{"highway", "residential"}, {"access", "private"}, {"foot", "yes"}},
       })
    EXPECT_EQ(theme_of_line(tags), Theme::street) << text_of(tags);
}

TEST(Axes, AreNotAreasTunnelsPavementsAndWhatIsPrivate) {
  for (const Tags& tags : {
           Tags{{"highway", "pedestrian"}, {"area", "yes"}},
           Tags{{"highway", "residential"}, {"layer", "-1"}},
           Tags{{"highway", "primary"}, {"tunnel", "yes"}},
           Tags{{"highway", "footway"}, {"name", "Mall"}, {"indoor", "yes"}},
           Tags{{"highway", "footway"}, {"name", "Rue"}, {"footway", "sidewalk"}},
           Tags{{"highway", "footway"}, {"name", "Rue"}, {"footway", "crossing"}},
           Tags{{"highway", "footway"}, {"footway", "link"}},
           Tags{{"highway", "footway"}, {"footway", "traffic_island"}},
           Tags{{"highway", "service"}, {"name", "Car park"}, {"service", "parking_aisle"}},
           Tags{{"highway", "service"}, {"name", "Yard"}, {"service", "driveway"}},
           Tags{{"highway", "service"}, {"name", "Burgers"}, {"service", "drive-through"}},
           Tags{{"highway", "residential"}, {"access", "private"}},
           Tags{{"highway", "corridor"}, {"name", "x"}},
           Tags{{"highway", "elevator"}, {"name", "x"}},
           Tags{{"highway", "platform"}, {"name", "x"}},
           Tags{{"highway", "construction"}, {"name", "x"}},
           Tags{{"highway", "proposed"}, {"name", "x"}},
           Tags{{"highway", "footway"}},
           Tags{{"highway", "path"}},
           Tags{{"highway", "steps"}, {"level", "0;1"}},
           Tags{{"highway", "steps"}, {"conveying", "yes"}},
       })
    EXPECT_NE(theme_of_line(tags), Theme::street) << text_of(tags);
}

TEST(Tracks, AreUnnamedPathsAndTramRailsOnTheGround) {
  for (const Tags& tags : {Tags{{"highway", "footway"}}, Tags{{"highway", "path"}},
                           Tags{{"railway", "tram"}, {"name", "Line 4"}}, Tags{{"highway", "cycleway"}}})
    EXPECT_EQ(theme_of_line(tags), Theme::track) << text_of(tags);
  for (const Tags& tags :
       {Tags{{"highway", "footway"}, {"footway", "sidewalk"}}, Tags{{"highway", "footway"}, {"indoor", "yes"}},
        Tags{{"highway", "path"}, {"layer", "-1"}}, Tags{{"railway", "tram"}, {"tunnel", "yes"}},
        Tags{{"railway", "tram"}, {"bridge", "yes"}}, Tags{{"railway", "rail"}}})
    EXPECT_FALSE(theme_of_line(tags)) << text_of(tags);
}

TEST(Polygons, AreWhatTheirTagsSay) {
  EXPECT_EQ(theme_of_polygon({{"building", "yes"}}), Theme::building);
  EXPECT_EQ(theme_of_polygon({{"building", "roof"}}), Theme::building);
  EXPECT_EQ(theme_of_polygon({{"building:part", "yes"}}), Theme::part);
  EXPECT_EQ(theme_of_polygon({{"building", "yes"}, {"building:part", "yes"}}), Theme::building);
  EXPECT_EQ(theme_of_polygon({{"place", "square"}}), Theme::square);
  EXPECT_EQ(theme_of_polygon({{"highway", "pedestrian"}, {"area", "yes"}}), Theme::square);
  EXPECT_EQ(theme_of_polygon({{"highway", "footway"}, {"area", "yes"}}), Theme::square);
  EXPECT_EQ(theme_of_polygon({{"leisure", "park"}}), Theme::park);
  EXPECT_EQ(theme_of_polygon({{"leisure", "garden"}}), Theme::park);
  EXPECT_EQ(theme_of_polygon({{"leisure", "garden"}, {"access", "private"}}), Theme::plot);
  for (const Tags& tags : {Tags{{"natural", "water"}}, Tags{{"waterway", "riverbank"}}, Tags{{"landuse", "basin"}},
                           Tags{{"amenity", "fountain"}}})
    EXPECT_EQ(theme_of_polygon(tags), Theme::water) << text_of(tags);
}

TEST(Polygons, UndergroundAndAbsentOnesAreLeftOut) {
  for (const Tags& tags :
       {Tags{{"building", "yes"}, {"location", "underground"}}, Tags{{"building", "yes"}, {"layer", "-1"}},
        Tags{{"building", "no"}}, Tags{{"building", "proposed"}}, Tags{{"natural", "water"}, {"layer", "-2"}},
        Tags{{"landuse", "residential"}}, Tags{}})
    EXPECT_FALSE(theme_of_polygon(tags)) << text_of(tags);
}

TEST(Base, LeavesRoomToWalkUnderRoofsAndRaisedHousesOnly) {
  EXPECT_EQ(building_base_m({{"building", "yes"}}, Theme::building, 9), 0);
  EXPECT_EQ(building_base_m({{"building", "yes"}, {"min_height", "2.5"}}, Theme::building, 9), 0);
  EXPECT_EQ(building_base_m({{"building", "yes"}, {"min_height", "3"}}, Theme::building, 9), 3);
  EXPECT_EQ(building_base_m({{"building", "yes"}, {"building:min_level", "1"}}, Theme::building, 9), 3);
  EXPECT_EQ(building_base_m({{"building", "yes"}, {"min_level", "2"}}, Theme::building, 9), 6);
  EXPECT_EQ(building_base_m({{"building:part", "yes"}, {"min_height", "1"}}, Theme::part, 9), 1);
  for (const char* kind : {"roof", "canopy", "carport"}) {
    const double base = building_base_m({{"building", kind}}, Theme::building, 4);
    EXPECT_GT(base, 2.5) << kind;
    EXPECT_LT(base, 4) << kind;
  }
}

TEST(Base, LeavesRoomToWalkUnderBridgesAndHousesAboveGround) {
  for (const Tags& tags :
       {Tags{{"building", "bridge"}}, Tags{{"building", "viaduct"}}, Tags{{"building", "yes"}, {"bridge", "viaduct"}},
        Tags{{"building", "yes"}, {"layer", "1"}}, Tags{{"building", "yes"}, {"man_made", "bridge"}}})
    EXPECT_EQ(building_base_m(tags, Theme::building, 9), 4.5) << text_of(tags);
  EXPECT_EQ(building_base_m({{"building", "bridge"}, {"min_height", "6"}}, Theme::building, 9), 6);
  EXPECT_EQ(building_base_m({{"building", "bridge"}}, Theme::building, 3), 0);  // no room below
  EXPECT_EQ(building_base_m({{"building", "yes"}, {"layer", "0"}}, Theme::building, 9), 0);
}

TEST(Level, IsTheLayerOrOneForABridge) {
  EXPECT_EQ(axis_level({{"highway", "primary"}}), 0);
  EXPECT_EQ(axis_level({{"highway", "primary"}, {"bridge", "yes"}}), 1);
  EXPECT_EQ(axis_level({{"highway", "primary"}, {"bridge", "yes"}, {"layer", "2"}}), 2);
  EXPECT_EQ(axis_level({{"highway", "primary"}, {"layer", "-1"}}), -1);
  EXPECT_EQ(axis_level({{"highway", "primary"}, {"bridge", "no"}, {"layer", "high"}}), 0);
}

TEST(Width, IsTaggedElseFromLanesElseTypical) {
  EXPECT_EQ(axis_width_m({{"highway", "residential"}, {"width", "7"}}), 7);
  EXPECT_EQ(axis_width_m({{"highway", "residential"}, {"width", "7"}, {"sidewalk", "both"}}), 11);
  EXPECT_EQ(axis_width_m({{"highway", "residential"}, {"lanes", "2"}}), 10);
  EXPECT_EQ(axis_width_m({{"highway", "residential"}, {"lanes", "2"}, {"sidewalk", "no"}}), 6);
  EXPECT_EQ(axis_width_m({{"highway", "residential"}, {"width", "wide"}}), axis_width_m({{"highway", "residential"}}));
  EXPECT_EQ(axis_width_m({{"highway", "residential"}, {"width", "-4"}}), axis_width_m({{"highway", "residential"}}));
  EXPECT_GT(axis_width_m({}), 0);
  EXPECT_GT(axis_width_m({{"highway", "primary"}}), axis_width_m({{"highway", "path"}}));
}

TEST(Points, AreKeptByKind) {
  EXPECT_EQ(kind_of_point({{"natural", "tree"}}), "tree");
  EXPECT_EQ(kind_of_point({{"highway", "street_lamp"}}), "street_lamp");
  EXPECT_EQ(kind_of_point({{"amenity", "fountain"}}), "fountain");
  EXPECT_EQ(kind_of_point({{"amenity", "bench"}}), "bench");
  EXPECT_EQ(kind_of_point({{"barrier", "bollard"}}), "bollard");
  EXPECT_EQ(kind_of_point({{"tourism", "artwork"}, {"artwork_type", "statue"}}), "statue");
  EXPECT_EQ(kind_of_point({{"tourism", "artwork"}}), "artwork");
  EXPECT_EQ(kind_of_point({{"shop", "bakery"}, {"name", "B"}}), "shop");
  EXPECT_EQ(kind_of_point({{"entrance", "main"}}), "door");
  EXPECT_EQ(kind_of_point({{"railway", "subway_entrance"}}), "subway_entrance");
  EXPECT_EQ(kind_of_point({{"addr:housenumber", "7"}}), "address");
  EXPECT_EQ(kind_of_point({}), "");
  EXPECT_EQ(kind_of_point({{"source", "survey"}}), "");
}

TEST(Barriers, AreWallsOrFences) {
  EXPECT_EQ(theme_of_line({{"barrier", "hedge"}}), Theme::barrier);
  EXPECT_TRUE(is_wall({{"barrier", "retaining_wall"}}));
  EXPECT_TRUE(is_wall({{"barrier", "city_wall"}}));
  EXPECT_FALSE(is_wall({{"barrier", "fence"}}));
  EXPECT_EQ(barrier_height_m({{"barrier", "wall"}, {"height", "3.5 m"}}), 3.5);
  EXPECT_FALSE(theme_of_line({{"barrier", "kerb"}}));
  EXPECT_FALSE(theme_of_line({{"barrier", "fence"}, {"location", "roof"}}));
}

}  // namespace
}  // namespace vicus::test
