#include "httpd/parcels.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "city_db/store.hpp"
#include "tests/unit/httpd/served_city.hpp"

namespace vicus {
namespace {

using Json = nlohmann::json;

std::string field(const HttpResponse& response, const char* name) {
  return field_of(response.fields, name).value_or("(none)");
}

std::string detail(const HttpResponse& response) { return Json::parse(*response.body)["detail"].get<std::string>(); }

std::vector<Json> lines_of(const HttpResponse& response) {
  std::vector<Json> lines;
  std::istringstream in(*response.body);
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

class ParcelsOfSampleCity : public testing::Test {
 protected:
  HttpResponse get(const std::string& query, HttpFields fields = {{"Accept-Encoding", "identity"}}) {
    return routes_.respond({"GET", "/parcels" + query, std::move(fields)});
  }

  test::ServedCity served_;
  Routes routes_ = served_.routes();
};

TEST_F(ParcelsOfSampleCity, HoldTheFilesThatTheServerGivesOneByOneInTheOrderAskedFor) {
  const auto response = get("?files=s-main-w,s-cross.far,s-nowhere,s-main-w.tall,s-cross.tall");
  ASSERT_EQ(response.status, 200);
  EXPECT_EQ(field(response, "Content-Type"), "application/x-ndjson");
  const auto lines = lines_of(response);
  const std::vector<std::string> names{"s-main-w.x3d", "s-cross.far.x3d", "s-main-w.tall.x3d"};
  ASSERT_EQ(lines.size(), 1 + names.size());
  EXPECT_EQ(lines[0]["missing"], Json({"s-nowhere", "s-cross.tall"}));
  for (std::size_t i = 0; i < names.size(); ++i) {
    SCOPED_TRACE(names[i]);
    const auto alone = routes_.respond({"GET", "/sectors/" + names[i], {{"Accept-Encoding", "identity"}}});
    ASSERT_EQ(alone.status, 200);
    EXPECT_EQ(lines[i + 1], Json({names[i], *alone.body}));
    EXPECT_EQ(lines[0]["files"][i], Json({names[i], alone.body->size()}));
  }
}

TEST_F(ParcelsOfSampleCity, AreTheSameBytesForTheSameListAndNotSentAgainToWhoHasThem) {
  const HttpFields br = {{"Accept-Encoding", "br"}};
  const auto first = get("?files=s-main-w,s-cross.far", br), again = get("?files=s-main-w,s-cross.far", br);
  EXPECT_EQ(field(first, "Content-Encoding"), "br");
  EXPECT_EQ(field(first, "ETag"), field(again, "ETag"));
  EXPECT_EQ(first.body, again.body) << "kept, not made a second time";
  EXPECT_EQ(unbrotli(*first.body, 10'000'000), *get("?files=s-main-w,s-cross.far").body);
  auto known = br;
  known.emplace_back("If-None-Match", field(first, "ETag"));
  const auto spared = get("?files=s-main-w,s-cross.far", known);
  EXPECT_EQ(spared.status, 304);
  EXPECT_FALSE(spared.body);
  EXPECT_NE(field(get("?files=s-cross.far,s-main-w", br), "ETag"), field(first, "ETag"));
  EXPECT_NE(field(get("?files=s-main-w", br), "ETag"), field(first, "ETag"));
  EXPECT_NE(field(get("?files=s-main-w,s-cross.far&without=", br), "ETag"), field(first, "ETag"));
}

TEST_F(ParcelsOfSampleCity, SayWhatIsWrongWithAList) {
  const std::pair<const char*, const char*> wrong[] = {
      {"", "Give files once"},
      {"?files=", "'' names no sector's file"},
      {"?files=a,,b", "'' names no sector's file"},
      {"?files=../secret", "'../secret' names no sector's file"},
      {"?files=a.near", "'a.near' names no sector's file"},
      {"?files=a.far.far", "'a.far.far' names no sector's file"},
      {"?files=a,a", "'a' stands twice"},
      {"?files=a&files=b", "Give files once"},
      {"?files=a&x=1", "Give files once"},
      {"?files=a&without=b.c", "'b.c' begins no image's name"},
  };
  for (const auto& [query, what] : wrong) {
    const auto response = get(query);
    EXPECT_EQ(response.status, 400) << query;
    EXPECT_NE(detail(response).find(what), std::string::npos) << query << ": " << detail(response);
  }
  std::string many = "?files=s0";
  for (std::size_t i = 1; i <= kMostParcelFiles; ++i) many += ",s" + std::to_string(i);
  EXPECT_EQ(get(many).status, 400);
  const auto none = get("?files=s-nowhere,s-cross.tall");
  EXPECT_EQ(none.status, 404);
  EXPECT_NE(detail(none).find("s-nowhere"), std::string::npos);
}

/// A city of one near file in two parts that refers to two images, one of them twice.
std::filesystem::path city_with_images(const test::ScratchDirectory& scratch) {
  const City city = test::sample_city();
  std::vector<Artefact> rows;
  const auto add = [&](const std::string& path, const std::string& body) {
    rows.push_back({path, "x", "identity", strong_hash(body), body});
  };
  add("sectors/s-cross.x3d", "<a url='../textures/aa11.png'/><a url='../textures/bb22.png'/>");
  add("sectors/s-cross.1.x3d", "<a url='../textures/aa11.png'/><a url='../textures/none.png'/>");
  add("sectors/s-cross.far.x3d", "<a url='../textures/cc33.png'/>");
  for (const auto& [id, bytes] : {std::pair("aa11", std::string("a\0\xff", 3)), std::pair("bb22", std::string("bb22")),
                                  std::pair("cc33", std::string("c"))})
    add(std::string("textures/") + id + ".png", bytes);
  write_city(scratch / "images.gpkg", city,
             [&, i = std::size_t{0}]() mutable { return i < rows.size() ? std::optional(rows[i++]) : std::nullopt; });
  return scratch / "images.gpkg";
}

std::vector<std::string> names_in(const HttpResponse& response) {
  const auto lines = lines_of(response);
  std::vector<std::string> names;
  for (std::size_t i = 1; i < lines.size(); ++i) names.push_back(lines[i][0]);
  return names;
}

TEST(Parcels, BringPartsAndTheImagesOfNearFilesOnceAndNotThoseThatOneHas) {
  const test::ScratchDirectory scratch;
  const CityReader city(city_with_images(scratch));
  Parcels parcels;
  const HttpRequest request{"GET", "", {{"Accept-Encoding", "identity"}}};
  const auto ask = [&](std::vector<std::pair<std::string, std::string>> query) {
    return parcels.answer(request, {"/parcels", std::move(query)}, city);
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_in(ask({{"files", "s-cross,s-cross.far"}})),
            (Names{"s-cross.x3d", "s-cross.1.x3d", "s-cross.far.x3d"}));
  const auto all = ask({{"files", "s-cross.far,s-cross"}, {"without", ""}});
  EXPECT_EQ(names_in(all),
            (Names{"s-cross.far.x3d", "s-cross.x3d", "textures/aa11.png", "textures/bb22.png", "s-cross.1.x3d"}));
  EXPECT_EQ(lines_of(all)[3][1], "YQD/");
  EXPECT_EQ(lines_of(all)[4][1], "YmIyMg==");
  EXPECT_EQ(names_in(ask({{"files", "s-cross"}, {"without", "aa,bb22"}})), (Names{"s-cross.x3d", "s-cross.1.x3d"}));
}

TEST(Parcels, KeepTheLatestOnly) {
  const test::ScratchDirectory scratch;
  const CityReader city(city_with_images(scratch));
  Parcels parcels(300);
  const HttpRequest request{"GET", "", {{"Accept-Encoding", "identity"}}};
  for (const char* files : {"s-cross", "s-cross.far", "s-cross.far,s-cross"}) {
    const auto response = parcels.answer(request, {"/parcels", {{"files", files}}}, city);
    ASSERT_EQ(response.status, 200);
    EXPECT_GE(parcels.kept_bytes(), response.body->size());
    EXPECT_LE(parcels.kept_bytes(), std::max(std::size_t{300}, response.body->size()));
  }
}

}  // namespace
}  // namespace vicus
