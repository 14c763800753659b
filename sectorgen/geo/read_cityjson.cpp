#include "sectorgen/geo/read_cityjson.hpp"

#include <nlohmann/json.hpp>

#include <set>
#include <sstream>
#include <tuple>

#include "sectorgen/geo/city_model.hpp"
#include "sectorgen/geo/cityjson_appearance.hpp"
#include "sectorgen/geo/tag_values.hpp"

namespace vicus {
namespace {

namespace fs = std::filesystem;

/// A wrong shape of the file's own: told with the object's name.
struct ShapeError {
  std::string what;
};

/// Vertices with the transform that makes them coordinates.
class Vertices {
 public:
  Vertices(const Json& vertices, const Json& transform) : vertices_(vertices) {
    if (!vertices.is_array()) throw ShapeError{"no list of vertices"};
    if (transform.is_null()) return;
    for (std::size_t k = 0; k < 3; ++k) {
      scale_[k] = number(member(transform, "scale"), k);
      translate_[k] = number(member(transform, "translate"), k);
    }
  }

  ModelCorner at(const Json& index) const {
    if (!index.is_number_integer() || index.get<long long>() < 0 || index.get<unsigned long long>() >= vertices_.size())
      throw ShapeError{"a corner that is none of the " + std::to_string(vertices_.size()) + " vertices"};
    const Json& v = vertices_[index.get<std::size_t>()];
    return {number(v, 0) * scale_[0] + translate_[0], number(v, 1) * scale_[1] + translate_[1],
            number(v, 2) * scale_[2] + translate_[2]};
  }

 private:
  static double number(const Json& list, std::size_t k) {
    if (!list.is_array() || k >= list.size() || !list[k].is_number()) throw ShapeError{"three numbers expected"};
    return list[k].get<double>();
  }
  const Json& vertices_;
  double scale_[3] = {1, 1, 1}, translate_[3] = {0, 0, 0};
};

ModelPart part_of(const std::string& semantics) {
  if (semantics == "RoofSurface") return ModelPart::roof;
  if (semantics == "GroundSurface") return ModelPart::ground;
  if (semantics == "WallSurface") return ModelPart::wall;
  if (semantics == "Window") return ModelPart::window;
  return semantics == "Door" ? ModelPart::door : ModelPart::other;
}

/// How deep surfaces lie in the boundaries of a geometry; -1: no surfaces.
int depth_of(const std::string& type) {
  if (type == "MultiSurface" || type == "CompositeSurface") return 0;
  if (type == "Solid") return 1;
  return type == "MultiSolid" || type == "CompositeSolid" ? 2 : -1;
}

class ObjectReader {
 public:
  ObjectReader(const Vertices& vertices, const CityjsonAppearance& appearance, std::vector<ModelSurface>& surfaces)
      : vertices_(vertices), appearance_(appearance), surfaces_(surfaces) {}

  void read(const Json& geometry) {
    kinds_ = &member(member(geometry, "semantics"), "surfaces");
    descend(member(geometry, "boundaries"),
            {member(member(geometry, "semantics"), "values"), appearance_.material_values(geometry),
             appearance_.texture_values(geometry)},
            depth_of(text_of(member(geometry, "type"))));
  }

 private:
  /// What lies beside the boundaries in lists of the same depth.
  struct Values {
    const Json &kind, &material, &texture;
    Values at(std::size_t i) const {
      return {entry(kind, i), material.is_number() ? material : entry(material, i), entry(texture, i)};
    }
  };

  void descend(const Json& boundaries, const Values& values, int depth) {
    if (!boundaries.is_array()) throw ShapeError{"boundaries that are no list"};
    for (std::size_t i = 0; i < boundaries.size(); ++i)
      if (depth > 0)
        descend(boundaries[i], values.at(i), depth - 1);
      else
        add(boundaries[i], values.at(i));
  }

  void add(const Json& rings, const Values& values) {
    if (!rings.is_array()) throw ShapeError{"a surface that is no list of rings"};
    ModelSurface surface;
    const Json& kind = values.kind;
    if (kind.is_number_unsigned() && kinds_->is_array() && kind.get<std::size_t>() < kinds_->size()) {
      surface.element = kind.get<std::size_t>();
      surface.part = part_of(text_of(member((*kinds_)[surface.element], "type")));
    }
    for (const Json& ring : rings) {
      if (!ring.is_array()) throw ShapeError{"a ring that is no list of vertices"};
      auto& corners = surface.rings.emplace_back();
      for (const Json& index : ring) corners.push_back(vertices_.at(index));
    }
    surface.colour = appearance_.colour(values.material);
    appearance_.put_image(values.texture, surface);
    surfaces_.push_back(std::move(surface));
  }

