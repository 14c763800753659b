#pragma once
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "city_db/store.hpp"
#include "httpd/message.hpp"
#include "httpd/url.hpp"

/// Files of many sectors in one answer, for a page that would ask for each: a street view takes dozens of small ones.
///
///     /parcels?files=r12,r13.far,r14.tall     stems of X3D files, as in /sectors/; a near one brings its parts along
///
/// application/x-ndjson, so that the first file can be used before the last has come:
///
///     {"files":[["r12.x3d",45102],["r12.1.x3d",80233],["r13.far.x3d",9120]],"missing":["r14.tall"]}
///     ["r12.x3d","<?xml ..."]
///     ["r12.1.x3d","<?xml ..."]
///     ...
///
/// with the bytes of each file's text, and the stems that there are no files of. Nothing is stored for it.
///
/// With `&without=` (which may be empty) the images of near files come along, behind the first file that refers to
/// them,
/// ["textures/e7da62bd9adea1c8.png","iVBORw0KGgo..."] in base64; without those whose names begin as one of the list
/// does.
namespace vicus {

inline constexpr const char* kParcels = "/parcels";
inline constexpr std::size_t kMostParcelFiles = 64;

/// Shared by all threads: what was composed and coded is kept, the latest `most_bytes` of it, by what went into it.
class Parcels {
 public:
  explicit Parcels(std::size_t most_bytes = std::size_t{16} << 20) : most_bytes_(most_bytes) {}

  /// 400 for a list that cannot be read, 404 where none of its files exists. The tag is of the members' tags: a city
  /// that is built anew with equal files has equal parcels.
  /// Fails   CityError: a stored file cannot be unpacked.
  HttpResponse answer(const HttpRequest& request, const Url& url, const CityReader& city);

  std::size_t kept_bytes() const;

 private:
  struct Kept {
    std::shared_ptr<const std::string> body;
    std::list<std::string>::iterator used;
  };
  std::shared_ptr<const std::string> find(const std::string& tag);
  void keep(const std::string& tag, std::shared_ptr<const std::string> body);

  mutable std::mutex mutex_;
  std::map<std::string, Kept> kept_;
  std::list<std::string> by_use_;  ///< the latest first
  std::size_t most_bytes_, bytes_ = 0;
};

}  // namespace vicus
