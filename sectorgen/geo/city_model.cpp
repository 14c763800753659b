#include "sectorgen/geo/city_model.hpp"

#include <ogrsf_frmts.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <set>

#include "sectorgen/geo/gdal_degrees.hpp"
#include "sectorgen/geo/model_parts.hpp"
#include "sectorgen/geo/model_tags.hpp"
#include "sectorgen/geo/quiet_gdal.hpp"

namespace vicus {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{2} << 30;
constexpr double kLeastUpward = 0.05;   // of a unit normal: steeper ones are walls
constexpr double kLeastWidth_m = 0.02;  // narrower slopes are gaps that rounding left between others
constexpr double kFloor_m = 0.5;        // surfaces that look down, so near to the lowest corner, are on the ground

using GzFile = std::unique_ptr<gzFile_s, int (*)(gzFile)>;

/// A strip's area over half its outline is its width: in plan, metres.
double plan_width(const ModelSurface& surface) {
  const auto& ring = surface.rings[0];
  double area2 = 0, outline = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ModelCorner &p = ring[i], &q = ring[(i + 1) % ring.size()];
    area2 += (p.x - ring[0].x) * (q.y - ring[0].y) - (q.x - ring[0].x) * (p.y - ring[0].y);
    outline += std::hypot(q.x - p.x, q.y - p.y);
  }
  return outline > 0 ? std::abs(area2) / outline : 0;
}

std::unique_ptr<OGRPolygon> plan_polygon(const ModelSurface& surface) {
  auto polygon = std::make_unique<OGRPolygon>();
  for (const auto& ring : surface.rings) {
    OGRLinearRing line;
    for (const ModelCorner& p : ring) line.addPoint(p.x, p.y);
    line.closeRings();
    polygon->addRing(&line);
  }
  return polygon;
}

/// The union in plan; surfaces that are no valid polygons are made valid first.
std::unique_ptr<OGRGeometry> united(const std::vector<const ModelSurface*>& surfaces) {
  OGRMultiPolygon all;
  const auto add = [&](const OGRGeometry& geometry) {
    if (wkbFlatten(geometry.getGeometryType()) == wkbPolygon)
      all.addGeometry(&geometry);
    else if (OGR_GT_IsSubClassOf(wkbFlatten(geometry.getGeometryType()), wkbGeometryCollection))
      for (const OGRGeometry* part : *geometry.toGeometryCollection())
        if (wkbFlatten(part->getGeometryType()) == wkbPolygon) all.addGeometry(part);
  };
  for (const ModelSurface* surface : surfaces) {
    auto polygon = plan_polygon(*surface);
    if (polygon->IsValid()) {
      add(*polygon);
    } else if (const std::unique_ptr<OGRGeometry> valid(polygon->MakeValid()); valid) {
      add(*valid);
    }
  }
  return std::unique_ptr<OGRGeometry>(all.UnionCascaded());
}

/// Metres per degree, or 1 where the coordinates are metres.
struct Stretch {
  double x = 1, y = 1;
};

/// Needs   latitudes first, as geographic systems have them.
Stretch stretch_at(const CityModel& model) {
  constexpr double kMetresPerDegree = 111'195;
  for (const auto& object : model.objects)
    for (const auto& surface : object.surfaces)
      for (const auto& ring : surface.rings)
        if (!ring.empty() && std::abs(ring[0].x) < 89)
          return {kMetresPerDegree * std::cos(ring[0].x * std::acos(-1.0) / 180), kMetresPerDegree};
  return {};
}

/// One house's surfaces by use.
struct Sorted {
  std::vector<const ModelSurface*> ground, up;
  double foot = HUGE_VAL, top = -HUGE_VAL;
};

