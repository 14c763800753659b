#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "tests/support/map_checks.hpp"
#include "tests/support/scratch.hpp"

/// Windows, doors, colours and images of houses that come as CityGML and CityJSON, and links between their surfaces.
namespace vicus::test {
namespace {

using Corners = std::vector<std::array<double, 3>>;

/// In UTM 32, 42 m up. NAME: gml:id of surface; of its ring with "-ring".
std::string polygon(const std::string& name, Corners corners) {
  corners.push_back(corners[0]);
  std::string list;
  for (const auto& c : corners) {
    char text[96];
    std::snprintf(text, sizeof text, "%.3f %.3f %.3f ", 571666 + c[0], 5539109 + c[1], 42 + c[2]);
    list += text;
  }
  return "<gml:Polygon gml:id='" + name + "'><gml:exterior><gml:LinearRing gml:id='" + name + "-ring'><gml:posList>" +
         list + "</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon>";
}

std::string bounded(const std::string& kind, const std::string& members) {
  return "<bldg:boundedBy><bldg:" + kind + "><bldg:lod3MultiSurface><gml:MultiSurface>" + members +
         "</gml:MultiSurface></bldg:lod3MultiSurface></bldg:" + kind + "></bldg:boundedBy>";
}

std::string city(const std::string& house, const std::string& more = "") {
  return "<core:CityModel xmlns:core='c' xmlns:gml='g' xmlns:bldg='b' xmlns:app='a' xmlns:xlink='x'><gml:boundedBy>"
         "<gml:Envelope srsName='EPSG:25832'/></gml:boundedBy><core:cityObjectMember><bldg:Building gml:id='house'>" +
         house + "</bldg:Building></core:cityObjectMember>" + more + "</core:CityModel>";
}

const std::string kGround = polygon("ground", {{0, 0, 0}, {0, 8, 0}, {10, 8, 0}, {10, 0, 0}});
const std::string kRoof = polygon("roof", {{0, 0, 5}, {10, 0, 5}, {10, 8, 5}, {0, 8, 5}});
const std::string kWall = polygon("wall", {{0, 0, 0}, {10, 0, 0}, {10, 0, 5}, {0, 0, 5}});

class ModelOpenings : public testing::Test {
 protected:
  Loaded read(const std::string& name, const std::string& text) {
    std::ofstream(scratch_.path() / name) << text;
    return load(std::vector{scratch_.path() / name});
  }
  ScratchDirectory scratch_;
};

double least_up(const ModelOpening& o) {
  return std::min_element(o.corners.begin(), o.corners.end(),
                          [](const ModelPoint& a, const ModelPoint& b) { return a.up_m < b.up_m; })
      ->up_m;
}

TEST_F(ModelOpenings, OfCityGmlAreOneEachElementWhateverItIsMadeOf) {
  const std::string frame = polygon("frame", {{2, 0.1, 1}, {3, 0.1, 1}, {3, 0.1, 2.5}, {2, 0.1, 2.5}});
  const std::string pane = polygon("pane", {{2.1, 0.12, 1.1}, {2.9, 0.12, 1.1}, {2.9, 0.12, 2.4}, {2.1, 0.12, 2.4}});
  const std::string leaf = polygon("leaf", {{5, 0, 0}, {6, 0, 0}, {6, 0, 2.2}, {5, 0, 2.2}});
  const auto opening = [](const std::string& kind, const std::string& members) {
    return "<bldg:opening><bldg:" + kind + "><bldg:lod3MultiSurface>" + members +
           "</bldg:lod3MultiSurface></bldg:" + kind + "></bldg:opening>";
  };
  const std::string house = bounded("GroundSurface", kGround) + bounded("RoofSurface", kRoof) +
                            "<bldg:boundedBy><bldg:WallSurface><bldg:lod3MultiSurface>" + kWall +
                            "</bldg:lod3MultiSurface>" + opening("Window", frame + pane) + opening("Door", leaf) +
                            "</bldg:WallSurface></bldg:boundedBy>";
  const Loaded loaded = read("a.gml", city(house));
  ASSERT_EQ(loaded.map.models.size(), 1u);
  const auto& openings = loaded.map.models.begin()->second.openings;
  ASSERT_EQ(openings.size(), 2u);
  EXPECT_FALSE(openings[0].is_door);
  EXPECT_EQ(openings[0].corners.size(), 8u);
  EXPECT_NEAR(least_up(openings[0]), 1, 1e-9);
  EXPECT_TRUE(openings[1].is_door);
  EXPECT_EQ(loaded.map.objects.size(), 1u) << "the door, on the map";
}

TEST_F(ModelOpenings, LinksGiveSurfacesTheMeaningOfWhereTheyAreReferredTo) {
  // The solid has the surfaces; what they are is said by links, once to a whole MultiSurface.
  const auto link = [](const std::string& name) { return "<gml:surfaceMember xlink:href='#" + name + "'/>"; };
  const std::string window = polygon("window", {{2, 0, 1}, {3, 0, 1}, {3, 0, 2}, {2, 0, 2}});
  const std::string low = polygon("low", {{0, 0, 5}, {10, 0, 5}, {10, 4, 5}, {0, 4, 5}});
  const std::string high = polygon("high", {{0, 4, 5}, {10, 4, 5}, {10, 8, 5}, {0, 8, 5}});
  const std::string house = bounded("GroundSurface", link("ground")) + bounded("RoofSurface", link("roofs")) +
                            bounded("WallSurface", link("wall")) +
                            "<bldg:opening><bldg:Window><bldg:lod3MultiSurface>" + link("window") +
                            "</bldg:lod3MultiSurface></bldg:Window></bldg:opening><bldg:lod3Solid><gml:Solid>" +
                            kGround + "<gml:MultiSurface gml:id='roofs'>" + low + high + "</gml:MultiSurface>" + kWall +
                            window + "</gml:Solid></bldg:lod3Solid>";
  const Loaded loaded = read("a.gml", city(house));
  EXPECT_TRUE(loaded.issues.empty());
  ASSERT_EQ(loaded.map.models.size(), 1u);
  const HouseModel& model = loaded.map.models.begin()->second;
  EXPECT_EQ(model.openings.size(), 1u) << "a window only by its link";
  EXPECT_EQ(model.tops.size(), 2u) << "and none twice";
}

TEST_F(ModelOpenings, LinksToOtherHousesCopyAndLinksToNowhereAreTold) {
  const std::string other = "<core:cityObjectMember><bldg:Building gml:id='other'>" +
                            bounded("GroundSurface", polygon("g2", {{10, 0, 0}, {10, 8, 0}, {20, 8, 0}, {20, 0, 0}})) +
                            bounded("RoofSurface", polygon("r2", {{10, 0, 5}, {20, 0, 5}, {20, 8, 5}, {10, 8, 5}}) +
                                                       "<gml:surfaceMember xlink:href='#nowhere'/>") +
                            bounded("WallSurface", "<gml:surfaceMember xlink:href='#wall'/>") +
                            "</bldg:Building></core:cityObjectMember>";
  const Loaded loaded = read("a.gml", city(bounded("GroundSurface", kGround) + bounded("RoofSurface", kRoof), other));
  EXPECT_EQ(loaded.map.footprints.size(), 2u);
  ASSERT_EQ(loaded.issues.size(), 1u);
  EXPECT_EQ(loaded.issues[0].code, IssueCode::unreadable_feature);
  EXPECT_NE(loaded.issues[0].message.find("refers to 2 surfaces"), std::string::npos) << loaded.issues[0].message;
}

std::string material(const std::string& colour, const std::string& target, const std::string& more = "") {
  return "<app:X3DMaterial><app:diffuseColor>" + colour + "</app:diffuseColor>" + more + "<app:target>#" + target +
         "</app:target></app:X3DMaterial>";
}

TEST_F(ModelOpenings, MaterialsColourWallsAndRoofsButPlainGreyDoesNot) {
  const std::string house =
      bounded("GroundSurface", kGround) + bounded("RoofSurface", kRoof) + bounded("WallSurface", kWall);
  const auto tags = [&](const std::string& materials) {
    return read("a.gml", city(house, materials)).map.footprints.at(0).tags;
  };
  Tags got = tags(material("1 0.5 0", "wall") + material("0.2 0.2 0.2", "roof"));
  EXPECT_EQ(got["building:colour"], "#ff8000");
  EXPECT_EQ(got["roof:colour"], "#333333");
  got = tags(material("0.8 0.8 0.8", "wall") + material("1 0 0", "roof", "<app:isFront>false</app:isFront>"));
  EXPECT_FALSE(got.contains("building:colour"));
  EXPECT_FALSE(got.contains("roof:colour"));
}

TEST_F(ModelOpenings, ImagesLieOnWallsWhereTheirFileIsThere) {
  const auto texture = [](const std::string& file) {
    return "<app:ParameterizedTexture><app:imageURI>" + file +
           "</app:imageURI><app:target uri='#wall'><app:TexCoordList><app:textureCoordinates ring='#wall-ring'>"
           "0 0 0.5 0 0.5 0.25 0 0.25 0 0</app:textureCoordinates></app:TexCoordList></app:target>"
           "</app:ParameterizedTexture>";
  };
  std::ofstream(scratch_.path() / "there.jpg") << "not looked at here";
  const std::string house =
      bounded("GroundSurface", kGround) + bounded("RoofSurface", kRoof) + bounded("WallSurface", kWall);
  const Loaded loaded = read("a.gml", city(house, texture("there.jpg")));
  const auto& photos = loaded.map.models.begin()->second.photos;
  ASSERT_EQ(photos.size(), 1u);
  EXPECT_EQ(photos[0].image, scratch_.path() / "there.jpg");
  ASSERT_EQ(photos[0].corners.size(), 4u);
  EXPECT_EQ(photos[0].places[2], (std::array<double, 2>{0.5, 0.25}));
  EXPECT_TRUE(read("b.gml", city(house, texture("gone.jpg"))).map.models.begin()->second.photos.empty());
}

TEST_F(ModelOpenings, OfCityJsonAreTakenApartWhereOneElementHasMany) {
  std::ofstream(scratch_.path() / "wall.png") << "not looked at here";
  const std::string text =
      R"({"type": "CityJSON", "version": "2.0", "metadata": {"referenceSystem": "EPSG:28992"},
"transform": {"scale": [0.001, 0.001, 0.001], "translate": [90000, 435000, 42]},
"vertices": [[0,0,0],[10000,0,0],[10000,8000,0],[0,8000,0],[0,0,5000],[10000,0,5000],[10000,8000,5000],[0,8000,5000],
[1000,0,1000],[2000,0,1000],[2000,0,2000],[1000,0,2000],[4000,0,1000],[5000,0,1000],[5000,0,2000],[4000,0,2000]],
"appearance": {"materials": [{"name": "m", "diffuseColor": [0, 0.5, 1]}], "textures": [{"type": "PNG", "image": "wall.png"}],
"vertices-texture": [[0,0],[1,0],[1,1],[0,1]]},
"CityObjects": {"house": {"type": "Building", "geometry": [{"type": "MultiSurface", "lod": "3",
"boundaries": [[[3,2,1,0]],[[0,1,5,4]],[[4,5,6,7]],[[8,9,10,11]],[[12,13,14,15]]],
"semantics": {"surfaces": [{"type": "GroundSurface"},{"type": "WallSurface"},{"type": "RoofSurface"},{"type": "Window"}], "values": [0,1,2,3,3]},
"material": {"day": {"values": [null, 0, null, null, null]}},
"texture": {"day": {"values": [[[null]], [[0, 0, 1, 2, 3]], [[null]], [[null]], [[null]]]}}}]}}})";
  const Loaded loaded = read("a.city.json", text);
  ASSERT_EQ(loaded.map.models.size(), 1u);
  const HouseModel& model = loaded.map.models.begin()->second;
  EXPECT_EQ(model.openings.size(), 2u);
  ASSERT_EQ(model.photos.size(), 1u);
  EXPECT_EQ(model.photos[0].places[3], (std::array<double, 2>{0, 1}));
  EXPECT_EQ(loaded.map.footprints[0].tags.at("building:colour"), "#0080ff");
}

}  // namespace
}  // namespace vicus::test
