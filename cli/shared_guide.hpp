#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>

#include "httpd/live_city.hpp"
#include "httpd/tour_routes.hpp"
#include "sectorgen/sectors/tours/guide.hpp"

/// One Guide for all threads of a server: made when the first visitor asks, and anew when another city lies under the
/// path.
namespace vicus::cli {

class SharedGuide {
 public:
  explicit SharedGuide(std::filesystem::path city) : path_(std::move(city)) {}

  /// Fails   CityError as Guide, where there is no earlier one to go on with.
  std::shared_ptr<const Guide> guide();

 private:
  std::filesystem::path path_;
  std::mutex mutex_;
  std::shared_ptr<const Guide> guide_;
  FileStamp stamp_;
  std::chrono::steady_clock::time_point looked_;
};

/// What a server asks, answered by the guide.
TourDesk tour_desk(std::shared_ptr<SharedGuide> shared);

}  // namespace vicus::cli
