#pragma once
#include <filesystem>
#include <string>

#include "city_db/store.hpp"

/// Files for tests that write.
namespace vicus::test {

/// A new empty directory that goes away with this.
class ScratchDirectory {
 public:
  ScratchDirectory();
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

std::string read_bytes(const std::filesystem::path& path);
void write_bytes(const std::filesystem::path& path, const std::string& bytes);

/// What write_city pulls: the artefacts one by one.
std::function<std::optional<Artefact>()> one_by_one(std::vector<Artefact> artefacts);

}  // namespace vicus::test
