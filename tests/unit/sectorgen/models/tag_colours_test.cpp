#include "sectorgen/models/tag_colours.hpp"

#include <gtest/gtest.h>

#include <set>

namespace vicus {
namespace {

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
  const Colour plaster = facade_colour(house, FacadeStyle::plaster);
  EXPECT_EQ(facade_colour(house, FacadeStyle::plaster), plaster);
  house.tags["building:colour"] = "no colour at all";
  EXPECT_EQ(facade_colour(house, FacadeStyle::plaster), plaster);
  house.tags["building:material"] = "brick";
  EXPECT_EQ(facade_colour(house, FacadeStyle::plaster), (Colour{0x9c, 0x5a, 0x45}));
  house.tags["building:colour"] = "#102030";
  EXPECT_EQ(facade_colour(house, FacadeStyle::plaster), (Colour{0x10, 0x20, 0x30}));
  house.tags["roof:colour"] = "maroon";
  EXPECT_EQ(roof_colour(house), (Colour{128, 0, 0}));
}

TEST(FacadeColour, VariesFromHouseToHouse) {
  std::set<Colour> facades, roofs;
  for (int i = 0; i < 200; ++i) {
    Building house;
    house.id = std::to_string(i);
    facades.insert(facade_colour(house, FacadeStyle::plaster));
    roofs.insert(roof_colour(house));
  }
  EXPECT_GE(facades.size(), 7u);
  EXPECT_GE(roofs.size(), 6u);
}

}  // namespace
}  // namespace vicus
