#include "sectorgen/models/tag_colours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace vicus {
namespace {

const RegionStyle& kElsewhere = region_style({});

TEST(ParseColour, ReadsNamesAndHexDigits) {
  EXPECT_EQ(parse_colour("#c8b490"), (Colour{0xc8, 0xb4, 0x90}));
  EXPECT_EQ(parse_colour("#FA3"), (Colour{0xff, 0xaa, 0x33}));
  EXPECT_EQ(parse_colour("Light_Grey"), (Colour{211, 211, 211}));
  EXPECT_EQ(parse_colour("yellowgreen"), (Colour{0x9a, 0xcd, 0x32}));
  EXPECT_EQ(parse_colour("red;white"), std::nullopt);
  EXPECT_EQ(parse_colour("#12345"), std::nullopt);
  EXPECT_EQ(parse_colour("#12345g"), std::nullopt);
  EXPECT_EQ(parse_colour(""), std::nullopt);
}

TEST(HexOf, IsTheInverseOfParseColour) {
  for (int v = 0; v < 256; ++v) {
    const Colour c{static_cast<std::uint8_t>(v), static_cast<std::uint8_t>(255 - v), 7};
    EXPECT_EQ(parse_colour(hex_of(c)), c);
  }
}

TEST(FacadeColour, ComesFromTheTagElseFromThePaletteSteadyById) {
  Building house;
  house.id = "way/12";
  const Colour plaster = facade_colour(house, FacadeStyle::plaster, kElsewhere);
  EXPECT_EQ(facade_colour(house, FacadeStyle::plaster, kElsewhere), plaster);
  house.tags["building:colour"] = "no colour at all";
  EXPECT_EQ(facade_colour(house, FacadeStyle::plaster, kElsewhere), plaster);
  house.tags["building:material"] = "brick";
  EXPECT_EQ(facade_colour(house, FacadeStyle::plaster, kElsewhere), (Colour{0x9c, 0x5a, 0x45}));
  house.tags["building:colour"] = "#102030";
  EXPECT_EQ(facade_colour(house, FacadeStyle::plaster, kElsewhere), (Colour{0x10, 0x20, 0x30}));
  house.tags["roof:colour"] = "maroon";
  EXPECT_EQ(roof_colour(house, kElsewhere), (Colour{128, 0, 0}));
}

TEST(FacadeColour, VariesFromHouseToHouse) {
  std::set<Colour> facades, roofs;
  for (int i = 0; i < 200; ++i) {
    Building house;
    house.id = std::to_string(i);
    facades.insert(facade_colour(house, FacadeStyle::plaster, kElsewhere));
    roofs.insert(roof_colour(house, kElsewhere));
  }
  EXPECT_GE(facades.size(), 7u);
  EXPECT_GE(roofs.size(), 6u);
}

TEST(RoofColour, IsOfFeltWhereTheRoofIsFlat) {
  for (const LatLon place : {LatLon{48.88, 2.34}, LatLon{51.51, -0.13}, LatLon{52.37, 4.9}, LatLon{52.52, 13.4}}) {
    const RegionStyle& region = region_style(place);
    Building house;
    house.id = "way/7";
    const auto is_of = [&](std::span<const std::uint32_t> palette) {
      const Colour colour = roof_colour(house, region);
      return std::any_of(palette.begin(), palette.end(), [&](std::uint32_t rgb) { return colour_of(rgb) == colour; });
    };
    house.roof_shape = "flat";
    EXPECT_TRUE(is_of(region.flat_roofs)) << region.name;
    house.roof_shape = "gabled";
    EXPECT_TRUE(is_of(region.steep_roofs)) << region.name;
  }
}

TEST(RegionStyle, IsTheSmallestThatHasThePlace) {
  EXPECT_EQ(region_style({48.88, 2.34}).name, "Paris");
  EXPECT_TRUE(region_style({48.88, 2.34}).has_mansards);
  EXPECT_EQ(region_style({51.51, -0.13}).name, "the British Isles");
  EXPECT_EQ(region_style({51.92, 4.48}).name, "the Low Countries");
  EXPECT_EQ(region_style({41.9, 12.5}).name, "the Mediterranean");
  EXPECT_EQ(region_style({47.07, 15.44}).name, "Central Europe");
  EXPECT_FALSE(region_style({47.07, 15.44}).has_mansards);
}

}  // namespace
}  // namespace vicus
