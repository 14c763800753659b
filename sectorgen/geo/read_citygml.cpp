#include "sectorgen/geo/read_citygml.hpp"

#include <expat.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <memory>
#include <string_view>

#include "sectorgen/geo/city_model.hpp"

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

/// The numbers of a posList; false: something that is none.
bool append_numbers(std::string_view text, std::vector<double>& out) {
  for (;;) {
    const auto begin = text.find_first_not_of(" \t\r\n,");
    if (begin == std::string_view::npos) return true;
    text.remove_prefix(begin);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data() + (text[0] == '+' ? 1 : 0), text.data() + text.size(), value);
    if (error != std::errc()) return false;
    out.push_back(value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

ModelPart part_of(std::string_view element) {
  if (element == "RoofSurface") return ModelPart::roof;
  if (element == "GroundSurface") return ModelPart::ground;
  if (element == "WallSurface") return ModelPart::wall;
  return element == "Door" || element == "DoorSurface" ? ModelPart::door : ModelPart::other;
}
bool is_part(std::string_view element) {
  return element == "Door" || element == "Window" ||
         (element.size() > 7 && element.ends_with("Surface") && element != "MultiSurface" &&
          element != "CompositeSurface" && !element.ends_with("MultiSurface"));
}

/// The parser's events, into a CityModel.
class GmlEvents {
 public:
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
    }
    if (element.starts_with("lod") && element.size() > 3 && std::isdigit(static_cast<unsigned char>(element[3])) != 0)
      lods_.emplace_back(open_.size(), element[3] - '0');
    if (is_part(element)) parts_.push_back({open_.size(), part_of(element), ++elements_});
    if (element == "Polygon" || element == "Triangle" || element == "Rectangle") surface_ = {};
    if (element == "LinearRing") numbers_.clear();
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
    } else if (!houses_.empty()) {
      attribute(element);
    }
    if (!lods_.empty() && lods_.back().first == open_.size()) lods_.pop_back();
    if (!parts_.empty() && parts_.back().depth == open_.size()) parts_.pop_back();
    if (!houses_.empty() && houses_.back().depth == open_.size()) end_house();
    open_.pop_back();
    text_.clear();
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
    std::map<int, std::vector<ModelSurface>> by_lod;
    std::string fault;
  };

  void fault(const std::string& what) {
    if (!houses_.empty() && houses_.back().fault.empty()) houses_.back().fault = what;
  }

  void end_ring() {
    if (numbers_.size() % 3 != 0) return fault("positions without height");
    auto& ring = surface_.rings.emplace_back();
    for (std::size_t i = 0; i + 2 < numbers_.size(); i += 3)
      ring.push_back({numbers_[i], numbers_[i + 1], numbers_[i + 2]});
  }

  void end_surface() {
    if (houses_.empty() || lods_.empty() || lods_.back().second > kRefined) return;
    if (!parts_.empty()) surface_.part = parts_.back().part, surface_.element = parts_.back().element;
    houses_.back().by_lod[lods_.back().second].push_back(std::move(surface_));
    surface_ = {};
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
    House house = std::move(houses_.back());
    houses_.pop_back();
    if (!house.fault.empty()) {
      model.issues.push_back({IssueCode::unreadable_feature,
                              "This house cannot be read: " + house.fault + "; left out.",
                              house.object.id,
                              {},
                              false});
      return;
    }
    if (house.by_lod.empty()) return;
    house.object.surfaces = std::move(house.by_lod.rbegin()->second);
    model.objects.push_back(std::move(house.object));
  }

  std::vector<std::string> open_;
  std::vector<House> houses_;
  std::vector<std::pair<std::size_t, int>> lods_;  // depth, level
  std::vector<Part> parts_;
  ModelSurface surface_;
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
  GmlEvents events;
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
  if (!assumed_system.empty() && events.model.system.empty()) events.model.system = assumed_system;
  add_city_model(path, std::move(events.model), map);
}

}  // namespace vicus
