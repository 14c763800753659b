#include "sectorgen/geo/read_citygml.hpp"

#include <expat.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string_view>
#include <unordered_map>

#include "sectorgen/geo/city_model.hpp"
#include "sectorgen/geo/gml_appearance.hpp"
#include "sectorgen/geo/number_list.hpp"

namespace vicus {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepest = 512;  // elements in elements
constexpr int kRefined = 3;            // the finest level that is used

/// Names are told apart by their local part: prefixes and namespaces differ between CityGML's versions.
std::string_view local(std::string_view name) { return name.substr(name.find(':') + 1); }

std::string trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const auto begin = text.find_first_not_of(kSpace);
  return begin == std::string_view::npos ? ""
                                         : std::string(text.substr(begin, text.find_last_not_of(kSpace) - begin + 1));
}

ModelPart part_of(std::string_view element) {
  if (element == "RoofSurface") return ModelPart::roof;
  if (element == "GroundSurface") return ModelPart::ground;
  if (element == "WallSurface") return ModelPart::wall;
  if (element == "Window" || element == "WindowSurface") return ModelPart::window;
  return element == "Door" || element == "DoorSurface" ? ModelPart::door : ModelPart::other;
}
bool is_part(std::string_view element) {
  return element == "Door" || element == "Window" ||
         (element.size() > 7 && element.ends_with("Surface") && element != "MultiSurface" &&
          element != "CompositeSurface" && !element.ends_with("MultiSurface"));
}

/// Geometry of many surfaces, which another place may refer to as a whole.
bool is_whole(std::string_view element) {
  return element == "MultiSurface" || element == "CompositeSurface" || element == "Shell" || element == "Solid" ||
         element == "MultiSolid" || element == "CompositeSolid";
}

/// The parser's events, into a CityModel.
class GmlEvents {
 public:
  explicit GmlEvents(fs::path folder) : appearance_(std::move(folder)) {}

  CityModel model;
  std::string problem;  // of the file as a whole

  void start(std::string_view element, const char** attributes) {
    if (open_.size() >= kDeepest) problem = "elements in more than 512 others";
    open_.emplace_back(element);
    text_.clear();
    const auto attribute = [&](std::string_view name) -> std::string {
      for (const char** a = attributes; *a; a += 2)
        if (local(*a) == name) return a[1];
      return "";
    };
    if (model.system.empty()) model.system = attribute("srsName");
    if (element == "Building" || element == "BuildingPart" || element == "BuildingUnit") {
      houses_.emplace_back();
      houses_.back().object.id = attribute("id");
      if (houses_.back().object.id.empty()) houses_.back().object.id = "house-" + std::to_string(++unnamed_);
      if (houses_.size() > 1) houses_.back().object.attributes = houses_[houses_.size() - 2].object.attributes;
      houses_.back().depth = open_.size();
      houses_.back().number = done_.size();
      done_.emplace_back();
    }
    if (element.starts_with("lod") && element.size() > 3 && std::isdigit(static_cast<unsigned char>(element[3])) != 0)
      lods_.emplace_back(open_.size(), element[3] - '0');
    if (is_part(element)) parts_.push_back({open_.size(), part_of(element), ++elements_});
    if (element == "Polygon" || element == "Triangle" || element == "Rectangle")
      surface_ = {}, surface_id_ = attribute("id"), outer_id_.clear();
    if (element == "LinearRing") numbers_.clear(), ring_id_ = attribute("id");
    if (is_whole(element)) wholes_.emplace_back(open_.size(), attribute("id"));
    if (const std::string link = attribute("href"); link.size() > 1 && link[0] == '#' && is_in_use())
      links_.push_back({houses_.back().number, lods_.back().second, part(), link.substr(1)});
    appearance_.start(element, attribute);
  }

  void text(std::string_view piece) {
    if (text_.size() + piece.size() <= (std::size_t{1} << 26)) text_ += piece;
  }

