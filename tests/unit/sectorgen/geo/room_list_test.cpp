#include "sectorgen/geo/room_list.hpp"

#include <gtest/gtest.h>

#include "sectorgen/geom/polygon.hpp"
#include "tests/support/scratch.hpp"

namespace vicus {
namespace {

SourceMap read(const std::string& text) {
  test::ScratchDirectory scratch;
  test::write_bytes(scratch / "rooms.csv", text);
  SourceMap map;
  map.origin = {50, 10};
  read_room_list(scratch / "rooms.csv", map);
  return map;
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const CityError& error) {
    return error.what();
  }
  return "";
}

TEST(RoomList, ReadsWhatQgisExports) {
  const auto map = read(
      "\xef\xbb\xbfName,outline,doors,house,height\n"
      "# a comment\n"
      "\"Diele, hinten\",\"POLYGON ((10 50,10.0001 50,10.0001 50.00005,10 50.00005,10 50))\","
      "\"MULTIPOINT ((10.00005 50),(10.00005 50.00005))\",,3.2\n"
      ",,POINT (10 50),way/7,\n");
  ASSERT_EQ(map.rooms.size(), 2u);
  EXPECT_EQ(map.rooms[0].name, "Diele, hinten");
  EXPECT_EQ(map.rooms[0].source_id, "rooms.csv#3");
  EXPECT_NEAR(area_m2(map.rooms[0].area), 7.17 * 5.56, 0.1);
  ASSERT_EQ(map.rooms[0].doors.size(), 2u);
  EXPECT_NEAR(map.rooms[0].doors[1].y, 5561, 3);
  EXPECT_DOUBLE_EQ(map.rooms[0].height_m, 3.2);
  EXPECT_EQ(map.rooms[1].house, "way/7");
  EXPECT_TRUE(map.rooms[1].area.outer.empty());
  EXPECT_EQ(map.rooms[1].doors, std::vector<PlanPoint>{PlanPoint{}});
}

TEST(RoomList, SaysWhatIsWrongAndWhere) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "expected a table of rooms"},
      {"house,door\nway/1,\n", "line 1: no column is called door"},
      {"house,outline\n,\n", "line 2: expected a house or an outline"},
      {"house,outline\n,POINT (10 50)\n", "line 2: outline: expected WKT"},
      {"outline\n\"POLYGON ((10 50,10.1 50,10 x))\"\n", "outline: expected WKT"},
      {"outline\n\"POLYGON ((10 50,10.1 50,10 50.1)\"\n", "outline: expected WKT"},
      {"outline\n\"POLYGON ((10 50,10.001 50))\"\n", "no single polygon"},
      {"outline\n\"POLYGON ((50 10,50.1 10,50 10.1))\"\n", "longitude, then latitude"},
      {"house,doors\nway/1,LINESTRING (10 50)\n", "doors: expected WKT"},
      {"house,height\nway/1,-2\n", "height: -2 is no height"},
      {"house,height\n\"way/1,3\n", "quotation marks"}};
  for (const auto& [text, said] : cases) EXPECT_NE(refusal(text).find(said), std::string::npos) << refusal(text);
}

}  // namespace
}  // namespace vicus