  const Vertices& vertices_;
  const CityjsonAppearance& appearance_;
  std::vector<ModelSurface>& surfaces_;
  const Json* kinds_ = nullptr;
};

/// The finest up to 3: what is inside a house (4) is no concern of its street.
const Json* finest(const Json& geometries) {
  const Json* best = nullptr;
  double most = -1;
  if (geometries.is_array())
    for (const Json& geometry : geometries) {
      const double lod = parse_number(text_of(member(geometry, "lod"))).value_or(0);
      if (depth_of(text_of(member(geometry, "type"))) >= 0 && lod < 4 && lod > most) best = &geometry, most = lod;
    }
  return best;
}

Tags attributes_of(const Json& object) {
  Tags tags;
  if (const Json& attributes = member(object, "attributes"); attributes.is_object())
    for (const auto& [key, value] : attributes.items())
      if (std::string text = text_of(value); !text.empty()) tags[key] = std::move(text);
  const Json& address = member(object, "address");  // a list since 1.1, one object before
  const Json& first = address.is_array() && !address.empty() ? address[0] : address;
  for (const auto& [from, to] : {std::pair("ThoroughfareName", "street"),
                                 {"thoroughfareName", "street"},
                                 {"ThoroughfareNumber", "houseNumber"},
                                 {"thoroughfareNumber", "houseNumber"}})
    if (std::string text = text_of(member(first, from)); !text.empty()) tags[to] = std::move(text);
  return tags;
}

bool is_house(const Json& object) {
  const std::string type = text_of(member(object, "type"));
  return type == "Building" || type == "BuildingPart" || type == "BuildingUnit";
}

/// What a part does not say of itself its building does.
void inherit(const Json& objects, const std::string& id, const Json& object, Tags& tags) {
  const auto add = [&](const Json& parent) {
    for (auto& [key, value] : attributes_of(parent)) tags.emplace(key, value);
  };
  if (const Json& parents = member(object, "parents"); parents.is_array() && !parents.empty())
    return add(member(objects, text_of(parents[0]).c_str()));
  // 0.8: only the building names its parts, ID_1, ID_2, ... as a rule.
  if (text_of(member(object, "type")) == "BuildingPart")
    if (const auto cut = id.rfind('_'); cut != std::string::npos) add(member(objects, id.substr(0, cut).c_str()));
}

void read_objects(const Json& json, const Json& transform, const CityjsonAppearance& appearance, CityModel& model) {
  const Json& objects = member(json, "CityObjects");
  if (!objects.is_object()) throw ShapeError{"no CityObjects"};
  const Vertices vertices(member(json, "vertices"), transform);
  for (const auto& [id, object] : objects.items()) {
    if (!is_house(object)) continue;
    const Json* geometry = finest(member(object, "geometry"));
    if (!geometry) continue;
    ModelObject out;
    out.id = id;
    try {
      ObjectReader(vertices, appearance, out.surfaces).read(*geometry);
    } catch (const ShapeError& error) {
      model.issues.push_back(
          {IssueCode::unreadable_feature, "This house cannot be read: " + error.what + "; left out.", id, {}, false});
      continue;
    }
    out.attributes = attributes_of(object);
    inherit(objects, id, object, out.attributes);
    model.objects.push_back(std::move(out));
  }
}

std::string system_of(const Json& json) {
  const Json& metadata = member(json, "metadata");
  if (std::string system = text_of(member(metadata, "referenceSystem")); !system.empty()) return system;
  const std::string code = text_of(member(member(metadata, "crs"), "epsg"));  // before 1.0
  return code.empty() ? "" : "EPSG:" + code;
}

}  // namespace

bool is_cityjson_file(const fs::path& path) {
  const std::string name = path.filename().string();
  if (name.find(".json") == std::string::npos && name.find(".jsonl") == std::string::npos) return false;
  if (name.find(".city.json") != std::string::npos) return true;
  const std::string text = file_beginning(path);
  return text.find("\"CityJSON\"") != std::string::npos || text.find("\"CityObjects\"") != std::string::npos;
}

void read_cityjson(const fs::path& path, const std::string& assumed_system, RawMap& map) {
  const std::string text = file_text(path);
  CityModel model;
  Json transform;
  const auto read = [&](const Json& json) {
    if (const Json& own = member(json, "transform"); !own.is_null()) transform = own;
    if (model.system.empty()) model.system = system_of(json);
    const CityjsonAppearance appearance(member(json, "appearance"), path.parent_path());
    if (!member(json, "CityObjects").is_null()) read_objects(json, transform, appearance, model);
  };
  try {
    const Json whole = Json::parse(text, nullptr, false);
    const bool is_sequence = whole.is_discarded() && Json::accept(text.substr(0, text.find('\n')));
    if (whole.is_discarded() && !is_sequence) std::ignore = Json::parse(text);  // says what is wrong
    if (!is_sequence) {
      read(whole);
    } else {
      std::istringstream lines(text);
      std::size_t number = 0;
      for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        const Json json = Json::parse(line, nullptr, false);
        if (json.is_discarded())
          throw CityError(path.string() + ", line " + std::to_string(number) + ": is no JSON; cut off?", 4);
        read(json);
      }
    }
  } catch (const ShapeError& error) {
    throw CityError(path.string() + ": expected CityJSON: " + error.what, 4);
  } catch (const Json::exception& error) {
    throw CityError(path.string() + ": expected CityJSON: " + error.what(), 4);
  }
  if (!assumed_system.empty() && model.system.empty()) model.system = assumed_system;
  add_city_model(path, std::move(model), map);
}

}  // namespace vicus