Sorted sorted(const ModelObject& object) {
  Sorted out;
  for (const auto& surface : object.surfaces)
    for (const auto& ring : surface.rings)
      for (const ModelCorner& p : ring) {
        out.foot = std::min(out.foot, p.z);
        out.top = std::max(out.top, p.z);
      }
  std::vector<const ModelSurface*> down;
  for (const auto& surface : object.surfaces) {
    const double up = unit_normal(surface).z;
    // Semantics first: ground surfaces are often turned over.
    if (surface.part == ModelPart::ground)
      out.ground.push_back(&surface);
    else if (up > kLeastUpward || (surface.part == ModelPart::roof && up < -kLeastUpward)) {
      if (plan_width(surface) > kLeastWidth_m) out.up.push_back(&surface);
    } else if (up < -kLeastUpward)
      down.push_back(&surface);
  }
  if (out.ground.empty())
    for (const ModelSurface* surface : down)
      if (std::all_of(surface->rings[0].begin(), surface->rings[0].end(),
                      [&](const ModelCorner& p) { return p.z <= out.foot + kFloor_m; }))
        out.ground.push_back(surface);
  return out;
}

/// Collects positions of many houses, so that PROJ gets one array.
class ModelAdder {
 public:
  ModelAdder(DegreesOf& degrees, std::string file, RawMap& map)
      : degrees_(degrees), file_(std::move(file)), map_(map) {}

  void add(ModelObject& object) {
    const Sorted parts = sorted(object);
    const auto outline = united(parts.ground.empty() ? parts.up : parts.ground);
    if (!outline || outline->IsEmpty() || parts.up.empty()) {
      unusable(object, outline && !outline->IsEmpty() ? "none of its surfaces looks up" : "it covers no ground");
      return;
    }
    const std::string source_id = file_ + "#" + object.id;
    Tags tags = model_tags(object.attributes, parts.top - parts.foot);
    add_colours(object, tags);
    const auto add_polygon = [&](const OGRPolygon& polygon) {
      RawFeature& feature = features_.emplace_back();
      feature.theme = Theme::building;
      feature.source_id = source_id;
      feature.tags = tags;
      for (const OGRLinearRing* ring : polygon) {
        auto& line = feature.lines.emplace_back();
        for (int i = 0; i < ring->getNumPoints(); ++i) line.push_back({ring->getY(i), ring->getX(i)});
      }
    };
    if (wkbFlatten(outline->getGeometryType()) == wkbPolygon)
      add_polygon(*outline->toPolygon());
    else
      for (const OGRGeometry* part : *outline->toGeometryCollection())
        if (wkbFlatten(part->getGeometryType()) == wkbPolygon) add_polygon(*part->toPolygon());
    RawModel& model = models_.emplace_back();
    model.source_id = source_id;
    for (const SurfaceGroup& group : opening_groups(object)) {
      if (group.is_door) add_door(object, group.corners);
      RawModelOpening& opening = model.openings.emplace_back();
      opening.is_door = group.is_door;
      for (const ModelCorner& p : group.corners) opening.corners.push_back({{p.y, p.x}, p.z - parts.foot});
    }
    for (const ModelSurface& surface : object.surfaces) {
      if (surface.image.empty() || std::abs(unit_normal(surface).z) > kLeastUpward) continue;
      RawModelPhoto& photo = model.photos.emplace_back();
      photo.image = surface.image;
      for (const ModelCorner& p : surface.rings[0]) {
        photo.corners.push_back({{p.y, p.x}, p.z - parts.foot});
        photo.places.push_back({p.u, p.v});
      }
    }
    for (const ModelSurface* surface : parts.up) {
      RawModelFace& face = model.tops.emplace_back();
      for (const auto& ring : surface->rings) {
        auto& line = face.emplace_back();
        for (const ModelCorner& p : ring) line.push_back({{p.y, p.x}, p.z - parts.foot});
      }
    }
  }

