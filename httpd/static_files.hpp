#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Files known before the first request: our client scripts (in the program), X_ITE and X3DOM (folders). A request can
/// name only what is in this table: nothing is looked up on disk by a URL.
namespace vicus {

/// One file and its codings, each made at first use and then kept. Shared by all threads.
class StaticFile {
 public:
  StaticFile(std::string media_type, std::string_view bytes) : media_type_(std::move(media_type)), bytes_(bytes) {}
  /// Read at first use.
  StaticFile(std::string media_type, std::filesystem::path path)
      : media_type_(std::move(media_type)), path_(std::move(path)) {}

  struct Representation {
    std::string etag;
    std::shared_ptr<const std::string> body;
  };
  const std::string& media_type() const { return media_type_; }
  /// Needs   coding is "br", "gzip" or "identity".
  /// Fails   CityError: the file cannot be read any more.
  Representation in_coding(const std::string& coding) const;

 private:
  std::string media_type_;
  std::string_view bytes_;
  std::filesystem::path path_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, Representation> made_;
  mutable std::string hash_;
};

class StaticFiles {
 public:
  /// `x_ite`: its dist folder, or the package folder above it, or empty: served without X_ITE.
  /// `impostors`: a folder of pictures GATE.png that stand for those of the city (photographs, paper 004 §4.1.7), or
  /// empty. What is in it is looked up once, here.
  /// Fails   CityError: the folder holds no X_ITE; no picture.
  explicit StaticFiles(const std::filesystem::path& x_ite, const std::filesystem::path& impostors = {});

  const StaticFile* client(const std::string& path) const;  ///< path below /client/, e.g. "page/index.html"
  const StaticFile* x_ite(const std::string& path) const;   ///< path below /x_ite/VERSION/, e.g. "dist/x_ite.css"
  /// path below /x3dom/: x3dom.js, x3dom.css; there where the package x3dom lies beside X_ITE's.
  const StaticFile* x3dom(const std::string& path) const;
  const StaticFile* impostor(const std::string& path) const;           ///< path below /impostors/
  const std::string& x_ite_version() const { return x_ite_version_; }  ///< empty: there is no X_ITE
  /// Makes the codings of the large files every visitor needs, so that the first need not wait.
  void warm() const;

 private:
  void add_impostors(const std::filesystem::path& folder);
  std::map<std::string, StaticFile, std::less<>> client_, x_ite_, x3dom_, impostors_;
  std::string x_ite_version_;
};

/// The folder of X_ITE for --x_ite DIR (may be empty): DIR, else beside the program, else where it was at build time.
/// Empty when there is none. Fails  CityError: DIR was given and holds none.
std::filesystem::path find_x_ite(const std::filesystem::path& given, const std::filesystem::path& program);

/// A file of client_scripts in the program; the table is written by embed.cmake.
struct EmbeddedFile {
  std::string_view path, bytes;
};
const std::vector<EmbeddedFile>& embedded_client_files();

}  // namespace vicus
