#include "sectorgen/geo/read_geojson_lines.hpp"

#include <zlib.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "sectorgen/geo/add_feature.hpp"
#include "sectorgen/geo/geojson_feature.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {

namespace {

namespace fs = std::filesystem;

/// Lines of a plain or gzip file.
class LineReader {
 public:
  explicit LineReader(const fs::path& path) : path_(path), file_(gzopen(path.c_str(), "rb")) {
    if (!file_) throw CityError(path.string() + ": cannot be opened: " + std::strerror(errno), 4);
    gzbuffer(file_.get(), kChunk);
    buffer_.resize(kChunk);
  }

  /// False at the end. The view holds until the next call; without the line's end and a record separator before it.
  bool next(std::string_view& line) {
    for (;;) {
      const char* begin = buffer_.data() + at_;
      if (const void* end = std::memchr(begin, '\n', filled_ - at_)) {
        const auto size = static_cast<std::size_t>(static_cast<const char*>(end) - begin);
        at_ += size + 1;
        line = stripped({begin, size});
        return true;
      }
      if (!fill()) break;
    }
    line = stripped({buffer_.data() + at_, filled_ - at_});
    at_ = filled_;
    return !line.empty();
  }

 private:
  static constexpr unsigned kChunk = 1 << 18;
  struct Close {
    void operator()(gzFile file) const { gzclose(file); }
  };

  static std::string_view stripped(std::string_view line) {
    constexpr std::string_view kBefore = "\x1e \t\xef\xbb\xbf", kAfter = " \t\r,";
    while (!line.empty() && kBefore.find(line.front()) != std::string_view::npos) line.remove_prefix(1);
    while (!line.empty() && kAfter.find(line.back()) != std::string_view::npos) line.remove_suffix(1);
    return line;
  }

  /// Moves the unread rest to the front and reads more behind it.
  bool fill() {
    std::memmove(buffer_.data(), buffer_.data() + at_, filled_ - at_);
    filled_ -= at_;
    at_ = 0;
    if (filled_ + kChunk > buffer_.size()) buffer_.resize(buffer_.size() * 2);
    const int got = gzread(file_.get(), buffer_.data() + filled_, kChunk);
    int code = Z_OK;
    const char* message = gzerror(file_.get(), &code);
    if (got < 0 || code == Z_BUF_ERROR || code == Z_DATA_ERROR)
      throw CityError(path_.string() + ": broken or cut off: " + message, 4);
    filled_ += static_cast<std::size_t>(got);
    return got > 0;
  }

  fs::path path_;
  std::unique_ptr<gzFile_s, Close> file_;
  std::vector<char> buffer_;
  std::size_t at_ = 0, filled_ = 0;
};

std::string layer_name(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.substr(0, name.find('.'));
}

}  // namespace

bool is_geojson_lines_file(const fs::path& path) {
  const std::string name = lower_case(path.filename().string());
  for (const char* ending : {".geojsonl", ".geojsons", ".geojsonseq", ".ndjson", ".jsonl", ".ndgeojson"})
    if (name.ends_with(ending) || name.ends_with(std::string(ending) + ".gz")) return true;
  return false;
}

LayerFacts geojson_lines_facts(const fs::path& path) {
  LineReader lines(path);
  constexpr int kLinesToLookAt = 100;
  LayerFacts facts{path, layer_name(path), false, false, {}};
  std::string_view line;
  std::string problem = "it is empty";
  for (int i = 0; i < kLinesToLookAt && lines.next(line); ++i) {
    const auto feature = parse_geojson_feature(line, problem);
    if (!feature || !feature->is_feature) continue;
    for (const JsonGeometry& geometry : feature->geometries) {
      facts.may_have_polygons = facts.may_have_polygons || geometry.type.ends_with("Polygon");
      facts.may_have_lines = facts.may_have_lines || geometry.type.ends_with("LineString");
    }
    if (facts.attributes.empty())
      for (const auto& [name, value] : feature->properties) facts.attributes.push_back(name);
    problem.clear();
  }
  if (facts.attributes.empty() && !problem.empty() && !facts.may_have_lines && !facts.may_have_polygons)
    throw CityError(path.string() + ": expected one GeoJSON feature per line: " + problem, 4);
  return facts;
}

void read_geojson_lines(const LayerChoice& choice, RawMap& map) {
  LineReader lines(choice.layer.file);
  CoordinateSystem degrees;
  degrees.name = "EPSG:4326, as GeoJSON prescribes";
  degrees.is_declared = true;
  FeatureAdder adder(choice, map, degrees);
  std::string_view line;
  for (long long number = 0; lines.next(line);) {
    if (line.empty()) continue;
    std::string problem;
    auto feature = parse_geojson_feature(line, problem);
    const long long fid = number++;
    if (!feature || !feature->is_feature) {
      adder.unreadable(fid, problem.empty() ? "it is no GeoJSON feature" : problem);
      continue;
    }
    if (feature->geometries.empty()) {
      adder.unreadable(fid, "it has no geometry");
      continue;
    }
    adder.begin(fid, std::move(feature->properties));
    for (JsonGeometry& geometry : feature->geometries) {
      if (geometry.type == "GeometryCollection") continue;
      if (geometry.type.ends_with("Polygon")) {
        for (auto& rings : polygons_of(geometry)) adder.polygon(std::move(rings));
      } else if (geometry.type.ends_with("LineString")) {
        std::size_t point = 0;
        for (std::size_t end : geometry.line_ends) {
          adder.line({geometry.points.begin() + static_cast<std::ptrdiff_t>(point),
                      geometry.points.begin() + static_cast<std::ptrdiff_t>(end)});
          point = end;
        }
      } else if (geometry.type.ends_with("Point")) {
        for (LatLon point : geometry.points) adder.point(point);
      } else {
        adder.unreadable(fid, "its geometry's type is unknown: " + geometry.type);
      }
    }
  }
  adder.finish();
  map.licences.push_back(adder.is_from_osm() ? kOsmLicence : unstated_licence(choice.layer.file));
}

}  // namespace vicus
