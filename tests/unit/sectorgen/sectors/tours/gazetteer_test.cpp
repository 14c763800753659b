#include "sectorgen/sectors/tours/gazetteer.hpp"

#include <gtest/gtest.h>

#include <random>

#include "city_db/store.hpp"
#include "sectorgen/sectors/tours/folded_text.hpp"
#include "sectorgen/sectors/tours/guide.hpp"
#include "sectorgen/sectors/tours/named_places.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/support/sample_interior.hpp"
#include "tests/support/scratch.hpp"

namespace vicus {
namespace {

using Words = std::vector<std::string>;

TEST(FoldedWords, LoseAccentsCaseAndAbbreviations) {
  EXPECT_EQ(folded_words("Rue de l'Écrivain"), (Words{"rue", "de", "l", "ecrivain"}));
  EXPECT_EQ(folded_words("Große Hamburger Str."), (Words{"grosse", "hamburger", "strasse"}));
  EXPECT_EQ(folded_words("Friedrichstr. 12a"), (Words{"friedrichstrasse", "12a"}));
  EXPECT_EQ(folded_words("Łódź, Œuvre Ĳssel"), (Words{"lodz", "oeuvre", "ijssel"}));
  EXPECT_EQ(folded_words("Пушкинская ΑΘΗΝΑ"), (Words{"пушкинская", "αθηνα"}));
  EXPECT_EQ(folded_words("\xff\xfe \xc3"), Words{});
  EXPECT_EQ(folded_words(""), Words{});
}

TEST(Fit, RanksSameOverBeginningOverErrors) {
  EXPECT_EQ(fit("haute", "haute"), 1);
  EXPECT_GT(fit("haut", "haute"), fit("huate", "haute"));
  EXPECT_GT(fit("hautw", "haute"), 0);   // wrong
  EXPECT_GT(fit("haue", "haute"), 0);    // missing
  EXPECT_GT(fit("hauute", "haute"), 0);  // too many
  EXPECT_GT(fit("friedrihcsrtasse", "friedrichstrasse"), 0);
  EXPECT_EQ(fit("basse", "haute"), 0);
  EXPECT_EQ(fit("rue", "run"), 0);  // too short to err
  EXPECT_EQ(fit("12", "13"), 0);
  EXPECT_EQ(fit("1", "12"), 0);  // another house
  EXPECT_GT(fit("12", "12a"), 0);
}

std::vector<NamedPlace> some_places() {
  std::vector<NamedPlace> places;
  for (const auto& [name, kind, detail, weight] : {std::tuple("Rue Haute", "street", "", 0.7),
                                                   {"Rue Basse", "street", "", 0.7},
                                                   {"Place du Marché", "square", "", 0.9},
                                                   {"Rue Haute 12", "house", "", 0.2},
                                                   {"Rue Haute 1", "house", "", 0.2},
                                                   {"Chez Paul", "cafe", "Rue Basse 3", 0.4}}) {
    NamedPlace named;
    named.place.name = name;
    named.place.kind = kind;
    named.place.detail = detail;
    named.weight = weight;
    places.push_back(named);
  }
  return places;
}

TEST(Gazetteer, FindsWhatWasMeant) {
  const auto places = some_places();
  const Gazetteer gazetteer(places);
  const auto first = [&](const char* typed) {
    const auto found = gazetteer.find(typed, 5);
    return found.empty() ? std::string("nothing") : places[found.front().index].place.name;
  };
  EXPECT_EQ(first("rue haute"), "Rue Haute");
  EXPECT_EQ(first("haute 12"), "Rue Haute 12");
  EXPECT_EQ(first("12 rue haute"), "Rue Haute 12");
  EXPECT_EQ(first("marche"), "Place du Marché");
  EXPECT_EQ(first("plcae du marhce"), "Place du Marché");
  EXPECT_EQ(first("chez paul rue basse"), "Chez Paul");
  EXPECT_EQ(first("rue haute 12 rochechouart"), "Rue Haute 12");  // one word of four is unknown
  EXPECT_EQ(first("xyzzy"), "nothing");
  EXPECT_EQ(first("'; DROP TABLE --"), "nothing");
}

TEST(Gazetteer, BearsAnyBytes) {
  const auto places = some_places();
  const Gazetteer gazetteer(places);
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (std::uint64_t n = random() % 200; n > 0; --n) text.push_back(static_cast<char>(random()));
    EXPECT_LE(gazetteer.find(text, 3).size(), 3u);
  }
}

class GuideOfSampleCity : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = new test::ScratchDirectory;
    write_city(*scratch_ / "city.gpkg", test::sample_city(), [] { return std::optional<Artefact>(); });
    guide_ = new Guide(*scratch_ / "city.gpkg");
  }
  static void TearDownTestSuite() {
    delete guide_;
    delete scratch_;
  }
  static test::ScratchDirectory* scratch_;
  static Guide* guide_;
};
test::ScratchDirectory* GuideOfSampleCity::scratch_ = nullptr;
Guide* GuideOfSampleCity::guide_ = nullptr;

