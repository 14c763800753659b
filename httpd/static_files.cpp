#include "httpd/static_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "city_db/issues.hpp"
#include "httpd/etag.hpp"
#include "httpd/media_types.hpp"
#include "x3d_export/coding.hpp"

namespace vicus {
namespace {

namespace fs = std::filesystem;

// Made once and kept: 0.1 s for X_ITE's 1.4 MB; br 11 would save 8 % of it and take 3 s. The page's program: 0.04 or
// 0.15 s.
constexpr int kBrotliQuality = 9, kBrotliQualityOfSmall = 11, kGzipLevel = 9;
constexpr std::size_t kSmall_bytes = 256 << 10;

std::string read_bytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in) throw CityError("cannot read " + path.string() + ": is it still there?");
  return bytes;
}

/// The package folder (it holds package.json and dist/), or empty.
fs::path package_of(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& candidate : {folder, folder.parent_path(), folder / "x_ite"})
    if (fs::is_regular_file(candidate / "package.json", ignored) &&
        fs::is_regular_file(candidate / "dist" / "x_ite.min.mjs", ignored))
      return candidate;
  return {};
}

std::string version_of(const fs::path& package) {
  const auto json = nlohmann::json::parse(read_bytes(package / "package.json"), nullptr, false);
  const auto version = json.is_object() ? json.value("version", std::string()) : std::string();
  const auto is_plain = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '.' || c == '-'; };
  if (version.empty() || !std::all_of(version.begin(), version.end(), is_plain))
    throw CityError((package / "package.json").string() + " gives no version: is this X_ITE? Try `npm install x_ite`");
  return version;
}

}  // namespace

StaticFile::Representation StaticFile::in_coding(const std::string& coding) const {
  const std::lock_guard lock(mutex_);
  if (const auto found = made_.find(coding); found != made_.end()) return found->second;
  auto plain = made_.find("identity");
  if (plain == made_.end()) {
    auto bytes = path_.empty() ? std::string(bytes_) : read_bytes(path_);
    hash_ = strong_hash(bytes);
    plain = made_.emplace("identity", Representation{etag_of(hash_, "identity"), nullptr}).first;
    plain->second.body = std::make_shared<const std::string>(std::move(bytes));
  }
  if (coding == "identity") return plain->second;
  const auto& body = *plain->second.body;
  const int quality = body.size() <= kSmall_bytes ? kBrotliQualityOfSmall : kBrotliQuality;
  auto coded = std::make_shared<const std::string>(coding == "br" ? brotli(body, quality) : gzip(body, kGzipLevel));
  return made_.emplace(coding, Representation{etag_of(hash_, coding), std::move(coded)}).first->second;
}

StaticFiles::StaticFiles(const fs::path& x_ite, const fs::path& impostors) {
  if (!impostors.empty()) add_impostors(impostors);
  for (const auto& file : embedded_client_files())
    client_.try_emplace(std::string(file.path), std::string(media_type_of_file(file.path)), file.bytes);
  if (x_ite.empty()) return;
  const auto package = package_of(x_ite);
  if (package.empty()) throw CityError("no X_ITE in " + x_ite.string() + ": expected dist/x_ite.min.mjs there");
  x_ite_version_ = version_of(package);
  for (const auto& entry : fs::recursive_directory_iterator(package / "dist")) {
    if (!entry.is_regular_file()) continue;
    const auto path = entry.path().lexically_relative(package).generic_string();
    const auto media_type = media_type_of_file(path);
    if (!media_type.empty()) x_ite_.try_emplace(path, std::string(media_type), entry.path());
  }
  for (const char* name : {"x3dom.js", "x3dom.css"})
    if (const auto path = package.parent_path() / "x3dom" / name; fs::is_regular_file(path))
      x3dom_.try_emplace(name, std::string(media_type_of_file(name)), path);
}

void StaticFiles::add_impostors(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error) && entry.path().extension() == ".png")
      impostors_.try_emplace(entry.path().filename().string(), "image/png", entry.path());
  if (error || impostors_.empty())
    throw CityError("no pictures in " + folder.string() +
                    ": expected files GATE.png there, named after the gates' ids");
}

const StaticFile* StaticFiles::impostor(const std::string& path) const {
  const auto found = impostors_.find(path);
  return found == impostors_.end() ? nullptr : &found->second;
}

const StaticFile* StaticFiles::client(const std::string& path) const {
  const auto found = client_.find(path);
  return found == client_.end() ? nullptr : &found->second;
}

const StaticFile* StaticFiles::x_ite(const std::string& path) const {
  const auto found = x_ite_.find(path);
  return found == x_ite_.end() ? nullptr : &found->second;
}

const StaticFile* StaticFiles::x3dom(const std::string& path) const {
  const auto found = x3dom_.find(path);
  return found == x3dom_.end() ? nullptr : &found->second;
}

void StaticFiles::warm() const {
  for (const auto* coding : {"br", "gzip"})
    for (const auto* file : {x_ite("dist/x_ite.min.mjs"), client("bundle/main.js"), client("bundle/page.css")})
      if (file) file->in_coding(coding);
}

fs::path find_x_ite(const fs::path& given, const fs::path& program) {
  if (!given.empty()) {
    const auto package = package_of(given);
    if (package.empty())
      throw CityError("no X_ITE in " + given.string() +
                      ": expected the folder node_modules/x_ite (made by `npm install x_ite`)");
    return package;
  }
  const auto beside = program.parent_path();
  for (const auto& folder : {beside / "node_modules" / "x_ite", beside / ".." / "share" / "vicus" / "x_ite",
                             fs::path("node_modules") / "x_ite", fs::path(VICUS_X_ITE)})
    if (const auto package = package_of(folder); !package.empty()) return package;
  return {};
}

}  // namespace vicus
