#include "sectorgen/geo/tag_values.hpp"

#include <gtest/gtest.h>

namespace vicus::test {
namespace {

TEST(ParseMetres, ReadsMetresHoweverWritten) {
  for (const char* text : {"12.5", "12,5", " 12.5 ", "12.5m", "12.5 m", "+12.5", "1250 cm", "12.50 metres"})
    EXPECT_DOUBLE_EQ(parse_metres(text).value_or(-1), 12.5) << text;
  EXPECT_DOUBLE_EQ(parse_metres("-3").value_or(0), -3);
  EXPECT_DOUBLE_EQ(parse_metres(".5").value_or(0), 0.5);
}

TEST(ParseMetres, ReadsFeetAndInches) {
  for (const char* text : {"40'", "40 ft", "40ft", "40 feet", "40'0\"", "40′"})
    EXPECT_NEAR(parse_metres(text).value_or(-1), 12.192, 1e-9) << text;
  for (const char* text : {"5'6\"", "5' 6\"", "5'6", "5 ft 6 in", "66\"", "66 in"})
    EXPECT_NEAR(parse_metres(text).value_or(-1), 1.6764, 1e-9) << text;
}

TEST(ParseMetres, RefusesEverythingElse) {
  for (const char* text : {"", " ", "m", "high", "~12", "10-12", "10;12", "12 storeys", "1.2.3", "--1", "nan", "inf",
                           "1e400", "12'x", "12'-3\"", "0x10"})
    EXPECT_FALSE(parse_metres(text)) << text;
}

TEST(ParseNumber, ReadsPlainNumbersOnly) {
  EXPECT_DOUBLE_EQ(parse_number("2,5").value_or(0), 2.5);
  EXPECT_DOUBLE_EQ(parse_number("-1").value_or(0), -1);
  for (const char* text : {"", "2;3", "1-2", "five", "3 m", "2 lanes"}) EXPECT_FALSE(parse_number(text)) << text;
}

TEST(IsYes, TakesEverythingButNo) {
  EXPECT_TRUE(is_yes({{"bridge", "yes"}}, "bridge"));
  EXPECT_TRUE(is_yes({{"bridge", "viaduct"}}, "bridge"));
  EXPECT_FALSE(is_yes({{"bridge", "no"}}, "bridge"));
  EXPECT_FALSE(is_yes({}, "bridge"));
}

}  // namespace
}  // namespace vicus::test