  /// Degrees for all, and over into the map.
  void finish(const CoordinateSystem& system, Stretch stretch) {
    std::vector<double> x, y;
    visit([&](LatLon& p) { x.push_back(p.lon_deg / stretch.x), y.push_back(p.lat_deg / stretch.y); });
    degrees_.transform(x, y);
    std::size_t i = 0, off = 0;
    visit([&](LatLon& p) {
      p = {y[i], x[i]};
      ++i;
      if (!(p.lat_deg >= -90 && p.lat_deg <= 90 && std::abs(p.lon_deg) <= 360)) ++off;
    });
    if (2 * off > i)
      throw CityError(file_ + ": most positions lie outside of where its coordinate system (" + system.name +
                          ") is defined; is it the right one?",
                      4);
    drop_common_colours();
    for (auto& feature : features_) map_.features.push_back(std::move(feature));
    for (auto& model : models_) map_.models.push_back(std::move(model));
  }

  void unusable(const ModelObject& object, const std::string& why) {
    map_.issues.push_back({IssueCode::unreadable_feature,
                           "This house cannot be used: " + why + "; left out.",
                           file_ + "#" + object.id,
                           {},
                           false});
  }

 private:
  template <class Visit>
  void visit(Visit visit_one) {
    for (auto& feature : features_)
      for (auto& line : feature.lines)
        for (auto& p : line) visit_one(p);
    for (auto& model : models_)
      for (auto& face : model.tops)
        for (auto& ring : face)
          for (auto& p : ring) visit_one(p.at);
    for (auto& model : models_) {
      for (auto& opening : model.openings)
        for (auto& p : opening.corners) visit_one(p.at);
      for (auto& photo : model.photos)
        for (auto& p : photo.corners) visit_one(p.at);
    }
  }

  /// A colour that all of many houses have tells walls from roofs, not house from house.
  void drop_common_colours() {
    constexpr std::size_t kMany = 20;
    for (const char* key : {"building:colour", "roof:colour"}) {
      std::set<std::string> colours;
      std::size_t count = 0;
      for (const RawFeature& feature : features_)
        if (const auto at = feature.tags.find(key); at != feature.tags.end()) colours.insert(at->second), ++count;
      if (colours.size() != 1 || count < kMany) continue;
      for (RawFeature& feature : features_) feature.tags.erase(key);
    }
  }

  /// In the middle of all that the door is made of: leaves, frames, panes.
  void add_door(const ModelObject& object, const std::vector<ModelCorner>& corners) {
    double west = HUGE_VAL, south = HUGE_VAL, east = -HUGE_VAL, north = -HUGE_VAL;
    for (const ModelCorner& p : corners) {
      west = std::min(west, p.x), east = std::max(east, p.x);
      south = std::min(south, p.y), north = std::max(north, p.y);
    }
    RawFeature& feature = features_.emplace_back();
    feature.theme = Theme::object;
    feature.source_id = file_ + "#" + object.id;
    feature.tags = {{"entrance", "yes"}};
    feature.lines = {{{(south + north) / 2, (west + east) / 2}}};
  }

  DegreesOf& degrees_;
  std::string file_;
  RawMap& map_;
  std::vector<RawFeature> features_;
  std::vector<RawModel> models_;
};

GzFile opened(const fs::path& path) { return GzFile(gzopen(path.c_str(), "rb"), gzclose); }

/// Rings of fewer than three corners and positions that are no numbers go; a repeated last corner, too.
void clean(ModelObject& object) {
  for (auto& surface : object.surfaces) {
    for (auto& ring : surface.rings) {
      const auto is_same = [](const ModelCorner& a, const ModelCorner& b) {
        return a.x == b.x && a.y == b.y && a.z == b.z;
      };
      ring.erase(std::unique(ring.begin(), ring.end(), is_same), ring.end());
      while (ring.size() > 1 && is_same(ring.front(), ring.back())) ring.pop_back();
      const bool is_finite = std::all_of(ring.begin(), ring.end(), [](const ModelCorner& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
      });
      if (ring.size() < 3 || !is_finite) ring.clear();
    }
    if (surface.rings.empty() || surface.rings[0].empty()) surface.rings.clear();
    std::erase_if(surface.rings, [](const auto& ring) { return ring.empty(); });
  }
  std::erase_if(object.surfaces, [](const ModelSurface& surface) { return surface.rings.empty(); });
}

}  // namespace

