#include "x3d_export/package.hpp"

#include <brotli/decode.h>
#include <gtest/gtest.h>
#include <libdeflate.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/sample_city.hpp"

namespace vicus {
namespace {

std::string unbrotli(const std::string& coded, std::size_t size) {
  std::string out(size, '\0');
  EXPECT_EQ(BrotliDecoderDecompress(coded.size(), reinterpret_cast<const std::uint8_t*>(coded.data()), &size,
                                    reinterpret_cast<std::uint8_t*>(out.data())),
            BROTLI_DECODER_RESULT_SUCCESS);
  EXPECT_EQ(size, out.size());
  return out;
}

std::string gunzip(const std::string& coded, std::size_t size) {
  std::string out(size, '\0');
  libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
  std::size_t got = 0;
  EXPECT_EQ(libdeflate_gzip_decompress(decompressor, coded.data(), coded.size(), out.data(), out.size(), &got),
            LIBDEFLATE_SUCCESS);
  libdeflate_free_decompressor(decompressor);
  EXPECT_EQ(got, size);
  return out;
}

std::vector<Artefact> all_artefacts(City& city, unsigned threads) {
  PackageOptions options;
  options.threads = threads;
  const auto next = export_artefacts(city, options);
  std::vector<Artefact> list;
  while (auto artefact = next()) list.push_back(std::move(*artefact));
  EXPECT_FALSE(next()) << "the end stays the end";
  return list;
}

TEST(StrongHash, IsTheFirstHalfOfSha256) {
  EXPECT_EQ(strong_hash("abc"), "ba7816bf8f01cfea414140de5dae2223");
  EXPECT_EQ(strong_hash(""), "e3b0c44298fc1c149afbf4c8996fb924");
}

TEST(Coded, GivesTheBodyBackInEveryCoding) {
  std::string body;
  for (int i = 0; i < 4000; ++i) body += std::to_string(i * i % 997) + ' ';
  const auto rows = coded("sectors/a.x3d", "model/x3d+xml", body, 9, 6);
  ASSERT_EQ(rows.size(), 3u);
  std::set<std::string> hashes;
  for (const auto& row : rows) {
    EXPECT_EQ(row.hash, strong_hash(row.body));
    hashes.insert(row.hash);
    const std::string decoded = row.coding == "br"     ? unbrotli(row.body, body.size())
                                : row.coding == "gzip" ? gunzip(row.body, body.size())
                                                       : row.body;
    EXPECT_EQ(decoded, body) << row.coding;
  }
  EXPECT_EQ(hashes.size(), 3u);
}

TEST(Coded, LeavesOutACodingThatSavesNothing) {
  const auto rows = coded("a", "text/plain", "x", 9, 6);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows.front().coding, "identity");
}

TEST(ExportArtefacts, YieldsEveryFormOfEverySectorAndFillsItsBytes) {
  City city = test::sample_city();
  for (auto& s : city.sectors) s.bytes = 0;
  city.meta.erase("start");
  const auto list = all_artefacts(city, 2);
  std::map<std::string, std::map<std::string, std::size_t>> sizes;
  for (const auto& a : list) sizes[a.path][a.coding] = a.body.size();
  for (const auto& s : city.sectors) {
    for (const char* suffix : {".x3d", ".far.x3d", ".wrl", ".x3dj", ".json"})
      EXPECT_TRUE(sizes.contains("sectors/" + s.id + suffix)) << s.id << suffix;
    EXPECT_GT(s.bytes, 0u);
    EXPECT_EQ(s.bytes, sizes["sectors/" + s.id + ".x3d"]["br"]);
  }
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