  void end(std::string_view element) {
    if (element == "posList" || element == "pos" || element == "coordinates") {
      if (!append_numbers(text_, numbers_)) fault("a position that is no number");
    } else if (element == "LinearRing") {
      end_ring();
    } else if (element == "Polygon" || element == "Triangle" || element == "Rectangle") {
      end_surface();
    } else if (!appearance_.end(element, trimmed(text_)) && !houses_.empty()) {
      attribute(element);
    }
    if (!wholes_.empty() && wholes_.back().first == open_.size()) wholes_.pop_back();
    if (!lods_.empty() && lods_.back().first == open_.size()) lods_.pop_back();
    if (!parts_.empty() && parts_.back().depth == open_.size()) parts_.pop_back();
    if (!houses_.empty() && houses_.back().depth == open_.size()) end_house();
    open_.pop_back();
    text_.clear();
  }

  /// What needs the whole file: links, materials and images, which stand before or behind what they mean.
  void finish() {
    paint();
    for (const Link& link : links_) follow(link);
    for (House& house : done_) {
      if (!house.fault.empty() || house.missing > 0)
        model.issues.push_back({IssueCode::unreadable_feature,
                                !house.fault.empty() ? "This house cannot be read: " + house.fault + "; left out."
                                                     : "This house refers to " + std::to_string(house.missing) +
                                                           " surfaces that its file does not have; used without them.",
                                house.object.id,
                                {},
                                false});
      if (!house.fault.empty() || house.by_lod.empty()) continue;
      house.object.surfaces = std::move(house.by_lod.rbegin()->second);
      model.objects.push_back(std::move(house.object));
    }
  }

 private:
  struct Part {
    std::size_t depth = 0;
    ModelPart part = ModelPart::other;
    std::size_t element = 0;
  };
  struct House {
    ModelObject object;
    std::size_t depth = 0;
    std::size_t number = 0;  // in done_
    std::map<int, std::vector<ModelSurface>> by_lod;
    std::string fault;
    std::size_t missing = 0;  // surfaces referred to
  };
  /// Where a surface stands that has been read.
  struct Place {
    std::size_t house = 0;
    int lod = 0;
    std::size_t surface = 0;
  };
  /// xlink:href: surfaces of the name belong here, too.
  struct Link {
    std::size_t house = 0;
    int lod = 0;
    Part part;
    std::string name;
  };

  bool is_in_use() const { return !houses_.empty() && !lods_.empty() && lods_.back().second <= kRefined; }
  Part part() const { return parts_.empty() ? Part{} : parts_.back(); }

  void fault(const std::string& what) {
    if (!houses_.empty() && houses_.back().fault.empty()) houses_.back().fault = what;
  }

  void end_ring() {
    if (numbers_.size() % 3 != 0) return fault("positions without height");
    auto& ring = surface_.rings.emplace_back();
    if (surface_.rings.size() == 1) outer_id_ = ring_id_;
    for (std::size_t i = 0; i + 2 < numbers_.size(); i += 3)
      ring.push_back({numbers_[i], numbers_[i + 1], numbers_[i + 2]});
  }

  void end_surface() {
    if (!is_in_use()) return;
    surface_.part = part().part;
    surface_.element = part().element;
    auto& list = houses_.back().by_lod[lods_.back().second];
    const Place place{houses_.back().number, lods_.back().second, list.size()};
    if (!surface_id_.empty()) places_[surface_id_].push_back(place);
    for (const auto& [depth, name] : wholes_)
      if (!name.empty()) places_[name].push_back(place);
    if (!outer_id_.empty()) rings_[outer_id_] = place;
    list.push_back(std::move(surface_));
    surface_ = {};
  }

  void paint() {
    for (const auto& [name, colour] : appearance_.colours())
      if (const auto at = places_.find(name); at != places_.end())
        for (const Place& place : at->second) surface_at(place).colour = colour;
    for (const auto& [name, image] : appearance_.images()) {
      const auto at = rings_.find(name);
      if (at == rings_.end()) continue;
      ModelSurface& surface = surface_at(at->second);
      auto& ring = surface.rings[0];
      if (ring.size() != image.places.size()) continue;
      surface.image = image.file;
      for (std::size_t i = 0; i < ring.size(); ++i) ring[i].u = image.places[i][0], ring[i].v = image.places[i][1];
    }
  }

  ModelSurface& surface_at(const Place& place) { return done_[place.house].by_lod[place.lod][place.surface]; }

