#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "city_db/store.hpp"

/// The city as it is on disk now: opened immutable, and opened anew when a build has put another file in its place.
/// One per thread.
namespace vicus {

/// Tells one file under a path from another.
struct FileStamp {
  std::uint64_t device = 0, inode = 0, size = 0;
  std::int64_t seconds = 0, nanoseconds = 0;
  bool operator==(const FileStamp&) const = default;
};
/// nullopt: there is none.
std::optional<FileStamp> stamp_of(const std::filesystem::path& path);

class LiveCity {
 public:
  /// `reopened` is called after each change of file.
  /// Fails   CityError: the city cannot be opened.
  LiveCity(std::filesystem::path path, std::function<void()> reopened);

  /// The reader for one request. Looks at the file at most once in kLookInterval; a new file that cannot be opened
  /// (it is being copied, or is damaged) leaves the old city in service.
  const CityReader& reader();
  /// Changes with every newly opened city: a key for what is derived from it and kept.
  std::uint64_t generation() const { return generation_; }

  /// Of the file, the same in every thread that has it open.
  std::uint64_t version() const {
    return (stamp_.inode * 31 + stamp_.size) * 31 +
           static_cast<std::uint64_t>(stamp_.seconds * 1'000'000'007 + stamp_.nanoseconds);
  }

  static constexpr std::chrono::milliseconds kLookInterval{1000};

 private:
  std::filesystem::path path_;
  std::function<void()> reopened_;
  FileStamp stamp_;
  CityReader reader_;
  std::uint64_t generation_ = 0;
  std::chrono::steady_clock::time_point looked_;
};

}  // namespace vicus
