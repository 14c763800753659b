#include "httpd/routes.hpp"

#include <algorithm>

#include "city_db/issues.hpp"
#include "httpd/answers.hpp"
#include "httpd/collections.hpp"
#include "httpd/negotiate.hpp"
#include "httpd/problem.hpp"
#include "httpd/sector_routes.hpp"
#include "httpd/url.hpp"
#include "x3d_export/flyover_scene.hpp"

namespace vicus {
namespace {

constexpr const char* kMethods = "GET, HEAD, OPTIONS";

HttpResponse answer_options() {
  HttpResponse response;
  response.status = 204;
  response.route = "options";
  response.fields = {{"Allow", kMethods},
                     {"Access-Control-Allow-Methods", kMethods},
                     {"Access-Control-Allow-Headers", "Accept, Accept-Encoding, If-None-Match"},
                     {"Access-Control-Max-Age", "86400"}};
  return response;
}

HttpResponse method_not_allowed(const std::string& method) {
  auto response = problem(405, "This server only gives: use GET, HEAD or OPTIONS, not " + method + ".");
  response.fields.emplace_back("Allow", kMethods);
  return response;
}

/// A plain answer for machines that is never kept.
HttpResponse fresh(const char* route, const std::string& media_type, std::string text) {
  HttpResponse response;
  response.route = route;
  response.fields = {{"Content-Type", media_type}, {"Cache-Control", "no-store"}};
  response.body = body_of(std::move(text));
  return response;
}

HttpResponse with_route(const char* route, HttpResponse response) {
  response.route = route;
  return response;
}

HttpResponse answer_client(const HttpRequest& request, const StaticFiles& files, const std::string& path) {
  if (const auto* file = files.client(path)) return answer_file(request, *file, Caching::revalidate);
  return problem(404, "There is no client script " + path + ". The page is at /.");
}

HttpResponse with_policy(HttpResponse response) {
  response.fields.emplace_back("Content-Security-Policy", kContentSecurityPolicy);
  return response;
}

HttpResponse answer_page(const HttpRequest& request, const StaticFiles& files) {
  const auto wanted = preferred_media_type(field_of(request.fields, "Accept"), {"text/html", "application/json"});
  const auto* page = files.client("page/index.html");
  if (wanted == "application/json" || !page) return answer_landing(request);
  return with_policy(answer_file(request, *page, Caching::revalidate));
}

/// The page in X3DOM, and X3DOM itself.
HttpResponse answer_x3dom(const HttpRequest& request, const StaticFiles& files, const std::string& path) {
  const auto* page = files.client("page/x3dom.html");
  if (path == "/x3dom.html" && page) return with_policy(answer_file(request, *page, Caching::revalidate));
  if (path.starts_with("/x3dom/"))
    if (const auto* file = files.x3dom(path.substr(7))) return answer_file(request, *file, Caching::revalidate);
  return problem(404,
                 "There is no " + path + ". X3DOM is served where it is installed beside X_ITE: npm install x3dom.");
}

/// /x_ite/VERSION/dist/...: immutable. Any other /x_ite/...: sent on to the version there is.
HttpResponse answer_x_ite(const HttpRequest& request, const StaticFiles& files, const std::string& path) {
  const auto& version = files.x_ite_version();
  if (version.empty())
    return problem(404, "This server runs without X_ITE. Start it with --x_ite DIR, where DIR is node_modules/x_ite.");
  if (path.starts_with(version + "/")) {
    if (const auto* file = files.x_ite(path.substr(version.size() + 1)))
      return answer_file(request, *file, Caching::immutable);
  } else {
    const auto begin = !path.empty() && path[0] >= '0' && path[0] <= '9' ? path.find('/') + 1 : 0;
    const auto rest = path.substr(std::min(begin, path.size()));
    if (files.x_ite(rest)) {
      HttpResponse response;
      response.status = 307;
      response.fields = {{"Location", "/x_ite/" + version + "/" + rest}, {"Cache-Control", "no-cache"}};
      return response;
    }
  }
  return problem(404,
                 "X_ITE " + version + " has no file " + path + ". Its files are below /x_ite/" + version + "/dist/.");
}

}  // namespace

Routes::Routes(const std::filesystem::path& city, std::shared_ptr<const StaticFiles> files,
               std::shared_ptr<Metrics> metrics, std::shared_ptr<MadeTiles> tiles, TourDesk desk,
               std::shared_ptr<Parcels> parcels)
    : files_(std::move(files)),
      metrics_(std::move(metrics)),
      tiles_(std::move(tiles)),
      parcels_(parcels ? std::move(parcels) : std::make_shared<Parcels>()),
      desk_(std::move(desk)),
      city_(city, [this] { metrics_->city_reopened(); }) {}

HttpResponse Routes::respond(const HttpRequest& request) {
  HttpResponse response;
  try {
    response = route(request);
  } catch (const std::exception& error) {  // CityError, and what should never happen: the server goes on
    response = problem(500, "The city's file could not be read. The server's log says why; please tell its operator.");
    response.fault = error.what();
  }
  add_common_fields(response);
  return response;
}

/// As stored; else as made now.
HttpResponse Routes::answer_tile(const HttpRequest& request, const std::string& path) {
  if (auto artefact = answer_artefact(request, city_.reader(), path)) return *std::move(artefact);
  const auto tile = tiles_ ? tiles_->get(path, city_.version()) : nullptr;
  if (!tile)
    return problem(404, "There is no tile /" + path +
                            ". /blockmaps/tree.json lists those there are, where the city was built with them.");
  return answer_made(request, tile->media_type, tile->bytes);
}

HttpResponse Routes::route(const HttpRequest& request) {
  if (request.method == "OPTIONS") return answer_options();
  if (request.method != "GET" && request.method != "HEAD") return method_not_allowed(request.method);
  if (request.target.size() > kMaxTargetBytes)
    return problem(414, "The address is longer than " + std::to_string(kMaxTargetBytes) + " bytes. Shorten it.");
  std::string reason;
  const auto url = parse_url(request.target, reason);
  if (!url) return problem(400, "The address cannot be read: " + reason + ".");
  const auto& path = url->path;
  if (path == "/") return with_route("page", answer_page(request, *files_));
  if (path.starts_with("/client/")) return with_route("client", answer_client(request, *files_, path.substr(8)));
  if (path.starts_with("/x_ite/")) return with_route("x_ite", answer_x_ite(request, *files_, path.substr(7)));
  if (path.starts_with("/x3dom")) return with_route("x3dom", answer_x3dom(request, *files_, path));
  if (path == "/healthz") {
    city_.reader().meta("origin_lat");  // throws when the city cannot be read
    return fresh("healthz", "text/plain; charset=utf-8", "ok\n");
  }
  if (path == "/api") return with_route("collections", answer_api(request));
  if (path == "/metrics") return fresh("metrics", "text/plain; version=0.0.4; charset=utf-8", metrics_->text());
  const auto& city = city_.reader();
  if (path == "/city" || path.starts_with("/city.")) return with_route("city", answer_root(request, *url, city));
  if (path.starts_with("/sectors/")) return with_route("sector", answer_sector(request, city, path.substr(9)));
  if (path == kParcels) return with_route("parcel", parcels_->answer(request, *url, city));
  if (path.starts_with("/blockmaps/")) return with_route("blockmap", answer_tile(request, path.substr(1)));
  if (path == std::string("/") + kFlyoverName) return with_route("city", answer_flyover(request, city));
  if (path == "/tours" || path == "/tours.x3d") return with_route("tours", answer_tours(request, *url, city, desk_));
  if (path == "/search") return with_route("search", answer_search(request, *url, desk_));
  if (path == "/conformance" || path == "/collections" || path.starts_with("/collections/"))
    return with_route("collections", answer_collections(request, *url, city));
  if (path.starts_with("/impostors/"))
    if (const auto* picture = files_->impostor(path.substr(11)))
      return with_route("artefact", answer_file(request, *picture, Caching::revalidate));
  if (auto artefact = answer_artefact(request, city, path.substr(1)))
    return with_route("artefact", *std::move(artefact));
  return problem(404, "There is nothing at " + path + ". The page is at /, the records are at /collections.");
}

}  // namespace vicus
