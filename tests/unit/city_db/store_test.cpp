#include "city_db/store.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/city_equal.hpp"
#include "tests/support/sample_city.hpp"
#include "tests/support/scratch.hpp"

namespace vicus {
namespace {

using test::one_by_one;
using test::ScratchDirectory;

std::vector<Artefact> some_artefacts() {
  std::string bytes;
  for (unsigned i = 0; i < 70'000; ++i) bytes.push_back(static_cast<char>(i * i / 7));
  return {{"/city.x3d", "model/x3d+xml", "identity", "h1", "<X3D/>"},
          {"/city.x3d", "model/x3d+xml", "br", "h2", std::string("\0br\0", 4)},
          {"/sectors/s-cross.x3d", "model/x3d+xml", "identity", "h3", bytes},
          {"/empty", "text/plain", "identity", "h4", ""}};
}

TEST(WriteCity, GivesBackEveryRecordAsItWas) {
  ScratchDirectory scratch;
  const City city = test::sample_city_with_facades();
  write_city(scratch / "city.gpkg", city, one_by_one(some_artefacts()));
  EXPECT_EQ(test::difference(read_city(scratch / "city.gpkg"), city), "");
}

TEST(WriteCity, GivesBackOpeningsOfHousesOfTheirOwnAndRefusesBrokenOnes) {
  ScratchDirectory scratch;
  City city = test::sample_city_with_facades();
  city.facades[1].openings = {{OpeningKind::house_door, 0.25, 1.3, 0, 2.1, 0, 0, 0.3},
                              {OpeningKind::shop, 2, 3.75, 0.5, 2.5, 1, 1, 0}};
  write_city(scratch / "city.gpkg", city, nullptr);
  EXPECT_EQ(test::difference(read_city(scratch / "city.gpkg"), city), "");
  const auto refused = [&](const Opening& opening) {
    city.facades[1].openings = {opening};
    write_city(scratch / "bad.gpkg", city, nullptr);
    EXPECT_THROW(read_city(scratch / "bad.gpkg"), CityError);
  };
  refused({static_cast<OpeningKind>(8), 0, 1, 0, 1, 0, 0, 0});
  refused({OpeningKind::window, 1, 1, 0, 1, 0, 0, 0});
  refused({OpeningKind::window, 0, 1, -1, 1, 0, 0, 0});
  refused({OpeningKind::window, 0, NAN, 0, 1, 0, 0, 0});
  refused({OpeningKind::window, 0, 1, 0, 1, 9999, 0, 0});
}

TEST(WriteCity, GivesBackAnEmptyCity) {
  ScratchDirectory scratch;
  write_city(scratch / "city.gpkg", City{}, nullptr);
  EXPECT_EQ(test::difference(read_city(scratch / "city.gpkg"), City{}), "");
}

TEST(WriteCity, IsExactAtTheEndsOfTheLatticeAndForAwkwardText) {
  City city = test::sample_city();
  constexpr std::int32_t kEnd = kPlanLimit - 1;
  city.origin = {-85.000000000000014, 179.99999999999997};
  city.domain = {{{{-kEnd, -kEnd}, {kEnd, -kEnd}, {kEnd, kEnd}, {-kEnd, kEnd - 1}}, {}}};
  city.objects[0].at = {kEnd, -kEnd};
  city.objects[0].height_m = 0.1 + 0.2;
  city.objects[0].name = std::string("a\0b\x01\xff\"\\\n", 8);
  city.objects[0].tags = {{"", ""}, {"\"k\\\n", std::string("\0\x1f\xc3\xb6", 4)}};
  city.sectors[0].names = {"", "\"", "\\u0041", "Löwe\t"};
  city.sectors[0].bytes = 1ull << 62;
  city.meta["key with 'quotes'"] = "line\nline";
  ScratchDirectory scratch;
  write_city(scratch / "city.gpkg", city, nullptr);
  EXPECT_EQ(test::difference(read_city(scratch / "city.gpkg"), city), "");
}

TEST(WriteCity, GivesEqualBytesForEqualCities) {
  ScratchDirectory scratch;
  write_city(scratch / "a.gpkg", test::sample_city(), one_by_one(some_artefacts()));
  write_city(scratch / "b.gpkg", test::sample_city(), one_by_one(some_artefacts()));
  EXPECT_EQ(test::read_bytes(scratch / "a.gpkg"), test::read_bytes(scratch / "b.gpkg"));
}

TEST(WriteCity, WritesWhatPullingChanges) {
  ScratchDirectory scratch;
  City city = test::sample_city();
  auto next = one_by_one(some_artefacts());
  write_city(scratch / "city.gpkg", city, [&] {
    auto artefact = next();
    if (!artefact) city.sectors.front().bytes = 4711;
    return artefact;
  });
  EXPECT_EQ(read_city(scratch / "city.gpkg").sectors.front().bytes, 4711u);
}

TEST(CityReader, AnswersByKey) {
  ScratchDirectory scratch;
  const City city = test::sample_city();
  const auto artefacts = some_artefacts();
  write_city(scratch / "city.gpkg", city, one_by_one(artefacts));
  CityReader reader(scratch / "city.gpkg");
  EXPECT_EQ(reader.sector_ids(),
            (std::vector<std::string>{"s-cross", "s-main-e", "s-main-w", "s-north", "s-passage", "s-south", "s-yard"}));
  for (int again = 0; again < 2; ++again) {
    for (const auto& sector : city.sectors) EXPECT_EQ(reader.sector(sector.id), sector);
    EXPECT_EQ(reader.sector("nowhere"), std::nullopt);
    EXPECT_EQ(reader.gates_of("s-cross").size(), 4u);
    EXPECT_EQ(reader.gates_of("s-cross")[0], city.gates[0]);
    EXPECT_EQ(reader.buildings_of("s-yard"), std::vector<Building>{city.buildings[7]});
    EXPECT_EQ(reader.objects_of("s-yard"), std::vector<StandaloneObject>{city.objects[1]});
    EXPECT_EQ(reader.borders_of("s-passage").size(), 2u);
    EXPECT_EQ(reader.borders_of("nowhere").size(), 0u);
    EXPECT_EQ(reader.viewpoints_of("s-yard"), std::vector<Viewpoint>{city.viewpoints[6]});
    EXPECT_EQ(reader.objects_of("s-yard"), std::vector<StandaloneObject>{city.objects[1]});
    EXPECT_EQ(reader.visible_from("s-passage").size(), 3u);
    EXPECT_EQ(reader.artefact("/city.x3d", {"br", "identity"}), artefacts[1]);
    EXPECT_EQ(reader.artefact("/city.x3d", {"zstd", "identity", "br"}), artefacts[0]);
    EXPECT_EQ(reader.artefact("/city.x3d", {"gzip"}), std::nullopt);
    EXPECT_EQ(reader.artefact("/sectors/s-cross.x3d", {"identity"}), artefacts[2]);
    EXPECT_EQ(reader.artefact("/empty", {"identity"}), artefacts[3]);
    EXPECT_EQ(reader.artefact_codings("/city.x3d").size(), 2u);
    EXPECT_EQ(reader.artefact_codings("/city.x3d")[0].coding, "br");
    EXPECT_EQ(reader.artefact_codings("/city.x3d")[0].body, "");
    EXPECT_EQ(reader.meta("licences"), "drawn by hand, CC0 1.0");
    EXPECT_EQ(reader.meta("format_version"), "8");
    EXPECT_EQ(reader.panorama_of("s-cross")->radius_m, 500);
    EXPECT_FALSE(reader.panorama_of("s-main-w"));
    EXPECT_EQ(reader.meta("nothing"), std::nullopt);
  }
}

TEST(CityReader, FindsWhatMeetsABoxToTheMillimetre) {
  ScratchDirectory scratch;
  write_city(scratch / "city.gpkg", test::sample_city(), nullptr);
  const CityReader reader(scratch / "city.gpkg");
  const auto sectors = [&](PlanBox box) { return reader.sectors_in(box, 100, 0); };
  using Ids = std::vector<std::string>;
  EXPECT_EQ(sectors({{-5000, -5000}, {-5000, -5000}}), (Ids{"s-cross", "s-main-w", "s-south"}));
  EXPECT_EQ(sectors({{-5001, -5001}, {-5001, -5001}}), Ids{});
  EXPECT_EQ(sectors({{-5001, -5000}, {-5001, -5000}}), (Ids{"s-main-w"}));
  EXPECT_EQ(sectors({{-kPlanLimit, -kPlanLimit}, {kPlanLimit, kPlanLimit}}).size(), 7u);
  EXPECT_EQ(sectors(PlanBox{}), Ids{});
  EXPECT_EQ(reader.gates_in({{-60000, 0}, {-60000, 0}}, 10, 0).at(0).id, "s-main-w-to-out");
  EXPECT_EQ(reader.buildings_in({{25000, 10000}, {25000, 10000}}, 10, 0).at(0).id, "b-4");
}

TEST(CityReader, PagesThroughABoxInIdOrder) {
  ScratchDirectory scratch;
  write_city(scratch / "city.gpkg", test::sample_city(), nullptr);
  const CityReader reader(scratch / "city.gpkg");
  const PlanBox all{{-kPlanLimit, -kPlanLimit}, {kPlanLimit, kPlanLimit}};
  const auto whole = reader.buildings_in(all, 100, 0);
  ASSERT_EQ(whole.size(), 10u);
  std::vector<Building> paged;
  for (std::size_t offset = 0; offset < 12; offset += 3)
    for (auto& b : reader.buildings_in(all, 3, offset)) paged.push_back(b);
  EXPECT_EQ(paged, whole);
  EXPECT_TRUE(std::is_sorted(whole.begin(), whole.end(), [](const auto& a, const auto& b) { return a.id < b.id; }));
  EXPECT_TRUE(reader.buildings_in(all, 0, 0).empty());
}

TEST(CityReader, TotalsTheArtefacts) {
  ScratchDirectory scratch;
  write_city(scratch / "city.gpkg", test::sample_city(), one_by_one(some_artefacts()));
  const auto totals = CityReader(scratch / "city.gpkg").artefact_totals();
  ASSERT_EQ(totals.size(), 3u);
  EXPECT_EQ(totals[0].coding, "br");
  EXPECT_EQ(totals[0].bytes, 4u);
  EXPECT_EQ(totals[1].count, 2u);
  EXPECT_EQ(totals[1].bytes, 70'006u);
  EXPECT_EQ(totals[2].media_type, "text/plain");
}

}  // namespace
}  // namespace vicus
