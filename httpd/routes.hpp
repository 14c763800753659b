#pragma once
#include <filesystem>
#include <memory>

#include "httpd/live_city.hpp"
#include "httpd/message.hpp"
#include "httpd/metrics.hpp"
#include "httpd/static_files.hpp"
#include "httpd/tour_routes.hpp"

/// The paths of DESIGN §10: request -> response, no sockets. One per thread.
namespace vicus {

class Routes {
 public:
  /// Fails   CityError: the city cannot be opened.
  Routes(const std::filesystem::path& city, std::shared_ptr<const StaticFiles> files, std::shared_ptr<Metrics> metrics,
         TourDesk desk = {});

  /// Fails   never: whatever goes wrong becomes a problem (500, with `fault` for the log).
  HttpResponse respond(const HttpRequest& request);

 private:
  HttpResponse route(const HttpRequest& request);

  std::shared_ptr<const StaticFiles> files_;
  std::shared_ptr<Metrics> metrics_;
  TourDesk desk_;
  LiveCity city_;
};

}  // namespace vicus
