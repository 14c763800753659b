#include "city_db/geometry_blob.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

#include "tests/support/city_equal.hpp"
#include "tests/support/sample_city.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace vicus {
namespace {

using Line = std::vector<PlanPoint>;
constexpr std::int32_t kEnd = kPlanLimit - 1;

/// The same geometry as another program may write it: big-endian, without envelope.
std::string as_big_endian_point(double x, double y) {
  std::string blob{'G', 'P', 0, 0, 0, 1, static_cast<char>(0x86), static_cast<char>(0xa0), 0, 0, 0, 0, 1};
  for (const double v : {x, y}) {
    const auto bits = std::bit_cast<std::uint64_t>(v);
    for (int shift = 56; shift >= 0; shift -= 8) blob.push_back(static_cast<char>(bits >> shift));
  }
  return blob;
}

/// A blob of ours with the number at `at` replaced.
std::string with_double(std::string blob, std::size_t at, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (std::size_t i = 0; i < 8; ++i) blob[at + i] = static_cast<char>(bits >> (8 * i));
  return blob;
}

TEST(GeometryBlob, GivesBackEveryLatticePoint) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int32_t> mm(-kEnd, kEnd);
  for (int i = 0; i < 100'000; ++i) {
    const PlanPoint point{mm(random), mm(random)};
    ASSERT_EQ(decode_point(encode_point(point)), point);
  }
  for (const PlanPoint end : {PlanPoint{kEnd, -kEnd}, PlanPoint{-kEnd, kEnd}, PlanPoint{0, 0}})
    EXPECT_EQ(decode_point(encode_point(end)), end);
}

TEST(GeometryBlob, GivesBackLinesAndPolygonsOfTheSampleCity) {
  const City city = test::sample_city();
  for (const auto& gate : city.gates) EXPECT_EQ(decode_line(encode_line(gate.line)), gate.line);
  for (const auto& sector : city.sectors) EXPECT_EQ(decode_polygon(encode_polygon(sector.ground)), sector.ground);
  for (const auto& b : city.buildings) EXPECT_EQ(decode_polygon(encode_polygon(b.footprint)), b.footprint);
}

TEST(GeometryBlob, GivesBackWhatIsEmpty) {
  EXPECT_EQ(decode_line(encode_line({})), Line{});
  EXPECT_EQ(decode_polygon(encode_polygon({})), Polygon{});
  EXPECT_EQ(encode_line({})[3], 0x11) << "little-endian, no envelope, empty";
}

TEST(GeometryBlob, ReadsEitherByteOrder) {
  EXPECT_EQ(decode_point(as_big_endian_point(1.001, -2.5)), (PlanPoint{1001, -2500}));
}

TEST(GeometryBlob, RefusesWhatIsNotOnTheLattice) {
  const std::string blob = encode_point({5, 5});
  const std::size_t x_at = blob.size() - 16;
  EXPECT_EQ(decode_point(with_double(blob, x_at, 0.0070000001)), (PlanPoint{7, 5})) << "0.1 nm off: rounding";
  for (const double bad : {0.0071, 0.0005, 1073741.824, -1073741.824, 1e300, std::nan(""), HUGE_VAL, -HUGE_VAL})
    EXPECT_EQ(decode_point(with_double(blob, x_at, bad)), std::nullopt) << bad;
}

TEST(GeometryBlob, RefusesEveryTruncationAndEveryAddition) {
  const City city = test::sample_city();
  const std::string line = encode_line(city.streets[0].line), point = encode_point({1, 2});
  const std::string polygon = encode_polygon(city.sectors[1].ground);
  for (std::size_t n = 0; n < polygon.size(); ++n) EXPECT_EQ(decode_polygon(polygon.substr(0, n)), std::nullopt);
  for (std::size_t n = 0; n < line.size(); ++n) EXPECT_EQ(decode_line(line.substr(0, n)), std::nullopt);
  for (std::size_t n = 0; n < point.size(); ++n) EXPECT_EQ(decode_point(point.substr(0, n)), std::nullopt);
  EXPECT_EQ(decode_polygon(polygon + '\0'), std::nullopt);
  EXPECT_EQ(decode_line(line + '\0'), std::nullopt);
  EXPECT_EQ(decode_point(point + '\0'), std::nullopt);
}

TEST(GeometryBlob, RefusesOtherTypesAndHugeCounts) {
  std::string line = encode_line({{0, 0}, {1, 1}});
  EXPECT_EQ(decode_point(line), std::nullopt);
  EXPECT_EQ(decode_polygon(line), std::nullopt);
  const std::size_t type_at = 8 + 32 + 1, count_at = type_at + 4;
  ASSERT_EQ(line[type_at], 2);
  std::string with_z = line;
  with_z[type_at + 1] = 0x03;  // 1002 and its like
  EXPECT_EQ(decode_line(with_z), std::nullopt);
  for (std::size_t i = 0; i < 4; ++i) line[count_at + i] = static_cast<char>(0xff);
  EXPECT_EQ(decode_line(line), std::nullopt);
}

TEST(GeometryBlob, RefusesOpenRings) {
  std::string polygon = encode_polygon({{{0, 0}, {10, 0}, {0, 10}}, {}});
  EXPECT_TRUE(decode_polygon(polygon));
  EXPECT_EQ(decode_polygon(with_double(polygon, polygon.size() - 8, 0.001)), std::nullopt);
}

std::string random_bytes(std::mt19937& random) {
  std::string bytes(random() % 200, '\0');
  for (char& c : bytes) c = static_cast<char>(random());
  // Half of them with a header that is let in, so that the rest is looked at.
  if (random() % 2 == 0 && bytes.size() > 16) {
    bytes.replace(0, 4, std::string{'G', 'P', 0, static_cast<char>(random() % 10)});
    bytes.replace(8, 5, std::string{1, static_cast<char>(1 + random() % 3), 0, 0, 0});
  }
  return bytes;
}

std::string mutated(std::string bytes, std::mt19937& random) {
  for (auto edits = 1 + random() % 4; edits > 0; --edits) {
    const std::size_t at = random() % bytes.size();
    const std::size_t n = std::min<std::size_t>(random() % 20, bytes.size() - at);
    switch (random() % 4) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        break;
      case 2:
        bytes.insert(at, bytes.substr(bytes.size() - at - n, n));
        break;
      default:
        if (n < bytes.size()) bytes.erase(at, n);
    }
  }
  return bytes;
}

TEST(GeometryBlob, SurvivesRandomAndMutatedBytes) {
  const unsigned seed = std::random_device{}();
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  const City city = test::sample_city();
  std::vector<std::string> corpus = {encode_point({1, 2}), encode_line({}), encode_polygon({})};
  for (const auto& gate : city.gates) corpus.push_back(encode_line(gate.line));
  for (const auto& sector : city.sectors) corpus.push_back(encode_polygon(sector.ground));
  for (int i = 0; i < 100'000; ++i) {
    const std::string bytes = i % 3 == 0 ? random_bytes(random) : mutated(corpus[random() % corpus.size()], random);
    // A copy of exactly this size, so that a sanitizer sees every byte read past the end.
    const std::vector<std::uint8_t> exact(bytes.begin(), bytes.end());
    LLVMFuzzerTestOneInput(exact.data(), exact.size());
  }
}

}  // namespace
}  // namespace vicus
