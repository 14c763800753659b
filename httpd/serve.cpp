#include "httpd/serve.hpp"

// Boost 1.74's awaitable.hpp uses std::exchange without including <utility>.
#include <utility>

#include <array>
#include <atomic>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

#include "city_db/issues.hpp"
#include "httpd/answers.hpp"
#include "httpd/problem.hpp"
#include "httpd/request_head.hpp"
#include "httpd/response_head.hpp"

namespace vicus {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;
using tcp = asio::ip::tcp;
using Clock = std::chrono::steady_clock;
using Parser = http::request_parser<http::string_body>;

constexpr std::size_t kReadBytes = 4096;
constexpr std::chrono::milliseconds kAcceptPause{50};  // after EMFILE and the like: as long as others need to close
constexpr std::chrono::seconds kLingerTime{1};         // a refused client may still be sending: let it read the answer
constexpr std::size_t kLingerBytes = 1 << 20;

struct Shared {
  ServeOptions options;
  std::shared_ptr<Metrics> metrics;
  std::function<void(const AccessRecord&)> log;
  std::atomic<bool> is_stopping = false;  // at once, also for a thread that is busy answering
};

struct Session;

/// One thread: its own listening socket (SO_REUSEPORT), its own connections, its own responder. Nothing is locked.
struct Worker {
  Worker(const Shared& s, Responder r) : shared(s), respond(std::move(r)), acceptor(context) {}
  const Shared& shared;
  Responder respond;
  std::set<Session*> sessions;  // outlives `context`, whose end destroys what is left of them
  asio::io_context context{1};
  tcp::acceptor acceptor;

