#pragma once
#include <filesystem>
#include <memory>

#include "httpd/live_city.hpp"
#include "httpd/made_tiles.hpp"
#include "httpd/message.hpp"
#include "httpd/metrics.hpp"
#include "httpd/parcels.hpp"
#include "httpd/static_files.hpp"
#include "httpd/tour_routes.hpp"

/// The paths of DESIGN §10: request -> response, no sockets. One per thread.
namespace vicus {

class Routes {
 public:
  /// `tiles` makes those of /blockmaps/ that the city's file does not have; null: there are no others.
  /// `parcels`: what all threads keep of them; null: this one keeps its own.
  /// Fails   CityError: the city cannot be opened.
  Routes(const std::filesystem::path& city, std::shared_ptr<const StaticFiles> files, std::shared_ptr<Metrics> metrics,
         std::shared_ptr<MadeTiles> tiles = nullptr, TourDesk desk = {}, std::shared_ptr<Parcels> parcels = nullptr);

  /// Fails   never: whatever goes wrong becomes a problem (500, with `fault` for the log).
  HttpResponse respond(const HttpRequest& request);

 private:
  HttpResponse route(const HttpRequest& request);
  HttpResponse answer_tile(const HttpRequest& request, const std::string& path);

  std::shared_ptr<const StaticFiles> files_;
  std::shared_ptr<Metrics> metrics_;
  std::shared_ptr<MadeTiles> tiles_;
  std::shared_ptr<Parcels> parcels_;
  TourDesk desk_;
  LiveCity city_;
};

}  // namespace vicus
