#include "x3d_export/package.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <map>

#include "tests/support/sample_city.hpp"
#include "x3d_export/coding.hpp"

namespace vicus {
namespace {

std::vector<Artefact> all_artefacts(City& city, unsigned threads) {
  PackageOptions options;
  options.threads = threads;
  const auto next = export_artefacts(city, options);
  std::vector<Artefact> list;
  while (auto artefact = next()) list.push_back(std::move(*artefact));
  EXPECT_FALSE(next()) << "the end stays the end";
  return list;
}

TEST(Stored, IsBrotliWithTheHashOfItsOwnBytes) {
  const std::string body(4000, 'x');
  const auto row = stored("sectors/a.x3d", "model/x3d+xml", body, 9);
  EXPECT_EQ(row.path, "sectors/a.x3d");
  EXPECT_EQ(row.media_type, "model/x3d+xml");
  EXPECT_EQ(row.coding, "br");
  EXPECT_EQ(row.hash, strong_hash(row.body));
  EXPECT_EQ(unbrotli(row.body, 4000), body);
}

TEST(Stored, IsTheBodyItselfWhereBrotliSavesNothing) {
  const auto row = stored("a", "text/plain", "x", 9);
  EXPECT_EQ(row.coding, "identity");
  EXPECT_EQ(row.body, "x");
  EXPECT_EQ(row.hash, strong_hash("x"));
}

TEST(ExportArtefacts, YieldEachStoredFormOfEverySectorOnceAndFillItsBytes) {
  City city = test::sample_city();
  for (auto& s : city.sectors) s.bytes = 0;
  city.meta.erase("start");
  const auto list = all_artefacts(city, 2);
  std::map<std::string, std::map<std::string, std::size_t>> sizes;
  for (const auto& a : list) sizes[a.path][a.coding] = a.body.size();
  for (const auto& s : city.sectors) {
    for (const char* suffix : {".x3d", ".far.x3d", ".json"})
      EXPECT_TRUE(sizes.contains("sectors/" + s.id + suffix)) << s.id << suffix;
    EXPECT_GT(s.bytes, 0u);
    EXPECT_EQ(s.bytes, sizes["sectors/" + s.id + ".x3d"]["br"]);
    EXPECT_EQ(sizes.contains("sectors/" + s.id + ".tall.x3d"), s.id == "s-main-w" || s.id == "s-north") << s.id;
  }
  for (const auto& i : city.impostors) EXPECT_TRUE(sizes.contains("impostors/" + i.gate_id + ".png")) << i.gate_id;
  for (const auto& p : city.panoramas) EXPECT_TRUE(sizes.contains("panoramas/" + p.sector_id + ".png"));
  EXPECT_EQ(sizes.size(), 3 * city.sectors.size() + 2 + city.impostors.size() + city.panoramas.size());
  for (const auto& [path, codings] : sizes) EXPECT_EQ(codings.size(), 1u) << path;
  EXPECT_FALSE(city.meta["start"].empty());
}

TEST(ExportArtefacts, AreTheSameForAnyNumberOfThreads) {
  City a = test::sample_city(), b = test::sample_city();
  const auto one = all_artefacts(a, 1), three = all_artefacts(b, 3);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].path, three[i].path);
    EXPECT_EQ(one[i].hash, three[i].hash);
    EXPECT_EQ(one[i].body, three[i].body);
  }
}

}  // namespace
}  // namespace vicus
