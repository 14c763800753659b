#include "sectorgen/visibility/important.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sectorgen/visibility/propose.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/support/scratch.hpp"

namespace vicus {
namespace {

/// The sample city before anybody marked a sector.
City plain_city() {
  City city = test::sample_city();
  for (auto& s : city.sectors) s.importance = Importance::none, s.vicinity_m = 0;
  std::erase_if(city.visible, [](const Visible& v) { return v.reason == VisibleReason::important; });
  return city;
}

/// "id:vicinity" of every sector with this importance.
std::string marked(const City& city, Importance importance) {
  std::string text;
  for (const auto& s : city.sectors)
    if (s.importance == importance)
      text += (text.empty() ? "" : " ") + s.id + ":" + std::to_string(std::lround(s.vicinity_m));
  return text;
}

std::optional<PlanPoint> origin_only(LatLon p) {
  if (p.lat_deg == 47.0707 && p.lon_deg == 15.4395) return PlanPoint{0, 0};
  if (p.lat_deg == 80) return std::nullopt;
  return PlanPoint{500'000'000, 0};
}

struct Read {
  std::vector<AuthorEntry> list;
  std::vector<Issue> issues;
};
Read read_text(const std::string& text) {
  test::ScratchDirectory scratch;
  test::write_bytes(scratch / "list.csv", text);
  Read read;
  read.list = read_author_list(scratch / "list.csv", read.issues);
  return read;
}

TEST(AuthorList, ReadsCsvAndJsonLines) {
  const auto read = read_text(
      "\xef\xbb\xbfplace,vicinity_m\r\n# note\n\n  Place Garibaldi , 300\r\n\"Rue \"\"A\"\", 1er\", "
      "20.5\n48.5,2.25\n48.5,-2.25,0\n"
      "{\"place\": \"r12\"}\n{\"lat\": -1, \"lon\": 2, \"vicinity_m\": 7}\nRue,\n");
  EXPECT_TRUE(read.issues.empty()) << read.issues[0].message;
  ASSERT_EQ(read.list.size(), 7u);
  const auto expect = [&](std::size_t i, const char* place, double vicinity_m, const char* source_id) {
    EXPECT_EQ(read.list[i].place, place);
    EXPECT_EQ(read.list[i].vicinity_m, vicinity_m);
    EXPECT_EQ(read.list[i].source_id, source_id);
  };
  expect(0, "Place Garibaldi", 300, "list.csv#4");
  expect(1, "Rue \"A\", 1er", 20.5, "list.csv#5");
  expect(2, "", 500, "list.csv#6");
  EXPECT_EQ(read.list[2].at->lon_deg, 2.25);
  expect(3, "", 0, "list.csv#7");
  expect(4, "r12", 500, "list.csv#8");
  expect(5, "", 7, "list.csv#9");
  EXPECT_EQ(read.list[5].at->lat_deg, -1);
  expect(6, "Rue", 500, "list.csv#10");
}

TEST(AuthorList, LeavesOutLinesItCannotReadAndSaysWhy) {
  const std::pair<const char*, const char*> cases[] = {
      {"\"Rue", "quotation marks"},
      {"\"Rue\" A", "quotation marks"},
      {"Rue,far", "'far' is no number"},
      {"Rue,-1", "not between 0 and"},
      {"Rue,1e9", "not between 0 and"},
      {"Rue,nan", "'nan' is no number"},
      {"Rue,1,2", "too many fields"},
      {",20", "names no place"},
      {"91,0", "no place on earth"},
      {"1,181,5", "no place on earth"},
      {"{", "no JSON object"},
      {"{\"lat\": 1}", "either place, or lat and lon"},
      {"{\"place\": \"a\", \"lat\": 1, \"lon\": 1}", "either place, or lat and lon"},
      {"{\"place\": 7}", "either place"},
      {"{\"place\": \"a\", \"vicinity_m\": \"b\"}", "vicinity_m is no number"}};
  for (const auto& [line, message] : cases) {
    const auto read = read_text(std::string(line) + "\nRue A\n");
    ASSERT_EQ(read.issues.size(), 1u) << line;
    EXPECT_EQ(read.issues[0].code, IssueCode::unreadable_feature);
    EXPECT_EQ(read.issues[0].source_id, "list.csv#1");
    EXPECT_NE(read.issues[0].message.find(message), std::string::npos) << read.issues[0].message;
    ASSERT_EQ(read.list.size(), 1u) << line;
    EXPECT_EQ(read.list[0].place, "Rue A");
  }
  std::vector<Issue> issues;
  EXPECT_THROW(read_author_list("/nowhere/list.csv", issues), CityError);
  EXPECT_THROW(read_author_list("/tmp", issues), CityError);
}

TEST(MarkImportant, MarksIdsNamesAndPlacesAndNamesWhatItDoesNotFind) {
  const std::string path = std::string(VICUS_TESTS) + "/fixtures/issues/104_unknown_place.csv";
  std::vector<Issue> issues;
  City city = plain_city();
  const auto list = read_author_list(path, issues);
  mark_author_list(city, list, origin_only, issues);
  EXPECT_EQ(marked(city, Importance::author), "s-cross:80 s-north:500 s-south:500 s-yard:250");
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].code, IssueCode::unknown_place);
  EXPECT_EQ(issues[0].source_id, "104_unknown_place.csv#6");
  EXPECT_NE(issues[0].message.find("'Nirgendweg'"), std::string::npos);
  EXPECT_NE(issues[0].message.find("--labels"), std::string::npos);
}