TEST_F(GuideOfSampleCity, WalksFromSectorToSectorThroughGates) {
  const auto answer = guide_->tour({.tour = "", .from = "s-main-w", .to = "s-cross"});
  const auto* tour = std::get_if<Tour>(&answer);
  ASSERT_NE(tour, nullptr) << std::get<TourProblem>(answer).detail;
  EXPECT_EQ(tour->sectors.front().id, "s-main-w");
  EXPECT_EQ(tour->sectors.back().id, "s-cross");
  EXPECT_GT(tour->length_m, 1);
  EXPECT_NEAR(tour->duration_s, tour->length_m / kWalkingSpeed_m_s, 1e-9);
  EXPECT_EQ(tour->steps.front().turn, TourTurn::start);
  EXPECT_EQ(tour->steps.back().turn, TourTurn::arrive);
  for (std::size_t i = 0; i + 1 < tour->points.size(); ++i)
    EXPECT_LE(tour->points[i].walked_m, tour->points[i + 1].walked_m);
}

TEST_F(GuideOfSampleCity, ComesBackFromARoundTrip) {
  const auto answer = guide_->tour({.tour = "", .from = "s-main-w", .to = "s-cross", .via = {}, .is_round = true});
  const auto* tour = std::get_if<Tour>(&answer);
  ASSERT_NE(tour, nullptr);
  EXPECT_EQ(tour->points.front().at, tour->points.back().at);
  EXPECT_EQ(tour->stops.size(), 3u);
}

TEST_F(GuideOfSampleCity, SaysWhatIsWrong) {
  const auto kind = [&](const TourQuery& query) {
    const auto answer = guide_->tour(query);
    const auto* problem = std::get_if<TourProblem>(&answer);
    return problem ? std::optional(problem->kind) : std::nullopt;
  };
  EXPECT_EQ(kind({.tour = "", .from = "", .to = "s-cross"}), TourProblem::Kind::nonsense);
  EXPECT_EQ(kind({.tour = "", .from = "95,0", .to = "s-cross"}), TourProblem::Kind::nonsense);
  EXPECT_EQ(kind({.tour = "", .from = "a\nb", .to = "s-cross"}), TourProblem::Kind::nonsense);
  EXPECT_EQ(kind({.tour = "", .from = "xyzzy", .to = "s-cross"}), TourProblem::Kind::unknown_place);
  EXPECT_EQ(kind({.tour = "", .from = "-45.5,170.25", .to = "s-cross"}), TourProblem::Kind::unknown_place);
  EXPECT_EQ(kind({.tour = "none", .from = "", .to = ""}), TourProblem::Kind::unknown_place);
}

TEST(Rooms, AreEnteredFromTheStreetByTheFewestDoors) {
  const auto places = interior_places(test::sample_city_with_interior());
  ASSERT_EQ(places.size(), 2u);
  for (const char* id : {"hall", "kitchen"}) {  // the kitchen lies behind the hall: the same door
    const TourPlace& place = places.at(id);
    EXPECT_EQ(place.kind, "room");
    EXPECT_EQ(place.sector_id, "s-main-e");
    EXPECT_EQ(place.look, (PlanPoint{10'500, -5'000}));
    EXPECT_EQ(place.at, (PlanPoint{10'500, -3'800}));
  }
  EXPECT_EQ(places.at("hall").name, "Diele");
  EXPECT_EQ(places.at("kitchen").name, "kitchen");
}

TEST(Rooms, AreFoundByNameAndToursLeadToTheirDoor) {
  const test::ScratchDirectory scratch;
  write_city(scratch / "city.gpkg", test::sample_city_with_interior(), [] { return std::optional<Artefact>(); });
  const Guide guide(scratch / "city.gpkg");
  const auto found = guide.search("diele", 3);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().kind, "room");
  EXPECT_TRUE(guide.search("kitchen", 3).empty());  // it has no name of its own
  for (const auto& [to, name] : {std::pair("Diele", "Diele"), std::pair("kitchen", "kitchen")}) {
    const auto answer = guide.tour({.tour = "", .from = "s-main-w", .to = to});
    const auto* tour = std::get_if<Tour>(&answer);
    ASSERT_NE(tour, nullptr) << std::get<TourProblem>(answer).detail;
    EXPECT_EQ(tour->sectors.back().id, "s-main-e");
    EXPECT_EQ(tour->points.back().at, (PlanPoint{10'500, -3'800}));
    EXPECT_EQ(tour->steps.back().text, std::string("You are at the door to ") + name + ". It is on your right.");
  }
}

}  // namespace
}  // namespace vicus