  void stop();
};

struct Session {
  Session(Worker& w, tcp::socket socket) : worker(w), stream(std::move(socket)) {
    worker.sessions.insert(this);
    worker.shared.metrics->connection_opened();
    error_code ignored;
    stream.socket().set_option(tcp::no_delay(true), ignored);
    const auto peer = stream.socket().remote_endpoint(ignored);
    if (!ignored) client = peer.address().to_string();
  }
  ~Session() {
    worker.sessions.erase(this);
    worker.shared.metrics->connection_closed();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  std::string_view bytes() const { return {static_cast<const char*>(buffer.data().data()), buffer.size()}; }

  Worker& worker;
  beast::tcp_stream stream;
  beast::flat_buffer buffer;
  std::string client;
  unsigned answered = 0;
  bool is_idle = false;      // no byte of a next request has come
  bool must_linger = false;  // refused while it may still be sending
};

void Worker::stop() {
  error_code ignored;
  acceptor.close(ignored);
  for (auto* session : sessions)
    if (session->is_idle) session->stream.cancel();
}

/// Reads until a whole head is in the buffer: its length, or what is wrong with it. False: the connection is over.
asio::awaitable<bool> read_head(Session& session, std::size_t& length, std::optional<HeadFault>& fault) {
  const auto& options = session.worker.shared.options;
  const auto began = Clock::now();
  const auto idle_end = began + (session.answered == 0 ? options.head_time : options.idle_time);
  std::optional<Clock::time_point> head_end;
  for (;;) {
    while (session.bytes().starts_with("\r\n")) session.buffer.consume(2);  // RFC 9112 §2.2
    const auto bytes = session.bytes();
    const auto found = head_length(bytes);
    if (found && *found <= kMaxHeadBytes) co_return length = *found, true;
    if (bytes.size() > kMaxHeadBytes) co_return fault = fault_of_endless(bytes), true;
    if (bytes.empty() && session.worker.shared.is_stopping) co_return false;
    if (!bytes.empty() && !head_end) head_end = Clock::now() + options.head_time;
    session.is_idle = bytes.empty();
    session.stream.expires_at(head_end.value_or(idle_end));
    error_code error;
    const auto got = co_await session.stream.async_read_some(session.buffer.prepare(kReadBytes),
                                                             asio::redirect_error(asio::use_awaitable, error));
    session.is_idle = false;
    if (error) co_return false;
    session.buffer.commit(got);
  }
}

HeadFault fault_of_error(const error_code& error, const ServeOptions& options) {
  if (error == http::error::body_limit)
    return {413, "Bodies mean nothing here, and one over " + std::to_string(options.max_body_bytes) +
                     " bytes is refused. Send none."};
  if (error == http::error::bad_version) return {505, "This server speaks HTTP/1.1 and HTTP/1.0."};
  if (error == beast::error::timeout) return {408, "The body did not come in time."};
  return {400, "The request is not HTTP/1.1: " + error.message() + "."};
}

std::optional<HeadFault> parse_head(Session& session, std::size_t length, Parser& parser, HttpRequest& request) {
  if (auto fault = fault_of_bytes(session.bytes().substr(0, length))) return fault;
  error_code error;
  parser.header_limit(static_cast<std::uint32_t>(kMaxHeadBytes + 1));
  parser.body_limit(session.worker.shared.options.max_body_bytes);
  const auto taken = parser.put(asio::const_buffer(session.buffer.data().data(), length), error);
  const auto& message = parser.get();
  request.method = std::string(message.method_string());
  request.target = std::string(message.target());
  for (const auto& field : message) request.fields.emplace_back(field.name_string(), field.value());
  if (error && error != http::error::need_more) return fault_of_error(error, session.worker.shared.options);
  session.buffer.consume(taken);
  return fault_of_fields(request, message.version() == 10);
}

asio::awaitable<std::optional<HeadFault>> read_body(Session& session, Parser& parser) {
  error_code error;
  session.stream.expires_after(session.worker.shared.options.body_time);
  co_await http::async_read(session.stream, session.buffer, parser, asio::redirect_error(asio::use_awaitable, error));
  if (error) co_return fault_of_error(error, session.worker.shared.options);
  co_return std::nullopt;
}

HttpResponse refusal(const HeadFault& fault) {
  auto response = problem(fault.status, fault.detail);
  response.route = "refused";
  add_common_fields(response);
  return response;
}

/// Head and body; the number of bytes, or 0 when the connection broke or was too slow.
asio::awaitable<std::size_t> write_response(Session& session, const HttpResponse& response, bool is_head,
                                            bool keeps_alive) {
  const auto& options = session.worker.shared.options;
  const auto head = response_head(response, keeps_alive, std::time(nullptr));
  const bool has_body = response.body && !is_head && may_have_body(response.status);
  const std::array<asio::const_buffer, 2> buffers{asio::buffer(head),
                                                  has_body ? asio::buffer(*response.body) : asio::const_buffer()};
  const auto size = buffers[0].size() + buffers[1].size();
  session.stream.expires_after(options.write_time + std::chrono::seconds(size / options.least_write_rate));
  error_code error;
  co_await asio::async_write(session.stream, buffers, asio::redirect_error(asio::use_awaitable, error));
  co_return error ? 0 : size;
}

void record(const Session& session, const HttpRequest& request, const HttpResponse& response, std::size_t bytes,
            Clock::time_point began) {
  const auto& shared = session.worker.shared;
  const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
  shared.metrics->count_answer(response.route, response.status, bytes, seconds);
  if (shared.log)
    shared.log({session.client, request.method, request.target, response.status, bytes, seconds, response.fault});
}

/// One request and its answer. False: the connection ends here.
asio::awaitable<bool> serve_request(Session& session) {
  auto& worker = session.worker;
  std::size_t length = 0;
  std::optional<HeadFault> fault;
  if (!co_await read_head(session, length, fault)) co_return false;
  const auto began = Clock::now();
  HttpRequest request{"", "", {}};
  Parser parser;
  if (!fault) fault = parse_head(session, length, parser, request);
  if (!fault && !parser.is_done()) fault = co_await read_body(session, parser);
  const HttpResponse response = fault ? refusal(*fault) : worker.respond(request);
  session.must_linger = fault.has_value();
  const bool keeps_alive = !fault && parser.keep_alive() && !worker.shared.is_stopping &&
                           ++session.answered < worker.shared.options.max_requests;
  const auto bytes = co_await write_response(session, response, request.method == "HEAD", keeps_alive);
  record(session, request, response, bytes, began);
  co_return keeps_alive&& bytes > 0;
}

/// Closing with bytes unread resets the connection, and the client may lose the answer that says why.
asio::awaitable<void> linger(Session& session) {
  error_code error;
  session.stream.socket().shutdown(tcp::socket::shutdown_send, error);
  session.stream.expires_after(kLingerTime);
  std::array<char, kReadBytes> discarded;
  for (std::size_t total = 0; !error && total < kLingerBytes;)
    total += co_await session.stream.async_read_some(asio::buffer(discarded),
                                                     asio::redirect_error(asio::use_awaitable, error));
}

asio::awaitable<void> serve_connection(Worker& worker, tcp::socket socket) {
  Session session(worker, std::move(socket));
  while (co_await serve_request(session)) {
  }
  if (session.must_linger) co_await linger(session);
}

void refuse_connection(Worker& worker, tcp::socket& socket) {
  worker.shared.metrics->connection_refused();
  auto response = refusal({503, "Too many connections are open. Try again in a moment."});
  response.fields.emplace_back("Retry-After", "2");
  const auto text = response_head(response, false, std::time(nullptr)) + *response.body;
  error_code ignored;
  socket.non_blocking(true, ignored);
  socket.write_some(asio::buffer(text), ignored);
}

asio::awaitable<void> accept_connections(Worker& worker) {
  const auto& shared = worker.shared;
  asio::steady_timer pause(worker.context);
  for (;;) {
    error_code error;
    auto socket = co_await worker.acceptor.async_accept(asio::redirect_error(asio::use_awaitable, error));
    if (shared.is_stopping) co_return;
    if (error) {  // out of descriptors or memory, or the client is gone already: not a reason to end
      pause.expires_after(kAcceptPause);
      co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, error));
    } else if (shared.metrics->open_connections() >= static_cast<std::int64_t>(shared.options.max_connections)) {
      refuse_connection(worker, socket);
    } else {
      asio::co_spawn(worker.context, serve_connection(worker, std::move(socket)), [&](std::exception_ptr failed) {
        if (!failed || !shared.log) return;
        try {
          std::rethrow_exception(failed);
        } catch (const std::exception& e) {
          shared.log({"", "", "", 500, 0, 0, std::string("a connection was dropped: ") + e.what()});
        }
      });
    }
  }
}

