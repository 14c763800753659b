#include "httpd/live_city.hpp"

#include <sys/stat.h>

#include "city_db/issues.hpp"

namespace vicus {

std::optional<FileStamp> stamp_of(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileStamp{status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size), status.st_mtim.tv_sec,
                   status.st_mtim.tv_nsec};
}

// The stamp is taken before the file is opened: a rename between the two is noticed at the next look.
LiveCity::LiveCity(std::filesystem::path path, std::function<void()> reopened)
    : path_(std::move(path)),
      reopened_(std::move(reopened)),
      stamp_(stamp_of(path_).value_or(FileStamp{})),
      reader_(path_),
      looked_(std::chrono::steady_clock::now()) {}

const CityReader& LiveCity::reader() {
  const auto now = std::chrono::steady_clock::now();
  if (now - looked_ < kLookInterval) return reader_;
  looked_ = now;
  const auto stamp = stamp_of(path_);
  if (!stamp || *stamp == stamp_) return reader_;
  try {
    reader_ = CityReader(path_);
    stamp_ = *stamp;
    ++generation_;
    reopened_();
  } catch (const CityError&) {
    // Still being written, or broken: the old city stays; the stamp differs, so the next look tries again.
  }
  return reader_;
}

}  // namespace vicus
