#pragma once
#include <filesystem>

/// A file that appears whole or not at all. Internal to store*.cpp.
namespace vicus {

/// Throws what is known to fail before the work is done: the target is a directory, its directory is missing or may
/// not be written to.
/// Fails   CityError: naming the path and what to do.
void check_target(const std::filesystem::path& target);

/// `.NAME.PID.tmp` beside the target; goes away unless it was moved into place. What killed processes left of the same
/// target is removed first.
/// Needs   one thread at a time per target in a process.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Renamed only when its bytes are on the disk, and back only when the directory is, too.
  /// Fails   CityError.
  void move_into_place();

 private:
  [[noreturn]] void fail(const std::string& what) const;
  void sync(const std::filesystem::path& path, int flags) const;

  std::filesystem::path target_, path_;
};

}  // namespace vicus
