#include "sectorgen/geo/read_gdal.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <memory>

#include "sectorgen/geo/gdal_degrees.hpp"
#include "sectorgen/geo/quiet_gdal.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {

namespace {

namespace fs = std::filesystem;

// Points per call of PROJ: its set-up is spread over many, the memory stays small.
constexpr std::size_t kBatchPoints = 1 << 17;

std::string gdal_name(const fs::path& path) {
  if (path.extension() == ".gz") return "/vsigzip/" + path.string();
  if (path.extension() == ".zip") return "/vsizip/" + path.string();
  return path.string();
}

GDALDatasetUniquePtr open_dataset(const fs::path& path) {
  GDALDatasetUniquePtr dataset(GDALDataset::Open(gdal_name(path).c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (dataset) return dataset;
  const std::string reason = CPLGetLastErrorMsg();
  throw CityError(path.string() + ": expected a map (OSM, GeoPackage, GeoJSON, Shapefile, FlatGeobuf): " +
                      (reason.empty() ? "its format is unknown" : reason),
                  4);
}

bool is_kind(OGRwkbGeometryType type, OGRwkbGeometryType kind) {
  return OGR_GT_IsSubClassOf(wkbFlatten(type), kind) || wkbFlatten(type) == wkbUnknown ||
         wkbFlatten(type) == wkbGeometryCollection;
}

LayerFacts facts_of(const fs::path& path, OGRLayer& layer) {
  const OGRwkbGeometryType type = layer.GetGeomType();
  LayerFacts facts{path, layer.GetName(), false, false, {}};
  facts.may_have_polygons = is_kind(type, wkbCurvePolygon) || is_kind(type, wkbMultiSurface);
  facts.may_have_lines = is_kind(type, wkbCurve) || is_kind(type, wkbMultiCurve);
  OGRFeatureDefn& fields = *layer.GetLayerDefn();
  for (int i = 0; i < fields.GetFieldCount(); ++i) facts.attributes.push_back(fields.GetFieldDefn(i)->GetNameRef());
  return facts;
}

/// Geometries of a batch of features, flattened so that PROJ gets one array.
class Batch {
 public:
  Batch(FeatureAdder& adder, DegreesOf& degrees) : adder_(adder), degrees_(degrees) {}

  void begin(long long fid, Tags attributes) { features_.push_back({fid, std::move(attributes), {}, ""}); }

  void add(const OGRGeometry& geometry) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part);
    } else if (type == wkbPolygon) {
      Part part{Kind::polygon, {}};
      for (const OGRLinearRing* ring : *geometry.toPolygon()) part.sizes.push_back(append(*ring));
      features_.back().parts.push_back(std::move(part));
    } else if (type == wkbLineString) {
      features_.back().parts.push_back({Kind::line, {append(*geometry.toLineString())}});
    } else if (type == wkbPoint) {
      if (geometry.IsEmpty()) return;
      x_.push_back(geometry.toPoint()->getX());
      y_.push_back(geometry.toPoint()->getY());
      features_.back().parts.push_back({Kind::point, {1}});
    } else if (OGR_GT_IsNonLinear(type)) {
      const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
      if (straight && !OGR_GT_IsNonLinear(straight->getGeometryType())) add(*straight);
    } else {
      features_.back().problem = std::string("its geometry cannot be used: ") + geometry.getGeometryName();
    }
  }

  void flush_if_large() {
    if (x_.size() >= kBatchPoints) flush();
  }

  void flush() {
    degrees_.transform(x_, y_);
    std::size_t at = 0;
    for (Feature& feature : features_) {
      if (!feature.problem.empty()) adder_.unreadable(feature.fid, feature.problem);
      adder_.begin(feature.fid, std::move(feature.attributes));
      for (const Part& part : feature.parts) {
        std::vector<std::vector<LatLon>> lines;
        for (std::size_t size : part.sizes) {
          lines.emplace_back();
          for (; size > 0; --size, ++at) lines.back().push_back({y_[at], x_[at]});
        }
        if (part.kind == Kind::polygon) adder_.polygon(std::move(lines));
        if (part.kind == Kind::line) adder_.line(std::move(lines[0]));
        if (part.kind == Kind::point) adder_.point(lines[0][0]);
      }
    }
    features_.clear();
    x_.clear();
    y_.clear();
  }

 private:
  enum class Kind { polygon, line, point };
  struct Part {
    Kind kind;
    std::vector<std::size_t> sizes;  // points of each ring or line
  };
  struct Feature {
    long long fid;
    Tags attributes;
    std::vector<Part> parts;
    std::string problem;
  };

