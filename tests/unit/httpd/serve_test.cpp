#include "httpd/serve.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <thread>

#include "city_db/issues.hpp"
#include "tests/unit/httpd/raw_client.hpp"

namespace vicus {
namespace {

using test::RawClient;
using test::status_of;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kBigBytes = 64 << 20;

/// A server on a free port, with answers of its own: /slow takes 400 ms, /big is 64 MB, all else echoes the target.
class Server {
 public:
  explicit Server(const std::function<void(ServeOptions&)>& change = [](ServeOptions&) {}) {
    ServeOptions options;
    options.port = 0;
    options.threads = 2;
    change(options);
    const auto new_responder = [this]() -> Responder {
      return [this](const HttpRequest& request) {
        ++asked;
        if (request.target == "/slow") std::this_thread::sleep_for(400ms);
        HttpResponse response;
        response.body = request.target == "/big" ? big_ : body_of(request.target);
        return response;
      };
    };
    server_ = std::make_unique<HttpServer>(options, new_responder, metrics, nullptr);
    thread_ = std::thread([this] { server_->run(); });
  }
  ~Server() { stop(); }
  void begin_stop() { server_->stop(); }
  void stop() {
    server_->stop();
    if (thread_.joinable()) thread_.join();
  }
  std::uint16_t port() const { return server_->port(); }
  std::string answer(std::string_view bytes) {
    RawClient client(port());
    client.send(bytes);
    return client.read_all();
  }

  std::shared_ptr<Metrics> metrics = std::make_shared<Metrics>();
  std::atomic<int> asked = 0;

