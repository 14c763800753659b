#include "city_db/json_text.hpp"

#include <gtest/gtest.h>

#include <random>

namespace vicus {
namespace {

using Names = std::vector<std::string>;

TEST(JsonText, WritesWhatSqlAndQgisRead) {
  EXPECT_EQ(json_from_names({}), "[]");
  EXPECT_EQ(json_from_names({"a", "\"Zum <Löwen> & Co\"", "\\\n"}), R"(["a","\"Zum <Löwen> & Co\"","\\\u000a"])");
  EXPECT_EQ(json_from_tags({}), "{}");
  EXPECT_EQ(json_from_tags({{"b", "2"}, {"a", "1"}}), R"({"a":"1","b":"2"})");
}

TEST(JsonText, GivesBackEveryByteString) {
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    Names names(random() % 5);
    Tags tags;
    for (auto& name : names) {
      name.resize(random() % 12);
      for (char& c : name) c = static_cast<char>(random());
      tags[name] = names.front();
    }
    ASSERT_EQ(names_from_json(json_from_names(names)), names);
    ASSERT_EQ(tags_from_json(json_from_tags(tags)), tags);
  }
}

TEST(JsonText, ReadsWhatOthersWrite) {
  EXPECT_EQ(names_from_json(" [ \"a\" ,\t\"\\b\\f\\n\\r\\t\\/\\\"\\\\\" ]\r\n"), (Names{"a", "\b\f\n\r\t/\"\\"}));
  EXPECT_EQ(names_from_json(R"(["\u0041\u00f6\u20AC"])"), Names{"Aö€"});
  EXPECT_EQ(tags_from_json(R"( { "a" : "1" , "b":"2" } )"), (Tags{{"a", "1"}, {"b", "2"}}));
}

TEST(JsonText, RefusesEverythingElse) {
  for (const char* text : {"", "[", "]", "[\"a\"", "[\"a\",]", "[,]", "[1]", "[null]", "[\"a\"]x", "[\"\\u12\"]",
                           "[\"\\x\"]", "[\"\\ud83d\\ude00\"]", "{}", "[[\"a\"]]", "\"a\"", "[\"a\" \"b\"]"})
    EXPECT_EQ(names_from_json(text), std::nullopt) << text;
  for (const char* text : {"", "{", "[]", "{\"a\"}", "{\"a\":}", "{\"a\":1}", "{\"a\":\"b\",}", "{\"a\":{}}", "{}{}"})
    EXPECT_EQ(tags_from_json(text), std::nullopt) << text;
}

}  // namespace
}  // namespace vicus
