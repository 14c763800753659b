#include "sectorgen/sectors/interiors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "city_db/rules.hpp"
#include "sectorgen/geom/polygon.hpp"
#include "sectorgen/sectors/doorway.hpp"
#include "tests/support/built_city.hpp"

namespace vicus {
namespace {

using Place = std::pair<double, double>;

/// A street along y = 0 with one house, 20 x 12 m, north of it; metres east and north of the house's south-west corner.
class Map {
 public:
  Map() {
    way({{-40, -8}, {60, -8}}, {{"highway", "residential"}, {"name", "Gasse"}, {"width", "10"}});
    way({{0, 0}, {20, 0}, {20, 12}, {0, 12}, {0, 0}}, {{"building", "yes"}, {"height", "9"}, {"roof:shape", "flat"}});
    way({{-15, 0}, {-1, 0}, {-1, 12}, {-15, 12}, {-15, 0}}, {{"building", "yes"}, {"height", "9"}});
  }
  Map& way(const std::vector<Place>& line, const Tags& tags) {
    ways_ << "<way id='" << ++ways_count_ << "'>";
    for (const auto& p : line) ways_ << "<nd ref='" << node(p, {}) << "'/>";
    add(ways_, tags);
    ways_ << "</way>\n";
    return *this;
  }
  Map& room(double west, double south, double east, double north, Tags tags = {}) {
    tags.emplace("indoor", "room");
    return way({{west, south}, {east, south}, {east, north}, {west, north}, {west, south}}, tags);
  }
  Map& door(double x, double y, const Tags& tags = {{"indoor", "door"}}) {
    node({x, y}, tags);
    return *this;
  }
  City build() const { return test::city_of_osm("<osm version='0.6'>\n" + nodes_.str() + ways_.str() + "</osm>\n"); }

