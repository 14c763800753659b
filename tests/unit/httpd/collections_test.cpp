#include "httpd/collections.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "httpd/geo_json.hpp"
#include "tests/support/sample_interior.hpp"
#include "tests/unit/httpd/served_city.hpp"

namespace vicus {
namespace {

using Json = nlohmann::json;

class CollectionsOfSampleCity : public testing::Test {
 protected:
  static void SetUpTestSuite() { served_ = new test::ServedCity; }
  static void TearDownTestSuite() { delete served_; }

  HttpResponse get(const std::string& target) { return routes_.respond({"GET", target, {}}); }
  Json json(const std::string& target) {
    const auto response = get(target);
    EXPECT_EQ(response.status, 200) << target;
    return Json::parse(*response.body);
  }
  static std::string link(const Json& json, const std::string& rel) {
    for (const auto& link : json["links"])
      if (link["rel"] == rel) return link["href"];
    return "";
  }

  static test::ServedCity* served_;
  Routes routes_ = served_->routes();
  City city_ = test::sample_city();
};
test::ServedCity* CollectionsOfSampleCity::served_ = nullptr;

TEST_F(CollectionsOfSampleCity, AreLinkedFromTheLandingPageDown) {
  const auto landing = Json::parse(*routes_.respond({"GET", "/", {{"Accept", "application/json"}}}).body);
  const auto collections = json(link(landing, "data"));
  std::set<std::string> ids;
  for (const auto& collection : collections["collections"]) {
    ids.insert(collection["id"]);
    EXPECT_EQ(json(link(collection, "self"))["id"], collection["id"]);
    EXPECT_EQ(json(link(collection, "items"))["type"], "FeatureCollection");
  }
  EXPECT_EQ(ids, (std::set<std::string>{"gates", "houses", "interiors", "sectors"}));
  EXPECT_EQ(json(link(landing, "conformance"))["conformsTo"].size(), 2u);
  const auto api = json(link(landing, "service-desc"));
  EXPECT_EQ(api["openapi"], "3.0.3");
  EXPECT_TRUE(api["paths"].contains("/collections/{collectionId}/items/{featureId}"));
}

TEST_F(CollectionsOfSampleCity, GiveEveryRecordOnceOverThePages) {
  const std::map<std::string, std::size_t> counts = {
      {"sectors", city_.sectors.size()}, {"gates", city_.gates.size()}, {"houses", city_.buildings.size()}};
  for (const auto& [name, count] : counts)
    for (const char* bbox : {"", "&bbox=-180,-90,180,90"}) {
      std::set<std::string> ids;
      std::size_t given = 0;
      for (auto next = "/collections/" + name + "/items?limit=3" + bbox; !next.empty();) {
        const auto page = json(next);
        EXPECT_LE(page["features"].size(), 3u);
        EXPECT_EQ(page["numberReturned"], page["features"].size());
        for (const auto& feature : page["features"]) {
          ++given;
          ids.insert(feature["id"]);
          const auto item = json("/collections/" + name + "/items/" + feature["id"].get<std::string>());
          EXPECT_EQ(item["geometry"], feature["geometry"]);
          EXPECT_EQ(item["properties"], feature["properties"]);
        }
        next = link(page, "next");
      }
      EXPECT_EQ(ids.size(), count) << name;
      EXPECT_EQ(given, count) << name;
    }
}

TEST_F(CollectionsOfSampleCity, GiveWhatMeetsTheBoxAndNothingElse) {
  const GeoFrame frame(city_.origin);
  // A box about the middle of the crossroads: no street beyond its gates.
  const auto a = frame.lat_lon_from_plan({-1000, -1000}), b = frame.lat_lon_from_plan({1000, 1000});
  std::ostringstream target;
  target.precision(12);
  target << "/collections/sectors/items?bbox=" << a.lon_deg << ',' << a.lat_deg << ',' << b.lon_deg << ',' << b.lat_deg;
  const auto inside = json(target.str());
  ASSERT_EQ(inside["features"].size(), 1u);
  EXPECT_EQ(inside["features"][0]["id"], "s-cross");
  EXPECT_EQ(json("/collections/sectors/items?bbox=0,0,1,1")["features"].size(), 0u);
}

TEST_F(CollectionsOfSampleCity, WriteCoordinatesThatLeadBackToTheLattice) {
  const GeoFrame frame(city_.origin);
  for (const auto& sector : city_.sectors) {
    const auto rings = json("/collections/sectors/items/" + sector.id)["geometry"]["coordinates"];
    ASSERT_EQ(rings.size(), 1 + sector.ground.holes.size());
    ASSERT_EQ(rings[0].size(), sector.ground.outer.size() + 1);
    for (std::size_t i = 0; i < sector.ground.outer.size(); ++i) {
      const auto at = frame.lat_lon_from_plan(sector.ground.outer[i]);
      EXPECT_NEAR(rings[0][i][0].get<double>(), at.lon_deg, 6e-10);
      EXPECT_NEAR(rings[0][i][1].get<double>(), at.lat_deg, 6e-10);
    }
  }
}

TEST_F(CollectionsOfSampleCity, RefuseParametersTheyDoNotKnow) {
  const std::string items = "/collections/houses/items?";
  for (const char* query : {"bbox=1,2,3", "bbox=", "bbox=1,2,3,4&bbox=1,2,3,4", "limit=0", "limit=-1", "limit=x",
                            "limit=", "limit=1e3", "offset=-1", "offset=99999999999", "colour=red"})
    EXPECT_EQ(get(items + query).status, 400) << query;
  EXPECT_EQ(get(items + "limit=99999&datetime=2020-01-01T00:00:00Z&f=json").status, 200);
  EXPECT_EQ(json(items + "offset=1000000")["features"].size(), 0u);
}

TEST(CollectionsOfACityWithRooms, HaveThemAsInteriors) {
  const test::ScratchDirectory scratch;
  const City city = test::sample_city_with_interior();
  write_city(scratch / "city.gpkg", city, [] { return std::optional<Artefact>(); });
  Routes routes(scratch / "city.gpkg", std::make_shared<const StaticFiles>(""), std::make_shared<Metrics>());
  const auto rooms = Json::parse(*routes.respond({"GET", "/collections/interiors/items", {}}).body)["features"];
  ASSERT_EQ(rooms.size(), city.interiors.size());
  EXPECT_EQ(rooms[0]["id"], "hall");
  EXPECT_EQ(rooms[0]["properties"]["name"], "Diele");
  EXPECT_EQ(rooms[0]["properties"]["building_id"], "b-8");
  EXPECT_EQ(rooms[0]["properties"]["height_m"], 2.75);
  EXPECT_EQ(rooms[0]["geometry"]["coordinates"][0].size(), city.interiors[0].sector.ground.outer.size() + 1);
  EXPECT_EQ(routes.respond({"GET", "/collections/interiors/items/kitchen", {}}).status, 200);
  EXPECT_EQ(routes.respond({"GET", "/collections/interiors/items/attic", {}}).status, 404);
}

TEST_F(CollectionsOfSampleCity, KeepAwkwardNames) {
  bool found = false;
  const auto page = json("/collections/sectors/items?limit=100");
  for (const auto& feature : page["features"]) found |= feature["properties"]["name"] == test::kAwkwardName;
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace vicus
