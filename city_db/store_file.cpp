#include "city_db/store_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <set>
#include <string>

#include "city_db/issues.hpp"

namespace vicus {
namespace fs = std::filesystem;
namespace {

fs::path directory_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// The temporary file's name is this, the writer's process id, and kTemporarySuffix.
std::string temporary_prefix(const fs::path& path) {
  std::string prefix = ".";
  prefix += path.filename().string();
  return prefix += '.';
}
constexpr std::string_view kTemporarySuffix = ".tmp";

fs::path temporary_path(const fs::path& path, pid_t pid) {
  return directory_of(path) / (temporary_prefix(path) + std::to_string(pid) + std::string(kTemporarySuffix));
}

/// The writer of the temporary file `name`, 0 if it is no temporary file of `path`.
pid_t writer_of(const std::string& name, const fs::path& path) {
  const std::string prefix = temporary_prefix(path);
  if (name.size() <= prefix.size() + kTemporarySuffix.size() || !name.starts_with(prefix) ||
      !name.ends_with(kTemporarySuffix))
    return 0;
  const auto digits = name.substr(prefix.size(), name.size() - prefix.size() - kTemporarySuffix.size());
  constexpr std::size_t kMostDigits = 9;
  if (digits.size() > kMostDigits || digits.find_first_not_of("0123456789") != digits.npos) return 0;
  return static_cast<pid_t>(std::stol(digits));
}

/// Removes what killed builds of the same city left behind.
void remove_stale(const fs::path& path) {
  std::error_code error;
  std::set<fs::path> stale;
  for (fs::directory_iterator it(directory_of(path), error), end; !error && it != end; it.increment(error)) {
    const pid_t writer = writer_of(it->path().filename().string(), path);
    // Our own id: a process that died had it before us.
    const bool is_dead = writer != 0 && (writer == ::getpid() || (::kill(writer, 0) != 0 && errno == ESRCH));
    if (is_dead) stale.insert(it->path());
  }
  for (const auto& file : stale) fs::remove(file, error);
}

}  // namespace

void check_target(const fs::path& path) {
  std::error_code error;
  const fs::path directory = directory_of(path);
  if (!path.has_filename() || fs::is_directory(path, error))
    throw CityError("cannot write " + path.string() + ": it is a directory; name a file in it, e.g. " +
                    (path / "city.gpkg").string());
  if (!fs::exists(directory, error))
    throw CityError("cannot write " + path.string() + ": no directory " + directory.string() + "; create it first");
  if (!fs::is_directory(directory, error))
    throw CityError("cannot write " + path.string() + ": " + directory.string() + " is no directory");
  if (::access(directory.c_str(), W_OK | X_OK) != 0)
    throw CityError("cannot write " + path.string() + ": directory " + directory.string() + ": " +
                    std::strerror(errno) + "; choose a directory you may write to");
}

TemporaryFile::TemporaryFile(const fs::path& target) : target_(target), path_(temporary_path(target, ::getpid())) {
  remove_stale(target);
}

TemporaryFile::~TemporaryFile() {
  std::error_code error;
  if (!path_.empty()) fs::remove(path_, error);
}

void TemporaryFile::move_into_place() {
  sync(path_, O_RDONLY);
  if (::rename(path_.c_str(), target_.c_str()) != 0) fail("rename " + path_.string());
  path_.clear();
  sync(directory_of(target_), O_RDONLY | O_DIRECTORY);
}

void TemporaryFile::fail(const std::string& what) const {
  throw CityError("cannot write " + target_.string() + ": " + what + ": " + std::strerror(errno));
}

void TemporaryFile::sync(const fs::path& path, int flags) const {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC);
  if (file < 0) fail("open " + path.string());
  const int rc = ::fsync(file);
  const int error = errno;
  ::close(file);
  errno = error;
  // EINVAL: a file system that cannot sync directories.
  if (rc != 0 && errno != EINVAL) fail("fsync " + path.string());
}

}  // namespace vicus
