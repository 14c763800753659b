#include "sectorgen/geo/map_name.hpp"

#include <set>

#include "sectorgen/geo/tag_values.hpp"

namespace vicus {
namespace {

using Names = std::set<std::string>;

template <class Wanted>
Names names_of(const RawMap& map, const Wanted& is_wanted) {
  Names names;
  for (const RawFeature& feature : map.features)
    if (is_wanted(feature) && has_tag(feature.tags, "name")) names.insert(tag(feature.tags, "name"));
  return names;
}

}  // namespace

std::string name_in_map(const RawMap& map) {
  const auto bounds = names_of(map, [](const RawFeature& f) { return f.theme == Theme::boundary; });
  if (bounds.size() == 1) return *bounds.begin();
  for (const char* kind : {"city", "town", "borough", "suburb", "village", "quarter", "hamlet", "neighbourhood"}) {
    const auto places =
        names_of(map, [&](const RawFeature& f) { return f.theme == Theme::object && tag(f.tags, "place") == kind; });
    if (!places.empty()) return places.size() == 1 ? *places.begin() : "";
  }
  return "";
}

std::string name_from_file(const std::filesystem::path& file) {
  // Files named by what is in them, not by the place.
  static const Names kLayers{"buildings", "building", "footprints", "houses", "streets", "roads",   "highways",
                             "water",     "map",      "osm",        "export", "data",    "extract", "layers"};
  std::string name = file.filename().string();
  if (const auto dot = name.find('.', 1); dot != std::string::npos) name.resize(dot);
  const std::string folder = file.parent_path().filename().string();
  if (kLayers.contains(lower_case(name)) && !folder.empty() && folder != "." && folder != "..") name = folder;
  bool begins = true;
  for (char& c : name) {
    if (c == '-' || c == '_' || c == ' ') {
      c = ' ';
      begins = true;
      continue;
    }
    if (begins && c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    begins = false;
  }
  return name;
}

}  // namespace vicus
