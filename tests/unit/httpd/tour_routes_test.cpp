#include "httpd/tour_routes.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/httpd/served_city.hpp"

namespace vicus {
namespace {

/// A desk with one answer for each question.
TourDesk some_desk(TourQuery& asked) {
  TourDesk desk;
  desk.tour = [&asked](const TourQuery& query) -> TourAnswer {
    asked = query;
    if (query.from == "nowhere") return TourProblem{TourProblem::Kind::unknown_place, "There is no nowhere."};
    if (query.from == "island") return TourProblem{TourProblem::Kind::not_connected, "No way leads off the island."};
    if (query.from == "?") return TourProblem{TourProblem::Kind::nonsense, "That is no place."};
    Tour tour;
    tour.name = "A – B";
    tour.stops.resize(2);
    tour.points = {{{-50'000, 0}, 0, 0}, {{-10'000, 0}, 0, 40}};
    tour.sectors = {{"s-main-w", "Main", 0}, {"s-cross", "", 30}};
    tour.steps = {{TourTurn::start, "Start.", "Main", 0, 40}, {TourTurn::arrive, "There.", "", 40, 0}};
    tour.length_m = 40;
    tour.duration_s = 40 / kWalkingSpeed_m_s;
    return tour;
  };
  desk.search = [](const std::string& typed, std::size_t limit) {
    std::vector<TourPlace> places(std::min<std::size_t>(limit, 3));
    for (auto& place : places) place.name = typed;
    return places;
  };
  desk.proposals = [] { return std::vector<TourProposal>{{"short", "A short walk", {}, 120, 90}}; };
  return desk;
}

class TourRoutes : public testing::Test {
 protected:
  nlohmann::json get(const std::string& target, int status, const char* media_type = "application/json") {
    const auto response = routes_.respond({"GET", target, {}});
    EXPECT_EQ(response.status, status) << target;
    EXPECT_EQ(field_of(response.fields, "Content-Type"), status == 200 ? media_type : "application/problem+json")
        << target;
    return nlohmann::json::parse(*response.body, nullptr, false);
  }

  test::ServedCity served_;
  TourQuery asked_;
  Routes routes_{served_.path(), std::make_shared<const StaticFiles>(served_.scratch / "x_ite"),
                 std::make_shared<Metrics>(), nullptr, some_desk(asked_)};
};

TEST_F(TourRoutes, GiveATour) {
  const auto tour = get("/tours?from=Rue%20Haute&to=12.5,3&via=a&via=b&round=1", 200);
  EXPECT_EQ(tour["length"], 40);
  EXPECT_EQ(tour["sectors"][1]["id"], "s-cross");
  EXPECT_EQ(tour["steps"][0]["turn"], "start");
  EXPECT_EQ(tour["points"][1], nlohmann::json::array({-10, 0, 0, 40}));
  EXPECT_EQ(asked_.from, "Rue Haute");
  EXPECT_EQ(asked_.via, (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(asked_.is_round);
}

TEST_F(TourRoutes, ListReadyMadeTours) { EXPECT_EQ(get("/tours", 200)["tours"][0]["id"], "short"); }

TEST_F(TourRoutes, RefuseNonsenseByKind) {
  for (const char* target :
       {"/tours?from=a", "/tours?to=a", "/tours?from=a&to=b&from=c", "/tours?from=a&to=b&round=2", "/tours?form=a&to=b",
        "/tours?tour=short&from=a", "/tours.x3d", "/tours?from=%3F&to=b", "/search",
        "/search?q=", "/search?q=a&limit=0", "/search?q=a&limit=51", "/search?q=a&q=b", "/search?x=a"})
    get(target, 400);
  get("/search?q=" + std::string(121, 'a'), 400);
  EXPECT_EQ(get("/tours?from=nowhere&to=b", 404)["detail"], "There is no nowhere.");
  EXPECT_EQ(get("/tours?from=island&to=b", 409)["title"], "Conflict");
}

TEST_F(TourRoutes, AnimateATourAsAWorld) {
  const auto response = routes_.respond({"GET", "/tours.x3d?from=a&to=b", {}});
  ASSERT_EQ(response.status, 200);
  EXPECT_EQ(field_of(response.fields, "Content-Type"), "model/x3d+xml");
  for (const char* part : {"TOUR_EYE", "PositionInterpolator", "OrientationInterpolator", "sectors/s-main-w.x3d",
                           "sectors/s-cross.x3d", "fromNode='TOUR_EYE'"})
    EXPECT_NE(response.body->find(part), std::string::npos) << part;
}

TEST_F(TourRoutes, SearchWithinTheLimit) {
  EXPECT_EQ(get("/search?q=Haut", 200)["results"].size(), 3u);
  EXPECT_EQ(get("/search?q=Haut&limit=2", 200)["results"].size(), 2u);
}

TEST(ToursWithoutADesk, AreNotThere) {
  const test::ServedCity served;
  auto routes = served.routes();
  EXPECT_EQ(routes.respond({"GET", "/tours", {}}).status, 404);
  EXPECT_EQ(routes.respond({"GET", "/search?q=a", {}}).status, 404);
}

}  // namespace
}  // namespace vicus
