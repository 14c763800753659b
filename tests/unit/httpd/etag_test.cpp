#include "httpd/etag.hpp"

#include <gtest/gtest.h>

namespace vicus {
namespace {

TEST(EtagOf, DiffersByCodingAndHoldsNoQuote) {
  EXPECT_EQ(etag_of("abc", "br"), "\"abc-br\"");
  EXPECT_NE(etag_of("abc", "br"), etag_of("abc", "gzip"));
  EXPECT_EQ(etag_of("a\"b\r\nc\xff", "br"), "\"abc-br\"");
}

TEST(NamesEtag, FindsTheTagInAList) {
  EXPECT_TRUE(names_etag("\"a-br\"", "\"a-br\""));
  EXPECT_TRUE(names_etag("\"x\", \"a-br\"", "\"a-br\""));
  EXPECT_TRUE(names_etag(" \"x\" ,,W/\"a-br\" ", "\"a-br\""));
  EXPECT_TRUE(names_etag("\"a,b\", \"a-br\"", "\"a-br\""));
  EXPECT_TRUE(names_etag("*", "\"a-br\""));
}

TEST(NamesEtag, IsFalseForOthersAndForWhatIsNoList) {
  EXPECT_FALSE(names_etag(std::nullopt, "\"a-br\""));
  for (const char* field : {"", "\"a-gzip\"", "a-br", "\"a-br", "\"x\" \"a-br\"", "\"a-br\" x", "\"a-br\", x", "**",
                            "*, \"a-br\"", "w/\"a-br\"", "\"xa-br\"", "\"a-brx\"", "W/"})
    EXPECT_FALSE(names_etag(field, "\"a-br\"")) << field;
}

}  // namespace
}  // namespace vicus
