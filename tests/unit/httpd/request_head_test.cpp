#include "httpd/request_head.hpp"

#include <gtest/gtest.h>

#include "httpd/url.hpp"

namespace vicus {
namespace {

int status_of_bytes(std::string_view head) {
  const auto fault = fault_of_bytes(head);
  return fault ? fault->status : 200;
}
int status_of_fields(HttpFields fields, bool is_http_1_0 = false) {
  const auto fault = fault_of_fields({"GET", "/", std::move(fields)}, is_http_1_0);
  return fault ? fault->status : 200;
}

TEST(HeadLength, EndsAfterTheEmptyLine) {
  EXPECT_EQ(head_length(""), std::nullopt);
  EXPECT_EQ(head_length("GET / HTTP/1.1\r\nHost: a\r\n"), std::nullopt);
  EXPECT_EQ(head_length("GET / HTTP/1.1\r\n\r"), std::nullopt);
  EXPECT_EQ(head_length("GET / HTTP/1.1\r\n\r\nNEXT"), 18u);
  EXPECT_EQ(head_length("GET / HTTP/1.1\n\nNEXT"), 16u);
  EXPECT_EQ(head_length("GET / HTTP/1.1\n\r\nNEXT"), 17u);
}

TEST(FaultOfBytes, PassesAnOrdinaryHead) {
  EXPECT_EQ(status_of_bytes("GET / HTTP/1.1\r\nHost: a\r\nAccept:\r\nX: \t b \x80\r\n\r\n"), 200);
}

TEST(FaultOfBytes, RefusesWhatAParserMightReadInTwoWays) {
  using namespace std::string_view_literals;
  for (const auto head :
       {"GET / HTTP/1.1\nHost: a\r\n\r\n"sv, "GET / HTTP/1.1\r\nA: b\rC: d\r\n\r\n"sv,
        "GET / HTTP/1.1\r\nA: b\r\n c\r\n\r\n"sv, "GET / HTTP/1.1\r\nA: b\r\n\tc\r\n\r\n"sv,
        "GET / HTTP/1.1\r\n A: b\r\n\r\n"sv, "GET / HTTP/1.1\r\nA : b\r\n\r\n"sv, "GET / HTTP/1.1\r\nA\t: b\r\n\r\n"sv,
        "GET / HTTP/1.1\r\nA\r\n\r\n"sv, "GET / HTTP/1.1\r\n: b\r\n\r\n"sv, "GET / HTTP/1.1\r\nA: \0\r\n\r\n"sv,
        "GET / HTTP/1.1\r\nA: \x01\r\n\r\n"sv, "GET / HTTP/1.1\r\nA: \x7f\r\n\r\n"sv, "GET  / HTTP/1.1\r\n\r\n"sv,
        "GET / x HTTP/1.1\r\n\r\n"sv, "GET /\r\n\r\n"sv, "GET\r\n\r\n"sv, "\r\n\r\n"sv})
    EXPECT_EQ(status_of_bytes(head), 400) << head;
}

TEST(FaultOfBytes, Says414ForALongTargetOnly) {
  EXPECT_EQ(status_of_bytes("GET /" + std::string(kMaxTargetBytes - 1, 'a') + " HTTP/1.1\r\n\r\n"), 200);
  EXPECT_EQ(status_of_bytes("GET /" + std::string(kMaxTargetBytes, 'a') + " HTTP/1.1\r\n\r\n"), 414);
}

TEST(FaultOfEndless, BlamesTheLineThatDoesNotEnd) {
  EXPECT_EQ(fault_of_endless("GET /" + std::string(20000, 'a')).status, 414);
  EXPECT_EQ(fault_of_endless("GET / HTTP/1.1\r\nA: " + std::string(20000, 'a')).status, 431);
}

TEST(FaultOfFields, WantsExactlyOneHost) {
  EXPECT_EQ(status_of_fields({{"Host", "a"}}), 200);
  EXPECT_EQ(status_of_fields({}), 400);
  EXPECT_EQ(status_of_fields({{"Host", "a"}, {"hOST", "a"}}), 400);
  EXPECT_EQ(status_of_fields({}, true), 200);
  EXPECT_EQ(status_of_fields({{"Host", "a"}, {"Host", "a"}}, true), 400);
}

TEST(FaultOfFields, KeepsBodiesUnambiguous) {
  const auto with = [](HttpFields more) {
    more.emplace_back("Host", "a");
    return status_of_fields(std::move(more));
  };
  EXPECT_EQ(with({{"Content-Length", "3"}}), 200);
  EXPECT_EQ(with({{"Transfer-Encoding", "Chunked"}}), 200);
  EXPECT_EQ(with({{"Transfer-Encoding", "xchunked"}}), 501);
  EXPECT_EQ(with({{"Transfer-Encoding", "gzip, chunked"}}), 501);
  EXPECT_EQ(with({{"Transfer-Encoding", "chunked"}, {"Transfer-Encoding", "chunked"}}), 501);
  EXPECT_EQ(with({{"Transfer-Encoding", "chunked"}, {"Content-Length", "3"}}), 400);
  EXPECT_EQ(with({{"Content-Length", "3"}, {"Content-Length", "3"}}), 400);
  EXPECT_EQ(with({{"Expect", "100-continue"}}), 417);
  EXPECT_EQ(status_of_fields({{"Transfer-Encoding", "chunked"}}, true), 400);
}

}  // namespace
}  // namespace vicus
