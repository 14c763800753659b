#include "x3d_export/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "city_db/steady_hash.hpp"

namespace vicus {
namespace {

std::string number(double value, int decimals = 3) {
  std::string out;
  append_number(out, value, decimals);
  return out;
}

TEST(AppendNumber, WritesTheShortestDecimal) {
  EXPECT_EQ(number(0), "0");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(number(-0.0004), "0");
  EXPECT_EQ(number(12), "12");
  EXPECT_EQ(number(12.5), "12.5");
  EXPECT_EQ(number(-0.04), "-0.04");
  EXPECT_EQ(number(1000.001), "1000.001");
  EXPECT_EQ(number(0.0005, 3), "0.001");
  EXPECT_EQ(number(-1.570796326, 6), "-1.570796");
}

TEST(AppendNumber, GivesEveryLatticeValueBackAsAFloatWithinHalfAMillimetre) {
  const unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int32_t> mm(-1'000'000, 1'000'000);  // sectors are at most about 1 km wide
  for (int i = 0; i < 100'000; ++i) {
    const std::int32_t value = mm(random);
    const std::string text = number(value / 1000.0);
    EXPECT_EQ(std::llround(std::stod(text) * 1000), value) << text;
    ASSERT_NEAR(static_cast<double>(std::stof(text)) * 1000, value, 0.5) << text;
  }
}

TEST(AppendNumber, IsTheNearestDecimalOfRandomNumbers) {
  constexpr unsigned kSeed = 27;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 100'000; ++i) {
    const int decimals = static_cast<int>(random() % 7);
    const double value =
        std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random), static_cast<int>(random() % 36));
    const std::string text = number(value, decimals);
    const double back = std::stod(text), half_unit = 0.5 * std::pow(10, -decimals);
    EXPECT_LE(std::abs(back - value), half_unit * (1 + 1e-9) + std::abs(value) * 1e-15) << text << " for " << value;
    EXPECT_TRUE(text.find('.') == std::string::npos || (text.back() != '0' && text.back() != '.')) << text;
    EXPECT_NE(text, "-0");
  }
}

TEST(AppendNumbers, BreaksLinesOnlyBetweenValues) {
  std::vector<double> values(300, 1.25);
  std::string out;
  append_numbers(out, values, 3, 3);
  std::size_t lines = 0;
  std::istringstream in(out);
  for (std::string line; std::getline(in, line); ++lines) {
    std::istringstream words(line);
    std::size_t count = 0;
    for (std::string word; words >> word;) ++count;
    EXPECT_EQ(count % 3, 0u) << line;
    EXPECT_LT(line.size(), 140u);
  }
  EXPECT_GT(lines, 5u);
}

TEST(CleanText, KeepsWhatIsTextAndReplacesTheRest) {
  const std::string replacement = "\xEF\xBF\xBD";
  EXPECT_EQ(clean_text("\"Zum <Löwen> & Co\""), "\"Zum <Löwen> & Co\"");
  EXPECT_EQ(clean_text("a\nb\tc\x01"), "a b c ");
  EXPECT_EQ(clean_text(std::string("a\0b", 3)), "a b");
  EXPECT_EQ(clean_text("x\x7Fy\xC2\x85z"), "x y z") << "DEL and C1 controls";
  EXPECT_EQ(clean_text("\xFF"), replacement);
  EXPECT_EQ(clean_text("\xC0\xAF"), replacement + replacement) << "overlong";
  EXPECT_EQ(clean_text("\xE2\x82"), replacement + replacement) << "cut off";
  EXPECT_EQ(clean_text("\xED\xA0\x80"), replacement) << "surrogate";
  EXPECT_EQ(clean_text("\xEF\xBF\xBE"), replacement) << "U+FFFE";
  EXPECT_EQ(clean_text("\xF0\x9F\x8F\xA0"), "\xF0\x9F\x8F\xA0") << "a house beyond the first plane";
}

TEST(CleanText, IsSettledAfterOnceOnRandomBytes) {
  const unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes(random() % 12, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    const std::string once = clean_text(bytes);
    ASSERT_EQ(clean_text(once), once);
  }
}

TEST(Escapes, KeepMarkupOutOfNames) {
  EXPECT_EQ(xml_escaped("O'Neill <b> & \"x\""), "O&apos;Neill &lt;b&gt; &amp; \"x\"");
  EXPECT_EQ(vrml_quoted("a \"b\" \\ c"), "\"a \\\"b\\\" \\\\ c\"");
  EXPECT_EQ(caption_of("\"Zum Löwen\""), "“Zum Löwen”");
  EXPECT_EQ(caption_of("the \"Lion\" inn"), "the \"Lion\" inn");
}

TEST(SteadyHash, NeverChanges) {
  EXPECT_EQ(steady_hash("r12"), steady_hash("r12"));
  EXPECT_NE(steady_hash("r12"), steady_hash("r13"));
  std::vector<int> count(12, 0);
  for (int i = 0; i < 1200; ++i) ++count[steady_hash("way/" + std::to_string(i)) % 12];
  for (const int n : count) EXPECT_NEAR(n, 100, 50) << "the palette is used evenly";
}

}  // namespace
}  // namespace vicus