TEST(MarkImportant, NamesPlacesOutOfTheCityAndOutOfTheLattice) {
  City city = plain_city();
  std::vector<Issue> issues;
  mark_author_list(city, {{"", LatLon{10, 10}, 500, "l#1"}, {"", LatLon{80, 10}, 500, "l#2"}}, origin_only, issues);
  EXPECT_EQ(marked(city, Importance::author), "") << "sectors without a name are not meant";
  ASSERT_EQ(issues.size(), 2u);
  EXPECT_EQ(issues[0].at, (PlanPoint{500'000'000, 0}));
  EXPECT_NE(issues[1].message.find("80.000000,10.000000 lies in no sector, and"), std::string::npos);
}

TEST(MarkImportant, TakesTheNearestSectorOfAPlaceInAHouse) {
  const auto marked_at = [](PlanPoint at) {
    City city = plain_city();
    std::vector<Issue> issues;
    mark_author_list(
        city, {{"", LatLon{1, 1}, 500, "l#1"}}, [&](LatLon) { return at; }, issues);
    return marked(city, Importance::author) + (issues.empty() ? "" : "issue");
  };
  EXPECT_EQ(marked_at({-30'000, -10'000}), "s-main-w:500") << "in the church b-10";
  EXPECT_EQ(marked_at({8'000, 30'000}), "s-north:500") << "in b-6, 3 m from the street and 4 m from the yard";
  EXPECT_EQ(marked_at({31'500, 0}), "s-main-e:500") << "on the island, a hole of its ground";
  EXPECT_EQ(marked_at({-109'999, 0}), "s-main-w:500");
  EXPECT_EQ(marked_at({-110'000, 0}), "issue") << "50 m from the street's end";
}

TEST(MarkImportant, KeepsWhatAPersonMarkedInTheCityBefore) {
  City previous = plain_city(), city = plain_city();
  previous.sectors[0].importance = Importance::author;
  previous.sectors[0].vicinity_m = 75;
  previous.sectors[1].importance = Importance::proposed;
  previous.sectors.push_back(previous.sectors[0]);
  previous.sectors.back().id = "s-gone";
  std::vector<Issue> issues;
  mark_important(city, {{}, origin_only, &previous}, issues);
  EXPECT_EQ(marked(city, Importance::author), "s-cross:75");
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].code, IssueCode::unknown_place);
  EXPECT_NE(issues[0].message.find("s-gone"), std::string::npos);
  City again = plain_city();
  issues.clear();
  mark_important(again, {{{"s-cross", {}, 0, "l#1"}}, origin_only, &previous}, issues);
  EXPECT_EQ(marked(again, Importance::author), "") << "vicinity 0 takes the mark away";
}

TEST(ProposeImportant, MarksTheBestAndLeavesThePersonsMarks) {
  City city = plain_city();
  propose_important(city);
  EXPECT_EQ(marked(city, Importance::proposed), "s-cross:500") << "most ways lead over the crossroads";
  city = plain_city();
  for (auto& s : city.sectors)
    if (s.id == "s-cross") s.importance = Importance::author, s.vicinity_m = 9;
  propose_important(city);
  EXPECT_EQ(marked(city, Importance::author), "s-cross:9");
  EXPECT_EQ(marked(city, Importance::proposed), "s-main-w:500") << "the church shows its longest facade there";
}

/// A street of `count` sectors in a row, each 10 m long; those in `squares` are squares.
City row_of_sectors(int count, const std::vector<int>& squares) {
  City city;
  for (int i = 0; i < count; ++i) {
    Sector s;
    s.id = "s" + std::to_string(1000 + i);
    const int x = 10'000 * i;
    s.ground.outer = {{x, 0}, {x + 10'000, 0}, {x + 10'000, 10'000}, {x, 10'000}};
    if (std::find(squares.begin(), squares.end(), i) != squares.end()) s.kind = SectorKind::square;
    city.sectors.push_back(s);
    if (i == 0) continue;
    const auto before = city.sectors[city.sectors.size() - 2].id;
    city.gates.push_back({s.id + "w", s.id, before, s.id + "e", GateKind::street, {{x, 10'000}, {x, 0}}});
    city.gates.push_back({s.id + "e", before, s.id, s.id + "w", GateKind::street, {{x, 0}, {x, 10'000}}});
  }
  return city;
}

TEST(ProposeImportant, MarksThreeInAHundredWithFallingVicinity) {
  City city = row_of_sectors(200, {3, 196});
  propose_important(city);
  EXPECT_EQ(marked(city, Importance::proposed), "s1003:500 s1098:200 s1099:300 s1100:300 s1101:200 s1196:500");
  City again = row_of_sectors(200, {3, 196});
  std::reverse(again.sectors.begin(), again.sectors.end());
  propose_important(again);
  EXPECT_EQ(marked(again, Importance::proposed), "s1196:500 s1101:200 s1100:300 s1099:300 s1098:200 s1003:500");
}

TEST(ProposeImportant, TakesNothingFromNothing) {
  City city;
  propose_important(city);
  city = row_of_sectors(2, {});
  propose_important(city);
  EXPECT_EQ(marked(city, Importance::proposed), "");
}

TEST(AddImportant, ListsAnAuthorsSectorInItsVicinityOnce) {
  City city = row_of_sectors(30, {});
  city.sectors[10].importance = Importance::author;
  city.sectors[10].vicinity_m = 25;
  city.sectors[20].importance = Importance::proposed;
  city.sectors[20].vicinity_m = 500;
  for (int i = 9; i <= 11; ++i)
    city.visible.push_back({"s" + std::to_string(1000 + i), "s1010", VisibleReason::gate, true, {}});
  add_important(city);
  // The middles of s1007 and s1013 are 25 m from the ends of s1010; s1009 and s1011 list it already.
  std::vector<std::string> added;
  for (const auto& v : city.visible)
    if (v.reason == VisibleReason::important) {
      EXPECT_EQ(v.visible_sector_id, "s1010");
      EXPECT_TRUE(v.is_proven);
      added.push_back(v.sector_id);
    }
  EXPECT_EQ(added, (std::vector<std::string>{"s1007", "s1008", "s1012", "s1013"}));
  const auto rows = city.visible.size();
  add_important(city);
  EXPECT_EQ(city.visible.size(), rows);
}

TEST(AddImportant, AddsNothingForProposals) {
  City city = row_of_sectors(30, {5});
  propose_important(city);
  ASSERT_NE(marked(city, Importance::proposed), "");
  add_important(city);
  EXPECT_TRUE(city.visible.empty());
}

}  // namespace
}  // namespace vicus
