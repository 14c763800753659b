#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "httpd/message.hpp"
#include "httpd/metrics.hpp"

/// The sockets: HTTP/1.1 over TCP, answers from a function.
namespace vicus {

struct ServeOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8080;           ///< 0: any free one
  unsigned threads = 0;                ///< 0: one per core
  bool stops_on_signals = false;       ///< SIGTERM and SIGINT stop it; a second one ends the program
  std::size_t max_connections = 4096;  ///< more are answered 503
  std::size_t max_body_bytes = 4096;   ///< bodies mean nothing here; a larger one is 413
  unsigned max_requests = 10000;       ///< per connection
  // Deadlines are absolute: a byte now and then does not put them off.
  std::chrono::milliseconds head_time{10'000}, body_time{10'000}, idle_time{20'000}, drain_time{10'000};
  std::chrono::milliseconds write_time{10'000};  ///< and 1 s more for each least_write_rate bytes
  std::size_t least_write_rate = 16 * 1024;
};

/// One line of the access log.
struct AccessRecord {
  std::string client, method, target;
  int status = 0;
  std::uint64_t bytes = 0;  ///< head included
  double seconds = 0;
  std::string fault;
};

using Responder = std::function<HttpResponse(const HttpRequest&)>;

class HttpServer {
 public:
  /// Listens at once. `new_responder` is called once per thread, before this returns; `log` by all threads.
  /// Fails   CityError: the address is none, or not of this machine, or its port is in use or forbidden;
  ///         and what new_responder throws.
  HttpServer(const ServeOptions& options, const std::function<Responder()>& new_responder,
             std::shared_ptr<Metrics> metrics, std::function<void(const AccessRecord&)> log);
  ~HttpServer();

  std::uint16_t port() const;
  /// Serves until stop() or a signal; then no connection is accepted any more, idle ones are closed, and requests
  /// under way have drain_time to end.
  void run();
  /// From any thread, also before run().
  void stop();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vicus
