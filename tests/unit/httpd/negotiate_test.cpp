#include "httpd/negotiate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace vicus {
namespace {

using Codings = std::vector<std::string>;

TEST(AcceptedCodings, OrdersByQualityThenByOurs) {
  EXPECT_EQ(accepted_codings("gzip, deflate, br, zstd"), (Codings{"br", "gzip", "identity"}));
  EXPECT_EQ(accepted_codings("gzip, deflate"), (Codings{"gzip", "identity"}));
  EXPECT_EQ(accepted_codings("br;q=0.5, gzip;q=0.9"), (Codings{"gzip", "br", "identity"}));
  EXPECT_EQ(accepted_codings("identity, br;q=0.5"), (Codings{"identity", "br"}));
  EXPECT_EQ(accepted_codings("br;q=0.001"), (Codings{"br", "identity"}));
  EXPECT_EQ(accepted_codings("GZIP ; Q=1.000 ,, BR\t;\tq=0.3 ,"), (Codings{"gzip", "br", "identity"}));
  EXPECT_EQ(accepted_codings("x-gzip"), (Codings{"gzip", "identity"}));
}

TEST(AcceptedCodings, KeepsToWhatIsRefused) {
  EXPECT_EQ(accepted_codings("identity;q=0"), Codings{});
  EXPECT_EQ(accepted_codings("*;q=0"), Codings{});
  EXPECT_EQ(accepted_codings("identity;q=0, gzip"), Codings{"gzip"});
  EXPECT_EQ(accepted_codings("*;q=0, br"), Codings{"br"});
  EXPECT_EQ(accepted_codings("br;q=0, *"), (Codings{"gzip", "identity"}));
  EXPECT_EQ(accepted_codings("br;q=0.0, gzip;q=0.000"), Codings{"identity"});
  EXPECT_EQ(accepted_codings("identity;q=0, *;q=0.2"), (Codings{"br", "gzip"}));
}

TEST(AcceptedCodings, TakesAnEmptyFieldForIdentityAndNoneForAnything) {
  EXPECT_EQ(accepted_codings(""), Codings{"identity"});
  EXPECT_EQ(accepted_codings(" , "), Codings{"identity"});
  EXPECT_EQ(accepted_codings(std::nullopt), (Codings{"identity", "gzip", "br"}));
}

TEST(AcceptedCodings, RefusesWhatIsNoList) {
  for (const char* field : {"br gzip", "br;", "br;q", "br;q=", "br;q=2", "br;q=1.001", "br;q=0.1234", "br;q=.5",
                            "br;q=-1", "br;q=0.5;q=0.6", "br;level=3", "(br)", "br;q=0,5;", "\"br\"", "br=1", ";q=1"})
    EXPECT_EQ(accepted_codings(field), std::nullopt) << field;
}

TEST(MediaQuality, GoesByTheMostSpecificRange) {
  const std::string accept = "text/*;q=0.3, text/html;q=0.7, */*;q=0.1, model/x3d+xml, model/vrml;q=0";
  EXPECT_EQ(media_quality(accept, "text/html"), 700);
  EXPECT_EQ(media_quality(accept, "text/plain"), 300);
  EXPECT_EQ(media_quality(accept, "image/png"), 100);
  EXPECT_EQ(media_quality(accept, "model/x3d+xml"), 1000);
  EXPECT_EQ(media_quality(accept, "model/vrml"), 0);
  EXPECT_EQ(media_quality("model/vrml", "text/html"), 0);
  EXPECT_EQ(media_quality("MODEL/VRML", "model/vrml"), 1000);
  EXPECT_EQ(media_quality(std::nullopt, "text/html"), 1000);
  EXPECT_EQ(media_quality("", "text/html"), 1000);
  EXPECT_EQ(media_quality("text/html;level=1", "text/html"), 0);
  EXPECT_EQ(media_quality("text/html;charset=\"a,b;\\\"\", image/png", "image/png"), 1000);
}

TEST(MediaQuality, RefusesWhatIsNoList) {
  for (const char* field :
       {"text", "text/", "/html", "text/html text/plain", "text/html;q=1.5", "*/html/x", "text/html;"})
    EXPECT_EQ(media_quality(field, "text/html"), std::nullopt) << field;
}

TEST(PreferredMediaType, IsTheFirstOfTheBest) {
  const std::vector<std::string> ours = {"model/x3d+xml", "model/vrml"};
  EXPECT_EQ(preferred_media_type("*/*", ours), "model/x3d+xml");
  EXPECT_EQ(preferred_media_type("model/vrml, */*;q=0.9", ours), "model/vrml");
  EXPECT_EQ(preferred_media_type("text/html", ours), "");
  EXPECT_EQ(preferred_media_type("text", ours), std::nullopt);
}

/// The rule of RFC 9110 §12.5.3 said once more, slowly, on fields built from known parts.
TEST(AcceptedCodings, AgreesWithAnObviousReading) {
  const Codings names = {"br", "gzip", "identity", "*", "zstd"};
  for (unsigned seed = 0; seed < 5000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<std::pair<std::string, int>> parts;
    std::string field;
    auto pool = names;
    std::shuffle(pool.begin(), pool.end(), random);
    for (std::size_t i = random() % (pool.size() + 1); i > 0; --i) {
      const int tenths = static_cast<int>(random() % 11);
      parts.emplace_back(pool[i - 1], tenths);
      field += (field.empty() ? "" : ", ") + pool[i - 1] + ";q=" + (tenths == 10 ? "1" : "0." + std::to_string(tenths));
    }
    const auto quality = [&](const std::string& coding) {
      for (const auto& [name, q] : parts)
        if (name == coding) return static_cast<double>(q);
      for (const auto& [name, q] : parts)
        if (name == "*") return static_cast<double>(q);
      return coding == "identity" ? 0.01 : 0.0;
    };
    const auto codings = accepted_codings(field);
    ASSERT_TRUE(codings) << field;
    for (const auto& coding : {"br", "gzip", "identity"})
      EXPECT_EQ(std::count(codings->begin(), codings->end(), coding), quality(coding) > 0 ? 1 : 0) << field;
    for (std::size_t i = 1; i < codings->size(); ++i)
      EXPECT_GE(quality((*codings)[i - 1]), quality((*codings)[i])) << field;
  }
}

}  // namespace
}  // namespace vicus
