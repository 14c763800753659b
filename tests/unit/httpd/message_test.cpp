#include "httpd/message.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "httpd/metrics.hpp"
#include "httpd/problem.hpp"
#include "httpd/response_head.hpp"

namespace vicus {
namespace {

TEST(FieldOf, JoinsLinesOfOneName) {
  const HttpFields fields = {{"Accept", "a"}, {"Host", "h"}, {"aCCEPT", "b"}};
  EXPECT_EQ(field_of(fields, "accept"), "a, b");
  EXPECT_EQ(field_of(fields, "Accep"), std::nullopt);
}

TEST(SetField, ReplacesEveryLineOfThatName) {
  HttpFields fields = {{"vary", "a"}, {"X", "1"}, {"Vary", "b"}};
  set_field(fields, "Vary", "c");
  EXPECT_EQ(fields, (HttpFields{{"X", "1"}, {"Vary", "c"}}));
}

TEST(Problem, IsJsonThatSaysWhatToDo) {
  const auto response = problem(404, "There is no sector \"\xff\". Ask /collections.");
  EXPECT_EQ(response.status, 404);
  EXPECT_EQ(field_of(response.fields, "Content-Type"), "application/problem+json");
  const auto json = nlohmann::json::parse(*response.body);
  EXPECT_EQ(json["status"], 404);
  EXPECT_EQ(json["title"], "Not Found");
  EXPECT_EQ(json["detail"], "There is no sector \"\xef\xbf\xbd\". Ask /collections.");
}

TEST(ResponseHead, StatesLengthConnectionAndDate) {
  HttpResponse response;
  response.fields = {{"Content-Type", "text/plain"}};
  response.body = body_of("hello");
  EXPECT_EQ(response_head(response, true, 784111777),  // the example of RFC 9110 §5.6.7
            "HTTP/1.1 200 OK\r\nDate: Sun, 06 Nov 1994 08:49:37 GMT\r\nServer: vicus\r\nContent-Type: text/plain\r\n"
            "Content-Length: 5\r\nConnection: keep-alive\r\n\r\n");
}

TEST(ResponseHead, GivesNoLengthTo304AndZeroToAnEmptyAnswer) {
  HttpResponse response;
  response.status = 304;
  EXPECT_EQ(response_head(response, false, 0).find("Content-Length"), std::string::npos);
  response.status = 404;
  EXPECT_NE(response_head(response, false, 0).find("Content-Length: 0\r\nConnection: close\r\n\r\n"),
            std::string::npos);
}

TEST(ResponseHead, LetsNoValueBeginALine) {
  HttpResponse response;
  response.fields = {{"Content-Type", "text/plain\r\nSet-Cookie: a=b"}};
  EXPECT_EQ(response_head(response, false, 0).find("\r\nSet-Cookie"), std::string::npos);
}

TEST(Metrics, CountsAnswersAndTimes) {
  Metrics metrics;
  metrics.connection_opened();
  metrics.count_answer("sector", 200, 1000, 0.0004);
  metrics.count_answer("sector", 200, 500, 0.002);
  metrics.count_answer("page", 404, 10, 60);
  const auto text = metrics.text();
  for (const char* line :
       {"vicus_requests_total{route=\"sector\",status=\"200\"} 2\n",
        "vicus_requests_total{route=\"page\",status=\"404\"} 1\n",
        "vicus_sent_bytes_total{route=\"sector\",status=\"200\"} 1500\n",
        "vicus_request_seconds_bucket{le=\"0.0005\"} 1\n", "vicus_request_seconds_bucket{le=\"0.0025\"} 2\n",
        "vicus_request_seconds_bucket{le=\"5\"} 2\n", "vicus_request_seconds_bucket{le=\"+Inf\"} 3\n",
        "vicus_request_seconds_count 3\n", "vicus_open_connections 1\n", "vicus_connections_total 1\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

}  // namespace
}  // namespace vicus
