#include "x3d_export/coding.hpp"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <random>

namespace vicus {
namespace {

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

std::string numbers(int count) {
  std::string body;
  for (int i = 0; i < count; ++i) body += std::to_string(i * i % 997) + ' ';
  return body;
}

TEST(StrongHash, IsTheFirstHalfOfSha256) {
  EXPECT_EQ(strong_hash("abc"), "ba7816bf8f01cfea414140de5dae2223");
  EXPECT_EQ(strong_hash(""), "e3b0c44298fc1c149afbf4c8996fb924");
}

TEST(Codings, GiveTheBodyBack) {
  for (const auto& body : {std::string(), std::string("x"), numbers(4000), std::string(3'000'000, 'a')})
    for (const int quality : {1, 4, 6}) {
      EXPECT_EQ(unbrotli(brotli(body, quality), body.size()), body) << body.size();
      EXPECT_EQ(gunzip(gzip(body, quality), body.size()), body) << body.size();
    }
}

TEST(Unbrotli, NeverGivesMoreThanAsked) {
  const std::string bomb = brotli(std::string(50'000'000, '\0'), 5);
  EXPECT_LT(bomb.size(), 1000u);
  EXPECT_EQ(unbrotli(bomb, 49'999'999), std::nullopt);
  EXPECT_EQ(unbrotli(bomb, 0), std::nullopt);
  EXPECT_EQ(unbrotli(bomb, 50'000'000)->size(), 50'000'000u);
}

TEST(Unbrotli, RefusesWhatIsNotOneWholeStream) {
  const std::string whole = brotli(numbers(1000), 6);
  EXPECT_EQ(unbrotli("", 100), std::nullopt);
  EXPECT_EQ(unbrotli(whole + "x", 10'000), std::nullopt);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_EQ(unbrotli(whole.substr(0, size), 10'000), std::nullopt);
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    std::string damaged = whole;
    damaged[random() % damaged.size()] = static_cast<char>(random());
    EXPECT_LE(unbrotli(damaged, 10'000).value_or("").size(), 10'000u);
  }
}

}  // namespace
}  // namespace vicus
