#include "city_db/roof_blob.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/sample_city.hpp"

/// Roofs as bytes: what is written comes back, and hostile bytes are refused.
namespace vicus {
namespace {

Roof roof_with_a_gable() {
  Roof roof = test::sample_city().buildings[0].roof;
  roof.points.push_back({{-1'073'741'823, 5}, 123'456});
  roof.facets.push_back({FacetKind::gable, {{0, 1, 4}}, {0, 1, 4}});
  roof.facets.push_back({FacetKind::slope, {{1, 2, 4}, {2, 1, 4}}, {1, 2, 4}});
  return roof;
}

TEST(RoofBlob, GivesBackRoofs) {
  EXPECT_EQ(decode_roof(encode_roof({})), Roof{});
  EXPECT_EQ(decode_roof(encode_roof(roof_with_a_gable())), roof_with_a_gable());
  for (const auto& b : test::sample_city().buildings) EXPECT_EQ(decode_roof(encode_roof(b.roof)), b.roof);
}

TEST(RoofBlob, RefusesEveryTruncationAndAddition) {
  const std::string bytes = encode_roof(roof_with_a_gable());
  for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_EQ(decode_roof(bytes.substr(0, n)), std::nullopt) << n;
  EXPECT_EQ(decode_roof(bytes + '\0'), std::nullopt);
}

TEST(RoofBlob, RefusesIndicesKindsAndPlacesThatCannotBe) {
  Roof roof = roof_with_a_gable();
  roof.facets[1].rings[0][2] = 5;
  EXPECT_EQ(decode_roof(encode_roof(roof)), std::nullopt);
  roof = roof_with_a_gable();
  roof.facets[2].triangles[0] = 5;
  EXPECT_EQ(decode_roof(encode_roof(roof)), std::nullopt);
  roof = roof_with_a_gable();
  roof.facets[0].kind = static_cast<FacetKind>(4);
  EXPECT_EQ(decode_roof(encode_roof(roof)), std::nullopt);
  roof = roof_with_a_gable();
  roof.points[0].at.x = kPlanLimit;
  EXPECT_EQ(decode_roof(encode_roof(roof)), std::nullopt);
}

TEST(RoofBlob, SurvivesRandomBytes) {
  const std::string bytes = encode_roof(roof_with_a_gable());
  std::mt19937_64 random(7);
  for (int i = 0; i < 20'000; ++i) {
    std::string mutated = bytes;
    for (int k = 0; k < 3; ++k) mutated[random() % mutated.size()] = static_cast<char>(random());
    if (const auto roof = decode_roof(mutated)) {
      EXPECT_EQ(encode_roof(*roof), mutated);
    }
  }
}

}  // namespace
}  // namespace vicus
