#include "cli/write_whole.hpp"

#include <fstream>

#include "city_db/issues.hpp"

namespace vicus::cli {

void write_whole(const std::filesystem::path& path, const std::string& bytes) {
  const std::filesystem::path part = path.string() + ".part";
  std::ofstream out(part, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, path, error);
  if (out && !error) return;
  std::filesystem::remove(part, error);
  throw CityError("cannot write " + path.string() + ": is the disk full, or the folder not ours to write?");
}

}  // namespace vicus::cli