int epsg_code(const std::string& system) {
  std::size_t at = system.find("EPSG");
  if (at == std::string::npos) at = system.find("epsg");
  if (at == std::string::npos) return 0;
  // Versions such as 6.12 stand before the code: codes have four digits and more.
  for (at += 4; at < system.size();) {
    if (std::isdigit(static_cast<unsigned char>(system[at])) == 0) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < system.size() && std::isdigit(static_cast<unsigned char>(system[end])) != 0) ++end;
    if (end - at >= 4 && end - at <= 9) return std::stoi(system.substr(at, end - at));
    at = end;
  }
  return 0;
}

std::string file_beginning(const fs::path& path) {
  const GzFile file = opened(path);
  std::string text(4096, '\0');
  const int got = file ? gzread(file.get(), text.data(), static_cast<unsigned>(text.size())) : 0;
  text.resize(static_cast<std::size_t>(std::max(got, 0)));
  return text;
}

std::string file_text(const fs::path& path) {
  const GzFile file = opened(path);
  if (!file) throw CityError(path.string() + ": cannot be opened: " + std::strerror(errno), 4);
  constexpr unsigned kChunk = 1 << 20;
  std::string text;
  for (;;) {
    const std::size_t size = text.size();
    if (size > kMostBytes) throw CityError(path.string() + ": larger than 2 GB; cut it into several files", 4);
    text.resize(size + kChunk);
    const int got = gzread(file.get(), text.data() + size, kChunk);
    int code = Z_OK;
    const char* message = gzerror(file.get(), &code);
    if (got < 0 || code == Z_BUF_ERROR || code == Z_DATA_ERROR)
      throw CityError(path.string() + ": broken or cut off: " + message, 4);
    text.resize(size + static_cast<std::size_t>(got));
    if (got == 0) return text;
  }
}

void add_city_model(const fs::path& file, CityModel model, RawMap& map) {
  const QuietGdal quiet;
  const int code = epsg_code(model.system);
  OGRSpatialReference declared;
  if (model.system.empty())
    throw CityError(file.string() + ": names no coordinate system; give it by --crs, such as --crs EPSG:28992", 4);
  if (code == 0 || declared.importFromEPSG(code) != OGRERR_NONE)
    throw CityError(file.string() + ": its coordinate system (" + model.system +
                        ") is not known here: expected an EPSG code; give it by --crs",
                    4);
  if (declared.IsCompound()) declared.StripVertical();
  // Normals and areas need metres: degrees are stretched to about that, and back before they are transformed.
  const Stretch stretch = declared.IsGeographic() ? stretch_at(model) : Stretch{};
  DegreesOf degrees(&declared);
  if (!degrees.system().is_declared || degrees.is_unusable())
    throw CityError(file.string() + ": its coordinate system (" + model.system + ") cannot be transformed to WGS84", 4);
  const bool is_lat_first = declared.IsGeographic();
  ModelAdder adder(degrees, file.filename().string(), map);
  for (ModelObject& object : model.objects) {
    clean(object);
    if (is_lat_first)
      for (auto& surface : object.surfaces)
        for (auto& ring : surface.rings)
          for (auto& p : ring) p = {p.y * stretch.x, p.x * stretch.y, p.z, p.u, p.v};
    if (object.surfaces.empty())
      adder.unusable(object, "it has no surfaces");
    else
      adder.add(object);
  }
  if (model.objects.empty()) throw CityError(file.string() + ": expected houses, found none", 4);
  adder.finish(degrees.system(), stretch);
  for (auto& issue : model.issues) map.issues.push_back(std::move(issue));
  map.licences.push_back(model.licence.empty() ? unstated_licence(file) : model.licence);
}

}  // namespace vicus
