#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "city_db/issues.hpp"
#include "cli/command.hpp"
#include "cli/shared_guide.hpp"
#include "cli/tiles.hpp"
#include "httpd/routes.hpp"
#include "httpd/serve.hpp"
#include "httpd/static_files.hpp"

namespace vicus::cli {
namespace {

struct Arguments {
  std::filesystem::path city, x_ite, impostors;
  ServeOptions options;
};

/// Each connection is a descriptor; the usual soft limit of 1024 is below max_connections.
void raise_descriptor_limit(const ServeOptions& options) {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  const auto wanted = static_cast<rlim_t>(options.max_connections + 256);
  if (limit.rlim_cur >= wanted) return;
  limit.rlim_cur = std::min(wanted, limit.rlim_max);
  setrlimit(RLIMIT_NOFILE, &limit);
}

std::filesystem::path program_path() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

/// A target as one word of a log line: what could start a line or colour a terminal is escaped.
std::string printable(const std::string& text) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 0x20 && byte < 0x7f)
      out += c;
    else
      out += std::string("\\x") + kHex[byte >> 4] + kHex[byte & 15];
  }
  return out.empty() ? "-" : out;
}

void log_access(spdlog::logger& log, const AccessRecord& record) {
  if (!record.fault.empty()) log.error("{} {}: {}", printable(record.method), printable(record.target), record.fault);
  log.info("{} {} {} {} {} B {:.1f} ms", printable(record.client), printable(record.method), printable(record.target),
           record.status, record.bytes, record.seconds * 1e3);
}

std::string url_of(const ServeOptions& options, std::uint16_t port) {
  auto host = options.address;
  if (host == "0.0.0.0") host = "127.0.0.1";
  if (host == "::") host = "::1";
  if (host.find(':') != std::string::npos) host = "[" + host + "]";
  return "http://" + host + ":" + std::to_string(port) + "/";
}

void serve(const Arguments& arguments, Context& context) {
  if (!std::filesystem::exists(arguments.city))
    throw CityError("there is no city " + arguments.city.string() + ": make one with `vicus build MAP -o " +
                    arguments.city.string() + "`");
  const auto log = std::make_shared<spdlog::logger>("vicus", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  log->set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
  log->set_level(context.quiet ? spdlog::level::err : spdlog::level::info);
  log->flush_on(spdlog::level::warn);

  const auto x_ite = find_x_ite(arguments.x_ite, program_path());
  if (x_ite.empty())
    log->warn(
        "X_ITE was not found: the page cannot show the city. Run `npm install x_ite`, then give "
        "--x_ite node_modules/x_ite");
  const auto files = std::make_shared<const StaticFiles>(x_ite, arguments.impostors);
  const auto metrics = std::make_shared<Metrics>();
  const auto tiles =
      std::make_shared<MadeTiles>([path = arguments.city](const std::string& tile) { return make_tile(path, tile); });
  const auto parcels = std::make_shared<Parcels>();
  raise_descriptor_limit(arguments.options);
  const TourDesk desk = tour_desk(std::make_shared<SharedGuide>(arguments.city));
  const auto new_responder = [&]() -> Responder {
    const auto routes = std::make_shared<Routes>(arguments.city, files, metrics, tiles, desk, parcels);
    return [routes](const HttpRequest& request) { return routes->respond(request); };
  };
  HttpServer server(arguments.options, new_responder, metrics,
                    [log](const AccessRecord& record) { log_access(*log, record); });
  const auto url = url_of(arguments.options, server.port());
  print_result(context, "Vicus serves " + arguments.city.string() + " at " + url + "\n",
               {{"url", url}, {"port", server.port()}});
  const std::jthread warming([files] { files->warm(); });
  server.run();
}

}  // namespace

void add_serve(CLI::App& app, Context& context) {
  auto* command = new_command(app, context, "serve", "the city over HTTP: open the printed address and walk",
                              "vicus serve city.gpkg --port 8080");
  const auto arguments = std::make_shared<Arguments>();
  auto& options = arguments->options;
  options.stops_on_signals = true;
  command->add_option("CITY", arguments->city, "a city made by vicus build")->required();
  command->add_option("--bind", options.address, "IP address to listen on; 0.0.0.0: every network")
      ->capture_default_str();
  command->add_option("--port", options.port, "0: any free one, which is printed")->capture_default_str();
  command->add_option("--threads", options.threads, "0: one per core")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  command->add_option("--x_ite", arguments->x_ite, "the folder of X_ITE: node_modules/x_ite");
  command->add_option("--impostors", arguments->impostors,
                      "a folder of pictures GATE.png to show in gates instead of those of the city: photographs");
  command->callback([&context, arguments] { serve(*arguments, context); });
}

}  // namespace vicus::cli