 private:
  int node(Place p, const Tags& tags) {
    if (const auto known = ids_.find(p); known != ids_.end() && tags.empty()) return known->second;
    const int id = ++nodes_count_;
    ids_[p] = id;
    nodes_ << "<node id='" << id << "' lat='" << 50 + p.second / 111'229.0 << "' lon='" << 10 + p.first / 71'696.0
           << "'>";
    add(nodes_, tags);
    nodes_ << "</node>\n";
    return id;
  }
  static void add(std::ostream& out, const Tags& tags) {
    for (const auto& [k, v] : tags) out << "<tag k='" << k << "' v='" << v << "'/>";
  }
  std::ostringstream nodes_ = precise(), ways_;
  std::map<Place, int> ids_;
  int nodes_count_ = 0, ways_count_ = 0;
  static std::ostringstream precise() {
    std::ostringstream out;
    out.precision(12);
    return out;
  }
};

std::vector<int> codes_of(const City& city) {
  std::vector<int> codes;
  for (const auto& issue : city.issues)
    if (static_cast<int>(issue.code) > 500) codes.push_back(static_cast<int>(issue.code));
  return codes;
}

void expect_rules(const City& city) {
  for (const auto& v : check_rules(city).violations)
    if (v.rule != Rule::budget) ADD_FAILURE() << name_of(v.rule) << " " << v.id << " " << v.message;
}

TEST(Interiors, ARoomBehindADoorToTheStreet) {
  const City city = Map().room(5, 0, 12, 6, {{"name", "Laden"}}).door(8, 0).build();
  EXPECT_EQ(codes_of(city), std::vector<int>{});
  expect_rules(city);
  ASSERT_EQ(city.interiors.size(), 1u);
  ASSERT_EQ(city.doors.size(), 2u);
  const Interior& room = city.interiors[0];
  EXPECT_EQ(room.sector.id, "in-way-4");
  EXPECT_EQ(room.sector.name, "Laden");
  EXPECT_EQ(room.building_id, "way-2");
  EXPECT_EQ(room.source_id, "way/4");
  // 0.3 m of wall to the street, 0.075 m all around else, and a doorway of 1 m x 0.3 m.
  EXPECT_NEAR(area_m2(room.sector.ground), (7 - 0.15) * (6 - 0.3 - 0.075) + 0.3, 0.05);
  EXPECT_DOUBLE_EQ(room.height_m, 2.8);
  const Door& out = city.doors[0];
  EXPECT_EQ(out.sector_id, city.doors[1].to_sector_id);
  EXPECT_EQ(out.to_sector_id, room.sector.id);
  EXPECT_NEAR(std::hypot(out.b.x - out.a.x, out.b.y - out.a.y), 1000, 3);
  EXPECT_GT(out.recess_m, 0);
  EXPECT_EQ(out.recess_m, -city.doors[1].recess_m);
  EXPECT_LT(out.id, out.twin_id);
}

TEST(Interiors, FacadesEndAtTheDoor) {
  const City city = Map().room(5, 0, 12, 6).door(8, 0).build();
  const Door& d = city.doors[0];
  int before = 0, behind = 0;
  for (const Facade& f : city.facades) {
    before += f.b == d.a;
    behind += f.a == d.b;
    EXPECT_TRUE(f.building_id != "way-2" || f.door_bay == -1) << "a painted door beside the real one";
  }
  EXPECT_EQ(before, 1);
  EXPECT_EQ(behind, 1);
}

TEST(Interiors, AnEntranceThatIsACornerOfTheOutline) {
  Map map;
  map.way({{30, 0}, {36, 0}, {44, 0}, {44, 10}, {30, 10}, {30, 0}}, {{"building", "yes"}, {"height", "9"}});
  const City city = map.door(36, 0, {{"entrance", "main"}}).room(30, 0, 44, 10).build();
  EXPECT_EQ(codes_of(city), std::vector<int>{});
  ASSERT_EQ(city.interiors.size(), 1u);
  expect_rules(city);
}

TEST(Interiors, RoomsBehindRooms) {
  const City city = Map()
                        .room(5, 0, 8, 12, {{"indoor", "corridor"}})
                        .room(8, 0, 14, 6)
                        .room(8, 6, 14, 12)
                        .door(6, 0)
                        .door(8, 3)
                        .door(11, 6, {{"door", "hinged"}})
                        .build();
  EXPECT_EQ(codes_of(city), std::vector<int>{});
  expect_rules(city);
  EXPECT_EQ(city.interiors.size(), 3u);
  EXPECT_EQ(city.doors.size(), 6u);
}

TEST(Interiors, OneSideOfAWallBesideADoorIsEnoughForAnother) {
  const City city = Map().room(5, 0, 12, 6).door(7, 0).door(10, 0).build();
  EXPECT_EQ(city.doors.size(), 4u);
  expect_rules(city);
}

TEST(Interiors, WidthsOfDoorsAreThoseOfTheMap) {
  const City city = Map().room(5, 0, 12, 6).door(8, 0, {{"indoor", "door"}, {"width", "1.6 m"}}).build();
  ASSERT_EQ(city.doors.size(), 2u);
  EXPECT_NEAR(std::abs(city.doors[0].b.x - city.doors[0].a.x), 1600, 3);
}

TEST(Interiors, NeedDoorsFromTheStreet) {
  EXPECT_EQ(codes_of(Map().room(5, 0, 12, 6).build()), std::vector<int>{503});
  // A door between two rooms that nobody gets to.
  const City city = Map().room(5, 0, 8, 12).room(8, 0, 14, 12).door(8, 5).build();
  EXPECT_EQ(codes_of(city), (std::vector<int>{503, 503}));
  EXPECT_TRUE(city.interiors.empty());
  EXPECT_TRUE(city.doors.empty());
}

TEST(Interiors, LeaveOutWhatCannotBe) {
  EXPECT_EQ(codes_of(Map().room(50, 0, 56, 6).door(52, 0).build()), std::vector<int>{501});
  EXPECT_EQ(codes_of(Map().room(5, 0, 6, 6).door(5.5, 0).build()), std::vector<int>{502});
  // At the corner of the house there is no room for it; a second one is.
  EXPECT_EQ(codes_of(Map().room(0, 0, 12, 6).door(6, 3).door(8, 0).build()), std::vector<int>{504});
  EXPECT_EQ(codes_of(Map().room(5, 0, 12, 6).door(8, 0).room(5, 0, 12, 6, {{"level", "1"}}).build()),
            std::vector<int>{505});
}

TEST(Interiors, OtherLevelsInALevelListCount) {
  EXPECT_EQ(Map().room(5, 0, 12, 6, {{"level", "-1;0"}}).door(8, 0).build().interiors.size(), 1u);
  EXPECT_EQ(Map().room(5, 0, 12, 6).door(8, 0, {{"indoor", "door"}, {"level", "2"}}).build().interiors.size(), 0u);
}

TEST(Interiors, HaveAViewpointInside) {
  const City city = Map().room(5, 0, 12, 6).door(8, 0).build();
  const auto at = std::find_if(city.viewpoints.begin(), city.viewpoints.end(),
                               [](const Viewpoint& v) { return v.sector_id == "in-way-4"; });
  ASSERT_NE(at, city.viewpoints.end());
  EXPECT_EQ(locate(city.interiors[0].sector.ground, at->at), Side::inside);
  EXPECT_NEAR(std::fmod(at->heading_deg + 1, 360), 1, 0.5) << "it looks north, into the room";
}

TEST(Doorways, AreCutIntoOneEdgeOrNotAtAll) {
  const Ring square{{0, 0}, {4000, 0}, {4000, 4000}, {0, 4000}};
  Ring ring = square;
  EXPECT_EQ(open_doorway(ring, {1000, -300}, {2000, -300}, {0, 1}), std::optional<bool>(true));
  EXPECT_EQ(ring, (Ring{{0, 0}, {1000, 0}, {1000, -300}, {2000, -300}, {2000, 0}, {4000, 0}, {4000, 4000}, {0, 4000}}));
  ring = square;
  EXPECT_EQ(open_doorway(ring, {2000, -300}, {1000, -300}, {0, 1}), std::optional<bool>(false));
  ring = square;
  EXPECT_FALSE(open_doorway(ring, {3500, -300}, {4500, -300}, {0, 1})) << "past the corner";
  EXPECT_FALSE(open_doorway(ring, {3000, -300}, {3990, -300}, {0, 1})) << "no jamb is left";
  EXPECT_FALSE(open_doorway(ring, {1000, -1600}, {2000, -1600}, {0, 1})) << "too deep";
  EXPECT_FALSE(open_doorway(ring, {1000, -10}, {2000, -10}, {0, 1})) << "no wall";
  EXPECT_EQ(ring, square);
}

}  // namespace
}  // namespace vicus