 private:
  std::shared_ptr<const std::string> big_ = body_of(std::string(kBigBytes, 'x'));
  std::unique_ptr<HttpServer> server_;
  std::thread thread_;
};

const std::string kGet = "GET /a HTTP/1.1\r\nHost: t\r\n\r\n";
const std::string kLastGet = "GET /z HTTP/1.1\r\nHost: t\r\nConnection: close\r\n\r\n";

template <class Condition>
bool comes_true(Condition condition) {
  for (const auto end = Clock::now() + 20s; Clock::now() < end; std::this_thread::sleep_for(5ms))
    if (condition()) return true;
  return false;
}

TEST(HttpServer, AnswersPipelinedRequestsInOrder) {
  Server server;
  const auto all = server.answer("GET /1 HTTP/1.1\r\nHost: t\r\n\r\nGET /2 HTTP/1.1\r\nHost: t\r\n\r\n" + kLastGet);
  const auto one = all.find("\r\n\r\n/1HTTP/1.1 200"), two = all.find("\r\n\r\n/2HTTP/1.1 200");
  EXPECT_NE(one, std::string::npos) << all;
  EXPECT_NE(two, std::string::npos) << all;
  EXPECT_LT(one, two);
  EXPECT_TRUE(all.ends_with("\r\n\r\n/z")) << all;
}

TEST(HttpServer, TakesARequestInSinglePiecesAndEmptyLinesBeforeIt) {
  Server server;
  RawClient client(server.port());
  for (const char c : "\r\n\r\n" + kLastGet) client.send({&c, 1});
  EXPECT_EQ(status_of(client.read_all()), 200);
  EXPECT_TRUE(client.is_closed());
}

TEST(HttpServer, GivesHeadTheLengthWithoutTheBody) {
  Server server;
  const auto answer = server.answer("HEAD /hello HTTP/1.1\r\nHost: t\r\nConnection: close\r\n\r\n");
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_NE(answer.find("Content-Length: 6\r\n"), std::string::npos);
  EXPECT_TRUE(answer.ends_with("\r\n\r\n"));
}

TEST(HttpServer, RefusesWhatIsNoClearRequestAndCloses) {
  Server server;
  const std::string host = "Host: t\r\n";
  const std::vector<std::pair<std::string, int>> cases = {
      {"GET / HTTP/1.1\r\n" + host + "Content-Length: 3\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n", 400},
      {"GET / HTTP/1.1\r\n" + host + "Content-Length: 3\r\nContent-Length: 4\r\n\r\nabc", 400},
      {"GET / HTTP/1.1\r\n" + host + "Content-Length: 3\r\nContent-Length: 3\r\n\r\nabc", 400},
      {"GET / HTTP/1.1\r\n" + host + "Content-Length: -3\r\n\r\n", 400},
      {"GET / HTTP/1.1\r\n" + host + "Content-Length: 99999999999999999999999\r\n\r\n", 400},
      {"GET / HTTP/1.1\r\nHost : t\r\n\r\n", 400},
      {"GET / HTTP/1.1\r\n" + host + "A: b\r\n folded\r\n\r\n", 400},
      {"GET / HTTP/1.1\nHost: t\n\n", 400},
      {"GET / HTTP/1.1\r\n\r\n", 400},
      {"GET / HTTP/1.1\r\n" + host + host + "\r\n", 400},
      {"GET / HTTP/1.1\r\n" + host + "A: b" + std::string(1, '\0') + "c\r\n\r\n", 400},
      {"GET / HTTP/1.1\r\n" + host + "A b: c\r\n\r\n", 400},
      {"GET / HTTP/1.1\r\n" + host + "Transfer-Encoding: xchunked\r\n\r\n", 501},
      {"GET / HTTP/1.1\r\n" + host + "Transfer-Encoding: chunked\r\n\r\nzz\r\n", 400},
      {"GET / HTTP/1.1\r\n" + host + "Expect: 100-continue\r\nContent-Length: 3\r\n\r\n", 417},
      {"GET / HTTP/1.1\r\n" + host + "Content-Length: 5000\r\n\r\n", 413},
      {"GET / HTTP/1.1\r\n" + host + "Transfer-Encoding: chunked\r\n\r\n2000\r\n" + std::string(0x2000, 'a'), 413},
      {"GET / HTTP/2.0\r\n" + host + "\r\n", 505},
      {"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", 505},
      {"\x16\x03\x01\x02\x01\x01\xfc\x03\x03\r\n\r\n", 400},
      {"GET /" + std::string(5000, 'a') + " HTTP/1.1\r\n" + host + "\r\n", 414},
      {"GET /" + std::string(20000, 'a'), 414},
      {"GET / HTTP/1.1\r\nA: " + std::string(20000, 'a'), 431},
      {"GET / HTTP/1.1\r\n" + host +
           [] {
             std::string many;
             for (int i = 0; i < 3000; ++i) many += "A: b\r\n";
             return many;
           }() +
           "\r\n",
       431}};
  for (const auto& [bytes, status] : cases) {
    SCOPED_TRACE(bytes.substr(0, 90));
    RawClient client(server.port());
    client.send(bytes + kGet);  // what follows must not be taken for a request of its own
    const auto answer = client.read_all();
    EXPECT_EQ(status_of(answer), status) << answer;
    EXPECT_TRUE(client.is_closed());
    EXPECT_NE(answer.find("application/problem+json"), std::string::npos);
    EXPECT_NE(answer.find("Connection: close"), std::string::npos);
    EXPECT_EQ(answer.find("\nHTTP/1.1 "), std::string::npos) << answer;
  }
  EXPECT_EQ(server.asked, 0);
  EXPECT_EQ(status_of(server.answer(kLastGet)), 200);
}

TEST(HttpServer, CutsOffAHeaderLineOf64Megabytes) {
  Server server;
  RawClient client(server.port());
  client.send("GET / HTTP/1.1\r\nHost: t\r\nA: ");
  const std::string piece(1 << 20, 'a');
  std::size_t sent = 0;
  for (int i = 0; i < 64; ++i) {
    const auto n = client.send(piece);
    sent += n;
    if (n < piece.size()) break;
  }
  EXPECT_LT(sent, 32u << 20);  // the rest of what it took lay in the kernel's buffers
  EXPECT_TRUE(comes_true([&] { return server.metrics->open_connections() == 0; }));
}

TEST(HttpServer, ClosesOnATrickleOfBytes) {
  Server server([](ServeOptions& options) { options.head_time = 300ms; });
  RawClient client(server.port());
  const auto began = Clock::now();
  const auto bytes = "GET / HTTP/1.1\r\nHost: t\r\nA: " + std::string(4000, 'a');
  for (const char c : bytes) {
    if (client.send({&c, 1}) == 0) break;
    if (Clock::now() - began > 15s) break;
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_LT(Clock::now() - began, 10s);
  EXPECT_EQ(server.asked, 0);
}

TEST(HttpServer, ClosesOnABodyThatDoesNotCome) {
  Server server([](ServeOptions& options) { options.body_time = 200ms; });
  RawClient client(server.port());
  client.send("GET / HTTP/1.1\r\nHost: t\r\nContent-Length: 10\r\n\r\nabc");
  client.read_all();
  EXPECT_TRUE(client.is_closed());
  EXPECT_EQ(server.asked, 0);
}

TEST(HttpServer, ClosesAnIdleConnectionButNotBetweenRequests) {
  Server server([](ServeOptions& options) { options.idle_time = 300ms; });
  RawClient client(server.port());
  for (int i = 0; i < 3; ++i) {
    client.send(kGet);
    EXPECT_EQ(status_of(client.read_answer()), 200);
    std::this_thread::sleep_for(20ms);
  }
  EXPECT_EQ(client.read_all(), "");
  EXPECT_TRUE(client.is_closed());
}

TEST(HttpServer, ClosesOnAClientThatDoesNotRead) {
  Server server([](ServeOptions& options) {
    options.write_time = 200ms;
    options.least_write_rate = std::size_t{1} << 40;
  });
  RawClient client(server.port());
  client.send("GET /big HTTP/1.1\r\nHost: t\r\n\r\n");
  EXPECT_TRUE(comes_true([&] { return server.asked == 1; }));
  EXPECT_TRUE(comes_true([&] { return server.metrics->open_connections() == 0; }));
  EXPECT_LT(client.read_all().size(), kBigBytes);
}

TEST(HttpServer, SendsALargeBodyWhole) {
  Server server;
  const auto answer = server.answer("GET /big HTTP/1.1\r\nHost: t\r\nConnection: close\r\n\r\n");
  EXPECT_EQ(answer.size() - answer.find("\r\n\r\n") - 4, kBigBytes);
}

TEST(HttpServer, PassesOverASmallBody) {
  Server server;
  for (const char* body :
       {"Content-Length: 5\r\n\r\nabcde", "Transfer-Encoding: chunked\r\n\r\n3\r\nabc\r\n2\r\nde\r\n0\r\n\r\n"}) {
    const auto all = server.answer(std::string("GET /a HTTP/1.1\r\nHost: t\r\n") + body + kLastGet);
    EXPECT_NE(all.find("\r\n\r\n/aHTTP/1.1 200 OK"), std::string::npos) << all;
    EXPECT_TRUE(all.ends_with("\r\n\r\n/z"));
  }
}

TEST(HttpServer, ClosesAfterHttp10AndAfterItsLastRequest) {
  Server server([](ServeOptions& options) { options.max_requests = 2; });
  const auto old = server.answer("GET /a HTTP/1.0\r\n\r\n");
  EXPECT_EQ(status_of(old), 200);
  EXPECT_NE(old.find("Connection: close"), std::string::npos);
  const auto all = server.answer(kGet + kGet + kGet);
  EXPECT_EQ(all.find("Connection: close"), all.rfind("Connection: "));
  EXPECT_EQ(server.asked, 3);
}

TEST(HttpServer, RefusesConnectionsOverItsLimitAndRecovers) {
  Server server([](ServeOptions& options) { options.max_connections = 3; });
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < 3; ++i) {
    clients.push_back(std::make_unique<RawClient>(server.port()));
    clients.back()->send(kGet);
    EXPECT_EQ(status_of(clients.back()->read_answer()), 200);
  }
  EXPECT_EQ(status_of(RawClient(server.port()).read_all()), 503);
  clients.clear();
  EXPECT_TRUE(comes_true([&] { return server.metrics->open_connections() == 0; }));
  EXPECT_EQ(status_of(server.answer(kLastGet)), 200);
}

TEST(HttpServer, OutlivesALackOfDescriptors) {
  Server server;
  RawClient client;
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  rlimit low = limit;
  low.rlim_cur = 256;
  setrlimit(RLIMIT_NOFILE, &low);
  std::vector<int> fillers;
  for (int fd; (fd = ::open("/dev/null", O_RDONLY)) >= 0;) fillers.push_back(fd);
  client.connect(server.port());
  client.send(kLastGet);
  EXPECT_EQ(client.read_all(300ms), "");  // nobody can accept
  for (const int fd : fillers) ::close(fd);
  setrlimit(RLIMIT_NOFILE, &limit);
  EXPECT_EQ(status_of(client.read_all()), 200);
}

TEST(HttpServer, EndsRequestsUnderWayBeforeItStops) {
  Server server;
  RawClient busy(server.port()), idle(server.port());
  idle.send(kGet);
  EXPECT_EQ(status_of(idle.read_answer()), 200);
  busy.send("GET /slow HTTP/1.1\r\nHost: t\r\n\r\n");
  EXPECT_TRUE(comes_true([&] { return server.asked == 2; }));
  server.begin_stop();
  const auto answer = busy.read_all();
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_NE(answer.find("Connection: close"), std::string::npos);
  EXPECT_EQ(idle.read_all(), "");
  EXPECT_TRUE(idle.is_closed());
  server.stop();
  EXPECT_FALSE(RawClient().connect(server.port()));
}

TEST(HttpServer, StopsInTimeWhateverItsClientsDo) {
  Server server([](ServeOptions& options) { options.drain_time = 300ms; });
  RawClient slow_reader(server.port()), slow_writer(server.port());
  slow_reader.send("GET /big HTTP/1.1\r\nHost: t\r\n\r\n");
  slow_writer.send("GET / HT");
  EXPECT_TRUE(comes_true([&] { return server.asked == 1 && server.metrics->open_connections() == 2; }));
  const auto began = Clock::now();
  server.stop();
  EXPECT_LT(Clock::now() - began, 5s);
}

TEST(HttpServer, MayBeStoppedBeforeItRuns) {
  ServeOptions options;
  options.port = 0;
  HttpServer server(
      options, [] { return Responder(); }, std::make_shared<Metrics>(), nullptr);
  server.stop();
  server.run();
}

TEST(HttpServer, StopsOnSigterm) {
  Server server([](ServeOptions& options) { options.stops_on_signals = true; });
  EXPECT_EQ(status_of(server.answer(kLastGet)), 200);
  ::kill(::getpid(), SIGTERM);
  EXPECT_TRUE(comes_true([&] { return !RawClient().connect(server.port()); }));
}

TEST(HttpServer, SaysWhatToDoWhereItCannotListen) {
  Server server;
  const auto message = [](const std::string& address, std::uint16_t port) {
    ServeOptions options;
    options.address = address;
    options.port = port;
    try {
      HttpServer second(
          options, [] { return Responder(); }, std::make_shared<Metrics>(), nullptr);
    } catch (const CityError& error) {
      return std::string(error.what());
    }
    return std::string("(listens)");
  };
  EXPECT_NE(message("127.0.0.1", server.port()).find("in use"), std::string::npos);
  EXPECT_NE(message("127.0.0.1", server.port()).find("--port"), std::string::npos);
  EXPECT_NE(message("somewhere", 0).find("IP address"), std::string::npos);
  EXPECT_NE(message("192.0.2.1", 0).find("cannot listen on 192.0.2.1"), std::string::npos);
}

TEST(HttpServer, ServesManyConnectionsAtOnce) {
  Server server;
  std::atomic<int> right = 0;
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 8; ++t)
      threads.emplace_back([&, t] {
        RawClient client(server.port());
        for (int i = 0; i < 200; ++i) {
          const auto target = "/" + std::to_string(t * 1000 + i);
          client.send("GET " + target + " HTTP/1.1\r\nHost: t\r\n\r\n");
          right += client.read_answer().ends_with("\r\n\r\n" + target);
        }
      });
  }
  EXPECT_EQ(right, 1600);
}

}  // namespace
}  // namespace vicus