  std::size_t append(const OGRSimpleCurve& line) {
    for (int i = 0; i < line.getNumPoints(); ++i) {
      x_.push_back(line.getX(i));
      y_.push_back(line.getY(i));
    }
    return static_cast<std::size_t>(line.getNumPoints());
  }

  FeatureAdder& adder_;
  DegreesOf& degrees_;
  std::vector<Feature> features_;
  std::vector<double> x_, y_;
};

Tags attributes_of(const OGRFeature& feature) {
  Tags attributes;
  for (int i = 0; i < feature.GetFieldCount(); ++i)
    if (feature.IsFieldSetAndNotNull(i))
      attributes.emplace(feature.GetFieldDefnRef(i)->GetNameRef(), feature.GetFieldAsString(i));
  return attributes;
}

void read_layer(OGRLayer& layer, const LayerChoice& choice, RawMap& map, std::string& licence) {
  DegreesOf degrees(layer.GetSpatialRef());
  if (degrees.is_unusable())
    throw CityError(choice.layer.file.string() + ", layer " + choice.layer.name + ": its coordinate system (" +
                        degrees.system().name + ") cannot be transformed to WGS84: " + CPLGetLastErrorMsg(),
                    4);
  FeatureAdder adder(choice, map, degrees.system());
  Batch batch(adder, degrees);
  for (const auto& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (!geometry) {
      adder.unreadable(feature->GetFID(), "it has no geometry");
      continue;
    }
    batch.begin(feature->GetFID(), attributes_of(*feature));
    batch.add(*geometry);
    batch.flush_if_large();
  }
  batch.flush();
  adder.finish();
  if (adder.is_from_osm()) licence = kOsmLicence;
}

/// What the file says about its licence, in whichever of the usual places.
std::string stated_licence(GDALDataset& dataset, OGRLayer& layer) {
  for (const char* key : {"LICENSE", "LICENCE", "license", "licence", "ATTRIBUTION", "attribution", "COPYRIGHT",
                          "copyright", "DESCRIPTION", "IDENTIFIER"})
    for (const char* value : {layer.GetMetadataItem(key), dataset.GetMetadataItem(key)}) {
      if (!value || !*value) continue;
      const bool is_free_text = std::string_view(key) == "DESCRIPTION" || std::string_view(key) == "IDENTIFIER";
      for (const char* word : {"licen", "copyright", "©", "odbl", "cc-by", "cc0"})
        if (!is_free_text || contains_word_part(value, word)) return value;
    }
  return "";
}

}  // namespace

std::vector<LayerFacts> gdal_facts(const fs::path& path) {
  const QuietGdal quiet;
  const auto dataset = open_dataset(path);
  std::vector<LayerFacts> facts;
  for (OGRLayer* layer : dataset->GetLayers())
    if (layer->GetGeomType() != wkbNone) facts.push_back(facts_of(path, *layer));
  if (facts.empty()) throw CityError(path.string() + ": expected layers with geometry, found none", 4);
  return facts;
}

void read_gdal(const LayerChoice& choice, RawMap& map) {
  const QuietGdal quiet;
  const auto dataset = open_dataset(choice.layer.file);
  OGRLayer* layer = dataset->GetLayerByName(choice.layer.name.c_str());
  if (!layer) throw CityError(choice.layer.file.string() + ": no layer " + choice.layer.name, 4);
  if (choice.use == LayerUse::ignored) return;
  std::string licence = stated_licence(*dataset, *layer);
  const std::size_t before = map.features.size();
  read_layer(*layer, choice, map, licence);
  if (map.features.size() > before)
    map.licences.push_back(licence.empty() ? unstated_licence(choice.layer.file) : licence);
}

void read_gdal_boundary(const fs::path& path, RawMap& map) {
  RawMap polygons;
  for (const LayerFacts& facts : gdal_facts(path)) {
    const QuietGdal quiet;
    const auto dataset = open_dataset(path);
    std::string licence;
    // As plots every polygon is taken, whatever its attributes are.
    read_layer(*dataset->GetLayerByName(facts.name.c_str()), {facts, LayerUse::plots, true, true}, polygons, licence);
  }
  bool has_polygon = false;
  for (RawFeature& feature : polygons.features) {
    if (feature.theme != Theme::plot) continue;
    has_polygon = true;
    feature.theme = Theme::boundary;
    map.features.push_back(std::move(feature));
  }
  if (!has_polygon) throw CityError(path.string() + ": expected the city's boundary as a polygon, found none", 4);
  map.issues.insert(map.issues.end(), polygons.issues.begin(), polygons.issues.end());
}

}  // namespace vicus
