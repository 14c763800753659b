#include "cli/shared_guide.hpp"

#include "city_db/issues.hpp"

namespace vicus::cli {

std::shared_ptr<const Guide> SharedGuide::guide() {
  const std::lock_guard lock(mutex_);  // who asks while it is made waits for it: two would cost twice
  const auto now = std::chrono::steady_clock::now();
  if (guide_ && now - looked_ < LiveCity::kLookInterval) return guide_;
  looked_ = now;
  const auto stamp = stamp_of(path_);
  if (guide_ && (!stamp || *stamp == stamp_)) return guide_;
  try {
    guide_ = std::make_shared<const Guide>(path_);
    if (stamp) stamp_ = *stamp;
  } catch (const CityError&) {
    if (!guide_) throw;  // a file that is still being copied: the old city's ways stay
  }
  return guide_;
}

TourDesk tour_desk(std::shared_ptr<SharedGuide> shared) {
  TourDesk desk;
  desk.tour = [shared](const TourQuery& query) { return shared->guide()->tour(query); };
  desk.search = [shared](const std::string& typed, std::size_t limit) { return shared->guide()->search(typed, limit); };
  desk.proposals = [shared] { return shared->guide()->proposals(); };
  return desk;
}

}  // namespace vicus::cli