  /// A surface of the same house and level only gets the meaning of where it is referred to; others are copied.
  void follow(const Link& link) {
    House& house = done_[link.house];
    const auto found = places_.find(link.name);
    if (found == places_.end()) {
      ++house.missing;
      return;
    }
    for (const Place& place : found->second) {
      ModelSurface* surface = &surface_at(place);
      if (place.house != link.house || place.lod != link.lod) {
        auto& list = house.by_lod[link.lod];
        const ModelSurface copy = *surface;
        list.push_back(copy);
        surface = &list.back();
      }
      if (link.part.part == ModelPart::other) continue;
      surface->part = link.part.part;
      surface->element = link.part.element;
    }
  }

  /// Attributes stand right in their house, addresses somewhere below it.
  void attribute(std::string_view element) {
    auto& tags = houses_.back().object.attributes;
    const bool is_own = open_.size() == houses_.back().depth + 1;
    if (is_own && (element == "measuredHeight" || element == "roofType" || element == "storeysAboveGround" ||
                   element == "function" || element == "yearOfConstruction" || element == "name"))
      tags[std::string(element)] = trimmed(text_);
    if (element == "ThoroughfareName") tags["street"] = trimmed(text_);
    if (element == "ThoroughfareNumber") tags["houseNumber"] = trimmed(text_);
  }

  void end_house() {
    const std::size_t number = houses_.back().number;
    done_[number] = std::move(houses_.back());
    houses_.pop_back();
  }

  std::vector<std::string> open_;
  std::vector<House> houses_;
  std::vector<std::pair<std::size_t, int>> lods_;  // depth, level
  std::vector<Part> parts_;
  std::vector<House> done_;  // by number
  std::vector<Link> links_;
  std::vector<std::pair<std::size_t, std::string>> wholes_;     // depth, gml:id
  std::unordered_map<std::string, std::vector<Place>> places_;  // by gml:id
  std::unordered_map<std::string, Place> rings_;                // of their outer rings, by gml:id
  GmlAppearance appearance_;
  ModelSurface surface_;
  std::string surface_id_, ring_id_, outer_id_;
  std::vector<double> numbers_;
  std::string text_;
  std::size_t elements_ = 0;
  int unnamed_ = 0;
};

void XMLCALL on_start(void* events, const char* name, const char** attributes) {
  static_cast<GmlEvents*>(events)->start(local(name), attributes);
}
void XMLCALL on_end(void* events, const char* name) { static_cast<GmlEvents*>(events)->end(local(name)); }
void XMLCALL on_text(void* events, const char* text, int size) {
  static_cast<GmlEvents*>(events)->text({text, static_cast<std::size_t>(size)});
}

}  // namespace

bool is_citygml_file(const fs::path& path) {
  const std::string name = path.filename().string();
  if (name.find(".gml") == std::string::npos && name.find(".xml") == std::string::npos &&
      name.find(".citygml") == std::string::npos)
    return false;
  return file_beginning(path).find("CityModel") != std::string::npos;
}

void read_citygml(const fs::path& path, const std::string& assumed_system, RawMap& map) {
  const std::string text = file_text(path);
  GmlEvents events(path.parent_path());
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
  XML_SetUserData(parser.get(), &events);
  XML_SetElementHandler(parser.get(), on_start, on_end);
  XML_SetCharacterDataHandler(parser.get(), on_text);
  constexpr std::size_t kPiece = 1 << 20;
  for (std::size_t at = 0; at < text.size(); at += kPiece) {
    const std::size_t size = std::min(kPiece, text.size() - at);
    if (XML_Parse(parser.get(), text.data() + at, static_cast<int>(size), at + size == text.size()) == XML_STATUS_ERROR)
      events.problem = XML_ErrorString(XML_GetErrorCode(parser.get()));
    if (!events.problem.empty())
      throw CityError(path.string() + ", line " + std::to_string(XML_GetCurrentLineNumber(parser.get())) +
                          ": expected CityGML: " + events.problem,
                      4);
  }
  events.finish();
  if (!assumed_system.empty() && events.model.system.empty()) events.model.system = assumed_system;
  add_city_model(path, std::move(events.model), map);
}

}  // namespace vicus
