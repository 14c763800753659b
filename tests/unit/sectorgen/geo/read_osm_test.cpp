#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "tests/support/map_checks.hpp"
#include "tests/support/scratch.hpp"

namespace vicus::test {
namespace {

/// OSM XML line by line. Places in metres from 50 N 10 E, roughly.
class OsmText {
 public:
  OsmText& node(int id, double east, double north, const Tags& tags = {}) {
    nodes_ += "<node id=\"" + std::to_string(id) + "\" version=\"1\" lat=\"" + std::to_string(50 + north / 111'229) +
              "\" lon=\"" + std::to_string(10 + east / 71'695) + "\">" + text_of(tags) + "</node>\n";
    return *this;
  }
  /// Four nodes, ids from `first`, counter-clockwise.
  OsmText& corners(int first, double east, double north, double size) {
    return node(first, east, north)
        .node(first + 1, east + size, north)
        .node(first + 2, east + size, north + size)
        .node(first + 3, east, north + size);
  }
  OsmText& way(int id, const std::vector<int>& nodes, const Tags& tags) {
    ways_ += "<way id=\"" + std::to_string(id) + "\" version=\"1\">";
    for (int node : nodes) ways_ += "<nd ref=\"" + std::to_string(node) + "\"/>";
    ways_ += text_of(tags) + "</way>\n";
    return *this;
  }
  OsmText& relation(int id, const std::vector<std::pair<int, std::string>>& ways, const Tags& tags) {
    relations_ += "<relation id=\"" + std::to_string(id) + "\" version=\"1\">";
    for (const auto& [way, role] : ways)
      relations_ += "<member type=\"way\" ref=\"" + std::to_string(way) + "\" role=\"" + role + "\"/>";
    relations_ += text_of(tags) + "</relation>\n";
    return *this;
  }
  Loaded load() const {
    const ScratchDirectory scratch;
    write_bytes(scratch / "map.osm", "<osm version=\"0.6\">\n" + nodes_ + ways_ + relations_ + "</osm>\n");
    return test::load({scratch / "map.osm"});
  }

 private:
  static std::string text_of(const Tags& tags) {
    std::string text;
    for (const auto& [key, value] : tags) text += "<tag k=\"" + key + "\" v=\"" + value + "\"/>";
    return text;
  }
  std::string nodes_, ways_, relations_;
};

const Tags kHouse = {{"building", "yes"}, {"height", "12"}};
const Tags kHouseRelation = {{"type", "multipolygon"}, {"building", "yes"}, {"height", "12"}};

TEST(ReadOsm, ACourtyardBecomesAHole) {
  const Loaded loaded = OsmText()
                            .corners(1, 0, 0, 40)
                            .corners(5, 10, 10, 20)
                            .way(1, {1, 2, 3, 4, 1}, {})
                            .way(2, {5, 6, 7, 8, 5}, {})
                            .relation(7, {{1, "outer"}, {2, "inner"}}, kHouseRelation)
                            .load();
  ASSERT_EQ(loaded.map.footprints.size(), 1u);
  const Footprint& house = loaded.map.footprints[0];
  EXPECT_EQ(house.source_id, "relation/7");
  ASSERT_EQ(house.area.holes.size(), 1u);
  EXPECT_NEAR(area_by_geos_m2(house.area), 40 * 40 - 20 * 20, 15);
  EXPECT_EQ(broken_promise(loaded.map), "");
  EXPECT_TRUE(loaded.issues.empty());
}

TEST(ReadOsm, AnOutlineOfSeveralWaysIsJoinedAndSeveralOutlinesGiveSeveralFootprints) {
  const Loaded loaded = OsmText()
                            .corners(1, 0, 0, 40)
                            .corners(5, 100, 0, 20)
                            .way(1, {1, 2, 3}, {})
                            .way(2, {3, 4, 1}, {})
                            .way(3, {5, 6, 7, 8, 5}, {})
                            .relation(7, {{1, "outer"}, {2, "outer"}, {3, "outer"}}, kHouseRelation)
                            .load();
  ASSERT_EQ(loaded.map.footprints.size(), 2u);
  EXPECT_EQ(loaded.map.footprints[0].source_id, loaded.map.footprints[1].source_id);
  EXPECT_TRUE(loaded.issues.empty());
}

TEST(ReadOsm, OldMultipolygonsTakeTheTagsOfTheirOutline) {
  const Loaded loaded = OsmText()
                            .corners(1, 0, 0, 40)
                            .corners(5, 10, 10, 20)
                            .way(1, {1, 2, 3, 4, 1}, kHouse)
                            .way(2, {5, 6, 7, 8, 5}, {})
                            .relation(7, {{1, "outer"}, {2, "inner"}}, {{"type", "multipolygon"}})
                            .load();
  ASSERT_EQ(loaded.map.footprints.size(), 1u);
  EXPECT_EQ(loaded.map.footprints[0].area.holes.size(), 1u);
}

TEST(ReadOsm, ARelationThatIsNoPolygonGivesItsClosedWaysAndAnIssue) {
  const Loaded loaded = OsmText()
                            .corners(1, 0, 0, 40)
                            .corners(5, 100, 0, 20)
                            .way(1, {1, 2, 3, 4, 1}, {})
                            .way(2, {5, 6, 7}, {})
                            .relation(7, {{1, "outer"}, {2, "outer"}}, kHouseRelation)
                            .load();
  EXPECT_EQ(loaded.map.footprints.size(), 1u);
  EXPECT_EQ(loaded.count(IssueCode::ring_open), 1u);
}

TEST(ReadOsm, WaysWithMissingNodesAreLeftOutWithAnIssue) {
  const Loaded loaded =
      OsmText().corners(1, 0, 0, 40).way(1, {1, 2, 3, 4, 1}, kHouse).way(2, {1, 2, 99, 1}, kHouse).load();
  EXPECT_EQ(loaded.map.footprints.size(), 1u);
  EXPECT_EQ(loaded.count(IssueCode::incomplete_relation), 1u);
}

TEST(ReadOsm, StreetsCarryWhatTheirTagsSay) {
  const Loaded loaded =
      OsmText()
          .corners(1, 0, 0, 40)
          .way(1, {1, 2},
               {{"highway", "residential"}, {"name", "Rue &quot;du&quot; &lt;Caire&gt; &amp; Co"}, {"width", "7"}})
          .way(2, {2, 3}, {{"highway", "footway"}, {"tunnel", "building_passage"}})
          .way(3, {3, 4}, {{"highway", "steps"}, {"bridge", "yes"}})
          .way(4, {4, 1}, {{"highway", "footway"}})
          .load();
  ASSERT_EQ(loaded.map.axes.size(), 3u);
  EXPECT_EQ(loaded.map.axes[0].name, "Rue \"du\" <Caire> & Co");
  EXPECT_EQ(loaded.map.axes[0].kind, "residential");
  EXPECT_EQ(loaded.map.axes[0].width_m, 7);
  EXPECT_FALSE(loaded.map.axes[0].is_passage);
  EXPECT_TRUE(loaded.map.axes[1].is_passage);
  EXPECT_TRUE(loaded.map.axes[2].is_steps);
  EXPECT_TRUE(loaded.map.axes[2].is_bridge);
}

TEST(ReadOsm, APassageMayRunThroughAHouse) {
  const auto with = [](const Tags& street) {
    return OsmText()
        .corners(1, 0, 0, 20)
        .node(5, -30, 10)
        .node(6, 50, 10)
        .way(1, {1, 2, 3, 4, 1}, kHouse)
        .way(2, {5, 6}, street)
        .load()
        .count(IssueCode::building_in_street);
  };
  EXPECT_EQ(with({{"highway", "residential"}}), 1u);
  EXPECT_EQ(with({{"highway", "residential"}, {"tunnel", "building_passage"}}), 0u);
  EXPECT_EQ(with({{"highway", "residential"}, {"covered", "yes"}}), 0u);
}

TEST(ReadOsm, WallsAreOpenAtGatesAndWhereWaysCross) {
  const Loaded loaded = OsmText()
                            .node(1, 0, 0)
                            .node(2, 10, 0, {{"barrier", "gate"}})
                            .node(3, 20, 0)
                            .node(4, 30, 0)
                            .node(5, 20, 20)
                            .way(1, {1, 2, 3, 4}, {{"barrier", "wall"}, {"height", "3"}})
                            .way(2, {3, 5}, {{"highway", "footway"}})
                            .way(3, {1, 2}, {{"barrier", "fence"}})
                            .load();
  ASSERT_EQ(loaded.map.barriers.size(), 2u);
  const Barrier& wall = loaded.map.barriers[0];
  EXPECT_TRUE(wall.is_wall);
  EXPECT_EQ(wall.height_m, 3);
  ASSERT_EQ(wall.openings.size(), 2u);
  EXPECT_EQ(wall.openings[0], wall.line[1]);
  EXPECT_EQ(wall.openings[1], wall.line[2]);
  EXPECT_FALSE(loaded.map.barriers[1].is_wall);
}

TEST(ReadOsm, AreasAndFencedAreasAreBoth) {
  const Loaded loaded = OsmText()
                            .corners(1, 0, 0, 40)
                            .corners(5, 100, 0, 40)
                            .corners(9, 200, 0, 40)
                            .corners(13, 300, 0, 40)
                            .way(1, {1, 2, 3, 4, 1}, {{"leisure", "park"}, {"barrier", "fence"}, {"name", "Park"}})
                            .way(2, {5, 6, 7, 8, 5}, {{"highway", "pedestrian"}, {"area", "yes"}})
                            .way(3, {9, 10, 11, 12, 9}, {{"natural", "water"}})
                            .way(4, {13, 14, 15, 16, 13}, {{"highway", "residential"}, {"junction", "roundabout"}})
                            .corners(17, 400, 0, 40)
                            .way(5, {17, 18, 19, 20, 17}, {{"man_made", "bridge"}, {"layer", "1"}})
                            .load();
  ASSERT_EQ(loaded.map.areas.size(), 4u);
  EXPECT_EQ(loaded.map.areas[0].kind, AreaKind::park);
  EXPECT_EQ(loaded.map.areas[0].name, "Park");
  EXPECT_EQ(loaded.map.areas[1].kind, AreaKind::square);
  EXPECT_EQ(loaded.map.areas[2].kind, AreaKind::water);
  EXPECT_EQ(loaded.map.areas[3].kind, AreaKind::deck);
  ASSERT_EQ(loaded.map.barriers.size(), 1u);
  EXPECT_EQ(loaded.map.barriers[0].line.front(), loaded.map.barriers[0].line.back());
  ASSERT_EQ(loaded.map.axes.size(), 1u);
  EXPECT_EQ(loaded.map.axes[0].line.front(), loaded.map.axes[0].line.back());
}

TEST(ReadOsm, AnOutlineAndItsPartsAreBothKept) {
  const Loaded loaded = OsmText()
                            .corners(1, 0, 0, 40)
                            .corners(5, 10, 10, 20)
                            .way(1, {1, 2, 3, 4, 1}, kHouse)
                            .way(2, {5, 6, 7, 8, 5}, {{"building:part", "yes"}, {"height", "30"}, {"min_height", "12"}})
                            .load();
  ASSERT_EQ(loaded.map.footprints.size(), 2u);
  EXPECT_FALSE(loaded.map.footprints[0].is_part);
  EXPECT_TRUE(loaded.map.footprints[1].is_part);
  EXPECT_EQ(loaded.map.footprints[1].base_m, 12);
  EXPECT_TRUE(loaded.issues.empty());
}

TEST(ReadOsm, PointsAreKeptWithTheirTags) {
  const Loaded loaded = OsmText()
                            .corners(1, 0, 0, 40)
                            .way(1, {1, 2, 3, 4, 1}, kHouse)
                            .node(9, 50, 0, {{"natural", "tree"}, {"height", "8 m"}, {"species", "Tilia"}})
                            .load();
  ASSERT_EQ(loaded.map.objects.size(), 1u);
  EXPECT_EQ(loaded.map.objects[0].kind, "tree");
  EXPECT_EQ(loaded.map.objects[0].height_m, 8);
  EXPECT_EQ(loaded.map.objects[0].tags.at("species"), "Tilia");
  EXPECT_EQ(loaded.map.objects[0].source_id, "node/9");
}

TEST(ReadOsm, SaysWhoseDataItIs) {
  const Loaded loaded = OsmText().corners(1, 0, 0, 40).way(1, {1, 2, 3, 4, 1}, kHouse).load();
  EXPECT_EQ(loaded.map.licences, std::vector<std::string>{"© OpenStreetMap contributors, ODbL 1.0"});
}

}  // namespace
}  // namespace vicus::test