tcp::endpoint endpoint_of(const ServeOptions& options) {
  error_code error;
  const auto address = asio::ip::make_address(options.address == "localhost" ? "127.0.0.1" : options.address, error);
  if (error)
    throw CityError("cannot listen on '" + options.address +
                    "': give an IP address, such as 127.0.0.1 (this machine only) or 0.0.0.0 (every network)");
  return {address, options.port};
}

void listen(tcp::acceptor& acceptor, const tcp::endpoint& endpoint, bool shares_port) {
  const int on = 1;
  error_code error;
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error && shares_port) ::setsockopt(acceptor.native_handle(), SOL_SOCKET, SO_REUSEPORT, &on, sizeof on);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
  if (!error) return;
  const auto where = endpoint.address().to_string() + " port " + std::to_string(endpoint.port());
  if (error == asio::error::address_in_use)
    throw CityError("cannot listen on " + where +
                    ": it is in use. Stop the other program, or choose another with "
                    "--port N (0: any free one)");
  if (error == asio::error::access_denied)
    throw CityError("cannot listen on " + where + ": ports below 1024 need privileges. Choose another with --port N");
  throw CityError("cannot listen on " + where + ": " + error.message());
}

}  // namespace

struct HttpServer::Impl {
  Impl(const ServeOptions& options, std::shared_ptr<Metrics> metrics, std::function<void(const AccessRecord&)> log)
      : shared{options, std::move(metrics), std::move(log)} {}

  Shared shared;
  std::vector<std::unique_ptr<Worker>> workers;
  std::optional<asio::signal_set> signals;
  std::uint16_t port = 0;
  std::mutex mutex;
  std::condition_variable changed;
  std::size_t running = 0;

  void stop() {
    const std::lock_guard lock(mutex);
    if (shared.is_stopping.exchange(true)) return;
    for (auto& worker : workers) asio::post(worker->context, [w = worker.get()] { w->stop(); });
    if (signals) asio::post(workers.front()->context, [this] { signals.reset(); });  // the next signal ends the program
    changed.notify_all();
  }

  void run_worker(Worker& worker) {
    worker.context.run();
    const std::lock_guard lock(mutex);
    --running;
    changed.notify_all();
  }
};

HttpServer::HttpServer(const ServeOptions& options, const std::function<Responder()>& new_responder,
                       std::shared_ptr<Metrics> metrics, std::function<void(const AccessRecord&)> log)
    : impl_(std::make_unique<Impl>(options, std::move(metrics), std::move(log))) {
  auto endpoint = endpoint_of(options);
  if (endpoint.port() != 0) {  // SO_REUSEPORT would silently share the port with another server of ours
    asio::io_context context;
    tcp::acceptor probe(context);
    listen(probe, endpoint, false);
  }
  const unsigned threads = options.threads ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  for (unsigned i = 0; i < threads; ++i) {
    auto& worker = *impl_->workers.emplace_back(std::make_unique<Worker>(impl_->shared, new_responder()));
    listen(worker.acceptor, endpoint, true);
    endpoint.port(worker.acceptor.local_endpoint().port());
    asio::co_spawn(worker.context, accept_connections(worker), [](std::exception_ptr failed) {
      if (failed) std::rethrow_exception(failed);  // ends run(): a listener that is gone must not go unnoticed
    });
  }
  impl_->port = endpoint.port();
  if (!options.stops_on_signals) return;
  impl_->signals.emplace(impl_->workers.front()->context, SIGTERM, SIGINT);
  impl_->signals->async_wait([impl = impl_.get()](const error_code& error, int) {
    if (!error) impl->stop();
  });
}

HttpServer::~HttpServer() { impl_->signals.reset(); }

std::uint16_t HttpServer::port() const { return impl_->port; }

void HttpServer::run() {
  auto& impl = *impl_;
  impl.running = impl.workers.size();
  std::vector<std::jthread> threads;
  for (auto& worker : impl.workers) threads.emplace_back([&impl, w = worker.get()] { impl.run_worker(*w); });
  std::unique_lock lock(impl.mutex);
  impl.changed.wait(lock, [&] { return impl.shared.is_stopping.load(); });
  impl.changed.wait_for(lock, impl.shared.options.drain_time, [&] { return impl.running == 0; });
  lock.unlock();
  for (auto& worker : impl.workers) worker->context.stop();
}

void HttpServer::stop() { impl_->stop(); }

}  // namespace vicus
