#include "httpd/url.hpp"

#include <gtest/gtest.h>

#include <random>

namespace vicus {
namespace {

std::string path_of(std::string_view target) {
  std::string reason;
  const auto url = parse_url(target, reason);
  return url ? url->path : "refused: " + reason;
}
bool is_refused(std::string_view target) {
  std::string reason;
  return !parse_url(target, reason) && !reason.empty();
}

TEST(ParseUrl, DecodesThePathOnce) {
  EXPECT_EQ(path_of("/"), "/");
  EXPECT_EQ(path_of("/sectors/r12.far.x3d"), "/sectors/r12.far.x3d");
  EXPECT_EQ(path_of("/a%20b"), "/a b");
  EXPECT_EQ(path_of("/L%C3%B6wen"), "/L\xc3\xb6wen");
  EXPECT_EQ(path_of("/%2525"), "/%25");
  EXPECT_EQ(path_of("/a+b"), "/a+b");
  EXPECT_EQ(path_of("/collections/"), "/collections/");
}

TEST(ParseUrl, TakesAbsoluteForm) {
  EXPECT_EQ(path_of("http://example.org:8080/city.x3d?start=a"), "/city.x3d");
  EXPECT_EQ(path_of("https://example.org"), "/");
  EXPECT_TRUE(is_refused("http://example.org?x=1"));
}

TEST(ParseUrl, RefusesWhatHasAnotherSpelling) {
  for (const char* target :
       {"",          "x",    "*",      "//",     "//a",    "/a//b", "/.",   "/..",  "/a/../b", "/a/./b", "/a/..",
        "/%2e%2e/b", "/%2E", "/a%2fb", "/a%2Fb", "/a%5cb", "/a\\b", "/%41", "/%7e", "/a#b",    "/a b"})
    EXPECT_TRUE(is_refused(target)) << target;
}

TEST(ParseUrl, RefusesBadAndHostileBytes) {
  for (const char* target :
       {"/%",        "/%4",      "/%zz",          "/%0",        "/a%00b",   "/%0a",    "/%0d%0a",    "/%7f",
        "/%1f",      "/%c0%af",  "/%c0%ae%c0%ae", "/%e0%80%af", "/%ff",     "/%c3",    "/%ed%a0%80", "/%f4%90%80%80",
        "/\xc3\xb6", "/a?b=%00", "/a?b=%ff",      "/a?b=%",     "/a?b=c d", "/a?b=c#d"})
    EXPECT_TRUE(is_refused(target)) << target;
  EXPECT_TRUE(is_refused(std::string_view("/a\0b", 4)));
}

TEST(ParseUrl, ReadsTheQueryInOrder) {
  std::string reason;
  const auto url = parse_url("/x?bbox=1%2C2,3&q=a+b%2B&&empty=&alone&%C3%A9=%2F%5C", reason);
  ASSERT_TRUE(url) << reason;
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"bbox", "1,2,3"}, {"q", "a b+"}, {"empty", ""}, {"alone", ""}, {"\xc3\xa9", "/\\"}};
  EXPECT_EQ(url->query, expected);
}

TEST(ParameterOf, TellsAMissingFromARepeatedOne) {
  std::string reason;
  const auto url = parse_url("/x?a=1&b=2&b=3", reason);
  bool repeated = true;
  EXPECT_EQ(parameter_of(*url, "a", repeated), "1");
  EXPECT_FALSE(repeated);
  EXPECT_EQ(parameter_of(*url, "b", repeated), std::nullopt);
  EXPECT_TRUE(repeated);
  EXPECT_EQ(parameter_of(*url, "c", repeated), std::nullopt);
  EXPECT_FALSE(repeated);
}

std::string random_text(std::mt19937& random) {
  std::string text;
  for (auto n = random() % 12; n > 0; --n) {
    const auto code = static_cast<std::uint32_t>(random() % 4 == 0 ? 0xa0 + random() % 0x5000 : 0x20 + random() % 0x5f);
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xc0 | code >> 6);
      text += static_cast<char>(0x80 | (code & 0x3f));
    } else {
      text += static_cast<char>(0xe0 | code >> 12);
      text += static_cast<char>(0x80 | (code >> 6 & 0x3f));
      text += static_cast<char>(0x80 | (code & 0x3f));
    }
  }
  return text;
}

TEST(EncodeUrlPart, IsUndoneByParseUrl) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto text = random_text(random), value = random_text(random);
    ASSERT_TRUE(is_utf8(text));
    std::string reason;
    const auto in_query = parse_url("/x?k=" + encode_url_part(value), reason);
    ASSERT_TRUE(in_query) << reason;
    EXPECT_EQ(in_query->query.at(0).second, value);
    if (text.empty() || text == "." || text == ".." || text.find_first_of("/\\") != text.npos) continue;
    EXPECT_EQ(path_of("/" + encode_url_part(text)), "/" + text);
  }
}

TEST(ParseUrl, AcceptsOnlyPathsThatHoldItsPromise) {
  const std::string alphabet = "/.%2eEfF5cC0a?&=+#\\ \xc3\xb6";
  int accepted = 0;
  for (unsigned seed = 0; seed < 20000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::string target = "/", reason;
    for (auto n = random() % 10; n > 0; --n) target += alphabet[random() % alphabet.size()];
    const auto url = parse_url(target, reason);
    EXPECT_NE(url.has_value(), !reason.empty()) << target;
    if (!url) continue;
    ++accepted;
    EXPECT_TRUE(is_utf8(url->path));
    EXPECT_EQ(url->path.find("//"), std::string::npos) << target;
    EXPECT_EQ((url->path + "/").find("/../"), std::string::npos) << target;
    EXPECT_EQ((url->path + "/").find("/./"), std::string::npos) << target;
    EXPECT_EQ(url->path.find_first_of(std::string("\\\0\n\r", 4)), std::string::npos) << target;
  }
  EXPECT_GT(accepted, 1000);
}

}  // namespace
}  // namespace vicus
